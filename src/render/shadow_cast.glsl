/* Draws solids into the map of shadows: a point lands where its light passes the rest surface, as deep as the highest
 * solid is above it. What is above that surface and what is below are drawn apart, each along its own slant. For light
 * that the water throws up the lowest solid counts. */
uniform vec4 shadow_square, shadow_thrown_square; /* as in render/shadow.glsl */
uniform vec2 shadow_span;
uniform vec2 slant;      /* of the light's way: x and z for each m of y */
uniform float above;     /* 1: what is above the surface, -1: what is below */
uniform float cut;       /* m: longest edge of a triangle */
uniform int thrown;      /* 1: for light that the water throws up */

#ifdef VERTEX
#include "render/solid_vertex.glsl"
out float height;

void main()
{
    vec3 point = solid_position();
    vec4 square = thrown != 0 ? shadow_thrown_square : shadow_square;
    vec2 place = (point.xz - slant * point.y - square.xy) / square.zw;
    height = point.y;
    float share = (point.y - shadow_span.x) / shadow_span.y, depth = thrown != 0 ? share : 1.0 - share;
    gl_Position = vec4(2.0 * place - 1.0, 2.0 * depth - 1.0, 1.0);
    /* what lies so far on the other side that no triangle reaches over from it is put beyond the map */
    if (point.y * above < -cut)
        gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
}
#else
in float height;

void main()
{
    if (height * above < 0.0)
        discard;
}
#endif
