/* The floor: sand with its relief, or tiles, lit by what comes through the water. */
#include "render/view.glsl"
#include "render/rings.glsl"

uniform int layer;
uniform sampler2D relief_texels; /* m above the flat floor, and its slopes; one repetition covers the tile */
uniform float tile_floor;        /* m, y of the flat floor */
uniform float relief_size;       /* m, the tile */

#ifdef VERTEX
out vec3 position;

void main()
{
    float spacing;
    vec2 xz = rings_place(spacing);
    float level = log2(max(spacing * float(textureSize(relief_texels, 0).x) / relief_size, 1.0));
    position = vec3(xz.x, tile_floor + textureLod(relief_texels, xz / relief_size + 0.5, level).x, xz.y);
    gl_Position = view_projection * vec4(view_apparent(position, layer, -1.0), 1.0);
}
#else
#include "render/receiver.glsl"
#include "scene/pattern.glsl"
uniform sampler2D sand;
uniform sampler2D floor_ambient; /* irradiance from all around */
uniform vec3 ambient_square;     /* m: the least x and z, and the side, that it covers */
uniform int pattern;            /* scene/pattern.glsl; plain: sand */
uniform float pattern_size;
uniform vec3 pattern_joint, floor_color;
in vec3 position;
out vec4 color;

void main()
{
    if (!waves_cover(position.xz) || layer_leaves_out(position))
        discard;
    vec2 place = position.xz / relief_size + 0.5;
    vec2 slopes = texture(relief_texels, place).yz;
    vec3 normal = normalize(vec3(-slopes.x, 1.0, -slopes.y));
#ifdef PATTERN
    vec3 reflectance = pattern_color(pattern, pattern_size, pattern_joint, floor_color, position.xz, fwidth(position.xz));
#else
    vec3 reflectance = texture(sand, place).rgb;
#endif
    vec3 ambient = texture(floor_ambient, (position.xz - ambient_square.xy) / ambient_square.z).rgb;
    color = vec4(receiver_radiance(position, normal, reflectance, ambient), 1.0);
}
#endif
