/* The GPU's half of vertex_ray.c: its vertices, a texel each. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "light/vertical_ray.glsl"
out float brightness;

void main()
{
    brightness = brightness_at(square.xy + target * square.z);
}
#endif
