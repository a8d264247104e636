/* The pool's floor and walls, seen from inside: a face that shows its back is left out, as in Wallace's program. */
#ifdef VERTEX
uniform mat4 view_projection;
uniform float half_side, depth, rim;
uniform vec3 eye;
out vec3 point; /* half sides */
flat out vec3 normal;

void main()
{
    const vec3 normals[5] = vec3[5](vec3(0, 1, 0), vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 0, 1), vec3(0, 0, -1));
    const vec2 corners[6] = vec2[6](vec2(0, 0), vec2(0, 1), vec2(1, 0), vec2(1, 0), vec2(0, 1), vec2(1, 1));
    vec2 corner = corners[gl_VertexID % 6], across = 2.0 * corner - 1.0;
    float up = mix(-depth, rim, corner.y);
    normal = normals[gl_VertexID / 6];
    point = normal.y > 0.5 ? vec3(across.x, -depth, across.y)
                           : vec3(0.0, up, 0.0) - normal + across.x * vec3(abs(normal.z), 0.0, abs(normal.x));
    bool seen = dot(eye / half_side - point, normal) > 0.0;
    gl_Position = seen ? view_projection * vec4(point * half_side, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
#endif

#ifdef FRAGMENT
#include "render/pool.glsl"
uniform vec3 eye, wet;
in vec3 point;
flat in vec3 normal;
out vec4 color;

void main()
{
    vec3 view = point - eye / half_side, ray = normalize(view);
    float spread = max(length(dFdx(ray)), length(dFdy(ray))) * length(view);
    vec3 seen = wall_color(point, normal, spread, sun_at(point));
    color = vec4(clamp(under_water(point) ? seen * wet : seen, 0.0, 1.0), 1.0);
}
#endif
