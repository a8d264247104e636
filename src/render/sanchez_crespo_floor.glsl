/* The floor's two passes: the sand in the light from all around; and, ADDED to it, the caustics on a mesh as fine as
 * that of the waves. */
uniform float size, depth; /* m */
uniform vec3 tile;         /* m, where the tile's middle is */

#ifdef VERTEX
uniform mat4 view_projection;
uniform int cells;   /* a side */
uniform float reach; /* side of the floor, in tiles */
uniform int columns; /* vertices in a row */
out vec3 position;
out vec2 place; /* 0 to 1 across the tile, along x and z */

void main()
{
#ifdef ADDED
    place = vec2(gl_VertexID % columns, gl_VertexID / columns) / float(cells);
#else
    const vec2 corners[6] = vec2[6](vec2(0, 0), vec2(0, 1), vec2(1, 0), vec2(1, 0), vec2(0, 1), vec2(1, 1));
    place = (corners[gl_VertexID] - 0.5) * reach + 0.5;
#endif
    vec2 xz = (place - 0.5) * size;
    position = vec3(xz.x, -depth, xz.y) + tile;
    gl_Position = view_projection * vec4(position, 1.0);
}
#else
#include "light/map.glsl"
#include "render/sanchez_crespo_water.glsl"
uniform sampler2D sand;
uniform float ambient, caustics;
in vec3 position;
in vec2 place;
out vec4 color;

void main()
{
    vec3 base = texture(sand, place).rgb * pow(transmittance, depth);
    float left = pow(transmittance, length_in_water(position));
#ifdef ADDED
    color = vec4(base * caustics * light_at(place) * left, 0.0);
#else
    color = vec4(mix(water_color, base * ambient, left), 1.0);
#endif
}
#endif
