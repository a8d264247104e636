/* The vertices of solids as scene/world.h has them. */
#include "scene/sway.glsl"
layout(location = 0) in vec3 vertex_position;
layout(location = 1) in vec3 vertex_normal;
layout(location = 4) in float vertex_sway;

vec3 solid_position()
{
    return vertex_position + sway_move(vertex_position, vertex_sway);
}
