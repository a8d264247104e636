/* Solids: rocks, plants, walls and what else the scene's objects are. */
#include "render/view.glsl"
#include "render/waves.glsl"

uniform int layer;
uniform ivec2 image; /* in a tank's panes: view_image() */

#ifdef VERTEX
#include "render/solid_vertex.glsl"
layout(location = 2) in vec3 vertex_color;
layout(location = 3) in vec2 vertex_place;
layout(location = 5) in vec3 vertex_ambient;
out vec3 position, normal, base, ambient;
out vec2 place;
uniform float cut; /* m from the rest surface */

void main()
{
    position = solid_position();
    normal = vertex_normal;
    base = vertex_color;
    ambient = vertex_ambient;
    place = vertex_place;
    gl_Position = view_projection * vec4(view_apparent(view_image(position, image), layer, -1.0), 1.0);
    /* What lies so far on the other side that no triangle reaches over from it is put beyond the picture. */
#ifdef WET
    bool away = position.y > cut;
#else
    bool away = position.y < -cut && waves_extent == 0.0; /* beside bounded water, dry things stand as low */
#endif
    if (away)
        gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
}
#else
#include "render/receiver.glsl"
#include "scene/pattern.glsl"
uniform int two_sided;
uniform int pattern; /* of the part: scene/world.h */
uniform float pattern_size;
uniform vec3 pattern_joint;
in vec3 position, normal, base, ambient;
in vec2 place;
out vec4 color;

void main()
{
    vec2 wide = fwidth(place);
    if (layer_leaves_out(position))
        discard;
    vec3 facing = normalize(normal);
    vec3 seen_from = view_image(layer == LAYER_MIRROR ? eye * vec3(1.0, -1.0, 1.0) : eye, image);
    if (two_sided != 0 && dot(facing, seen_from - position) < 0.0)
        facing = -facing;
    vec3 reflectance = pattern_color(pattern, pattern_size, pattern_joint, base, place, wide);
    color = vec4(receiver_radiance(position, facing, reflectance, ambient), 1.0);
}
#endif
