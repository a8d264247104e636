/* The ball in the pool. */
#ifdef VERTEX
uniform mat4 view_projection;
uniform float half_side, sphere_radius;
uniform vec3 sphere;
uniform int rings; /* from pole to pole, and half as many as there are round it */
out vec3 point;    /* half sides */

void main()
{
    const ivec2 corners[6] = ivec2[6](ivec2(0, 0), ivec2(0, 1), ivec2(1, 0), ivec2(1, 0), ivec2(0, 1), ivec2(1, 1));
    int cell = gl_VertexID / 6;
    ivec2 corner = corners[gl_VertexID % 6] + ivec2(cell % (2 * rings), cell / (2 * rings));
    vec2 angle = 3.14159265 / float(rings) * vec2(corner);
    point = sphere + sphere_radius * vec3(sin(angle.y) * cos(angle.x), cos(angle.y), sin(angle.y) * sin(angle.x));
    gl_Position = view_projection * vec4(point * half_side, 1.0);
}
#endif

#ifdef FRAGMENT
#include "render/pool.glsl"
uniform vec3 wet;
in vec3 point;
out vec4 color;

void main()
{
    vec3 seen = ball_color(point, normalize(point - sphere), sun_at(point));
    color = vec4(clamp(under_water(point) ? seen * wet : seen, 0.0, 1.0), 1.0);
}
#endif
