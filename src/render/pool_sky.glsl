/* The sky behind everything: the inside of a cube round the eye, as far away as can be. */
#ifdef VERTEX
uniform mat4 view_projection;
uniform vec3 eye;
out vec3 ray;

void main()
{
    const vec2 corners[6] = vec2[6](vec2(-1, -1), vec2(-1, 1), vec2(1, -1), vec2(1, -1), vec2(-1, 1), vec2(1, 1));
    vec3 corner = vec3(corners[gl_VertexID % 6], gl_VertexID / 18 == 0 ? 1.0 : -1.0);
    int axis = gl_VertexID / 6 % 3;
    ray = axis == 0 ? corner.xyz : axis == 1 ? corner.yzx : corner.zxy;
    gl_Position = (view_projection * vec4(eye + ray, 1.0)).xyww;
}
#endif

#ifdef FRAGMENT
#include "render/pool.glsl"
in vec3 ray;
out vec4 color;

void main()
{
    vec3 direction = normalize(ray);
    vec3 sun = sun_color * pow(max(dot(to_sun, direction), 0.0), sun_exponent);
    color = vec4(clamp(sky_color(direction) + sun, 0.0, 1.0), 1.0);
}
#endif
