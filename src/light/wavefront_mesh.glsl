/* A pass of wavefront_gpu.c: the water's surface at the vertices of a mesh of its own, between four of the surface's. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "water/surface.glsl"
uniform float stride; /* cells of the surface in one of the mesh */
out vec4 texel;

vec3 clamped(ivec2 vertex)
{
    return surface_vertex(surface_periodic != 0 ? vertex : min(vertex, textureSize(surface_texels, 0) - 1));
}

void main()
{
    vec2 place = floor(gl_FragCoord.xy) * stride, inside = fract(place);
    ivec2 cell = ivec2(place);
    vec3 upper = mix(clamped(cell), clamped(cell + ivec2(1, 0)), inside.x);
    vec3 lower = mix(clamped(cell + ivec2(0, 1)), clamped(cell + ivec2(1, 1)), inside.x);
    texel = vec4(mix(upper, lower, inside.y), 0.0);
}
#endif
