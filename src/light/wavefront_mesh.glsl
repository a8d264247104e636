/* A pass of wavefront_gpu.c: the water's surface at the vertices of a mesh of its own, between four of the surface's.
 * With SHIFTS, how far these stand from their places at rest. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "water/surface.glsl"
uniform float stride; /* cells of the surface in one of the mesh */
out vec4 texel;

vec4 numbers(ivec2 vertex)
{
    if (surface_periodic == 0)
        vertex = min(vertex, textureSize(surface_texels, 0) - 1);
#ifdef SHIFTS
    return vec4(surface_shift(vertex), 0.0, 0.0);
#else
    return vec4(surface_vertex(vertex), 0.0);
#endif
}

void main()
{
    vec2 place = floor(gl_FragCoord.xy) * stride, inside = fract(place);
    ivec2 cell = ivec2(place);
    vec4 upper = mix(numbers(cell), numbers(cell + ivec2(1, 0)), inside.x);
    vec4 lower = mix(numbers(cell + ivec2(0, 1)), numbers(cell + ivec2(1, 1)), inside.x);
    texel = mix(upper, lower, inside.y);
}
#endif
