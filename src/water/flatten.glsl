/* What a choppy surface is like straight above and below the vertices of its grid: the GPU's twin of
 * surface_flatten(). */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "water/surface.glsl"
out vec4 texel;

/* The cell of a place counted in cells, and how far in. */
ivec2 cell_at(vec2 place, out vec2 inside)
{
    ivec2 last = textureSize(surface_texels, 0) - 2;
    vec2 cell = floor(place);
    if (surface_periodic == 0)
        cell = clamp(cell, vec2(0.0), vec2(last));
    inside = surface_periodic == 0 ? clamp(place - cell, 0.0, 1.0) : place - cell;
    return ivec2(cell);
}

vec2 shift_at(vec2 place)
{
    vec2 inside;
    ivec2 cell = cell_at(place, inside);
    vec2 above = mix(surface_shift(cell), surface_shift(cell + ivec2(1, 0)), inside.x);
    vec2 below = mix(surface_shift(cell + ivec2(0, 1)), surface_shift(cell + ivec2(1, 1)), inside.x);
    return mix(above, below, inside.y);
}

void main()
{
    vec2 vertex = floor(gl_FragCoord.xy), place = vertex, inside;
    for (int i = 0; i < 8; i++)
        place = vertex - shift_at(place) / surface_spacing();
    ivec2 cell = cell_at(place, inside);
    vec3 above = mix(surface_vertex(cell), surface_vertex(cell + ivec2(1, 0)), inside.x);
    vec3 below = mix(surface_vertex(cell + ivec2(0, 1)), surface_vertex(cell + ivec2(1, 1)), inside.x);
    texel = vec4(mix(above, below, inside.y), 0.0);
}
#endif
