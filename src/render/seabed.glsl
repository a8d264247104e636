/* The floor: sand with its relief, or tiles, lit by what comes through the water. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "render/view.glsl"
#include "render/receiver.glsl"
#include "scene/pattern.glsl"
uniform sampler2D relief_texels; /* m above the flat floor, and its slopes; one repetition covers the tile */
uniform float relief_size;       /* m, the tile */
uniform sampler2D sand;
uniform sampler2D floor_ambient; /* irradiance from all around */
uniform vec3 ambient_square;     /* m: the least x and z, and the side, that it covers */
uniform int pattern;            /* scene/pattern.glsl; plain: sand */
uniform float pattern_size;
uniform vec3 pattern_joint, floor_color;
uniform int layer;
uniform sampler2D mesh_depth; /* at which a pixel shows the floor (seabed_mesh.glsl); 1: nowhere */
out vec4 color;

void main()
{
    float depth = texelFetch(mesh_depth, ivec2(gl_FragCoord.xy), 0).r;
    vec3 position = view_point(view_ray(target), depth, layer);
    position.xz = view_fold(position.xz);
    vec2 place = position.xz / relief_size + 0.5, wide = fwidth(position.xz);
    vec2 slopes = texture(relief_texels, place).yz;
    vec3 sandy = texture(sand, place).rgb;
    if (depth == 1.0 || !waves_cover(position.xz) || layer_leaves_out(position))
        discard;
    gl_FragDepth = depth;
    vec3 normal = normalize(vec3(-slopes.x, 1.0, -slopes.y));
#ifdef PATTERN
    vec3 reflectance = pattern_color(pattern, pattern_size, pattern_joint, floor_color, position.xz, wide);
#else
    vec3 reflectance = sandy;
#endif
    vec3 ambient = texture(floor_ambient, (position.xz - ambient_square.xy) / ambient_square.z).rgb;
    color = vec4(receiver_radiance(position, normal, reflectance, ambient), 1.0);
}
#endif
