/* The water's unit normals seen from above: x and z. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "water/surface.glsl"
out vec2 normal;

void main()
{
    normal = surface_normal((target - 0.5) * surface_size).xz;
}
#endif
