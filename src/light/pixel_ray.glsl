/* The GPU's half of pixel_ray.c; and of vertex_ray.c its vertices. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "light/vertical_ray.glsl"
out float map;

void main()
{
    map = brightness_at(target);
}
#endif
