/* A small picture: the water's normals as x z y in red green blue, or the caustic map. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "light/map.glsl"
#include "water/surface.glsl"
uniform int subject;
out vec4 color;

void main()
{
    vec3 shown = 1.0 - exp(-light_at(target)); /* light has no upper end */
    if (subject == 0)
        shown = surface_normal((target - 0.5) * surface_size).xzy * 0.5 + 0.5;
    color = vec4(clamp(shown, 0.0, 1.0), 1.0);
}
#endif
