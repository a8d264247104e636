/* The GPU's half of pixel_ray.c. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "light/vertical_ray.glsl"
out float map;

void main()
{
    vec2 xz = square.xy + target * square.z;
    map = in_water(xz) == xz ? brightness_at(xz) : 0.0;
}
#endif
