/* Where the light of the surface's vertices meets a receiver. */
#include "optics/refraction.glsl"
uniform sampler2D rays;  /* of coverage_rays.glsl */
uniform sampler2D shifts; /* m along x and z, of a choppy surface's vertices */
uniform int choppy;
uniform vec4 flat_water; /* u, v; q, the length of light's path for each metre of height, with its sign */
uniform vec3 absorption; /* 1/m; 0 above the surface */
uniform float receiver;  /* m, its height */

struct vertex_light {
    vec2 moved; /* m, from where flat water has it straight below the vertex */
    vec2 shift; /* m, of the vertex itself from where it rests */
    vec3 weight;
};

/* A vertex, the repeated edge of a periodic surface included. */
vertex_light find_light(ivec2 vertex)
{
    ivec2 count = textureSize(rays, 0);
    vertex = ivec2(vertex.x == count.x ? 0 : vertex.x, vertex.y == count.y ? 0 : vertex.y);
    vec4 ray = texelFetch(rays, vertex, 0);
    vec2 uv = flat_water.xy + ray.xy;
    /* water beyond the receiver lies on it */
    float height = receiver > 0.0 ? min(ray.z, receiver) : max(ray.z, receiver);
    float path = abs(receiver - height) * sqrt(1.0 + dot(uv, uv)) - abs(receiver * flat_water.z);
    vec2 moved = ray.xy * (receiver - height) - flat_water.xy * height;
    vec2 shift = choppy != 0 ? texelFetch(shifts, vertex, 0).xy : vec2(0.0);
    return vertex_light(moved, shift, ray.w * optics_transmittance(absorption, path));
}
