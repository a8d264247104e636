/* The water's unit normals seen from above. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "water/surface.glsl"
out vec4 normal;

void main()
{
    normal = vec4(surface_normal((target - 0.5) * surface_size), 0.0);
}
#endif
