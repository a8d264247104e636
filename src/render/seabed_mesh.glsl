/* The depth at which the floor is seen. */
#include "render/view.glsl"
#include "render/rings.glsl"

uniform int layer;
uniform sampler2D relief_texels; /* m above the flat floor, and its slopes; one repetition covers the tile */
uniform float tile_floor;        /* m, y of the flat floor */
uniform float relief_size;       /* m, the tile */

#ifdef VERTEX
void main()
{
    float spacing;
    vec2 xz = rings_place(spacing);
    float level = log2(max(spacing * float(textureSize(relief_texels, 0).x) / relief_size, 1.0));
    vec2 place = view_fold(xz) / relief_size + 0.5;
    vec3 position = vec3(xz.x, tile_floor + textureLod(relief_texels, place, level).x, xz.y);
    gl_Position = view_projection * vec4(view_apparent(position, layer, -1.0), 1.0);
}
#else
void main() {}
#endif
