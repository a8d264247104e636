/* A pass of coverage_gpu.c where there are no compute shaders: a point for every cell, as wide as the cell's image,
 * whose fragments are blended together. */
#include "light/coverage_area.glsl"

#ifdef VERTEX
#include "light/coverage_cell.glsl"
uniform int side;     /* of the map */
uniform int margin;   /* texels that the target has beyond the map on every side */
uniform int cells;    /* a side of the surface */
uniform int periodic;
flat out vec4 upper_ab, lower_ab, both_c, upper_first, lower_first;

void main()
{
    image i = make_image(ivec2(gl_VertexID % cells, gl_VertexID / cells));
    float size = float(max(i.count.x, i.count.y));
    vec2 middle = vec2(i.first) + 0.5 * size;
    if (periodic != 0)
        middle -= floor(middle / float(side)) * float(side);
    vec2 first = middle - 0.5 * size + float(margin);
    upper_ab = vec4(i.upper.a, i.upper.b);
    lower_ab = vec4(i.lower.a, i.lower.b);
    both_c = vec4(i.upper.c, i.lower.c);
    upper_first = vec4(i.upper.density, first.x);
    lower_first = vec4(i.lower.density, first.y);
    gl_PointSize = size;
    gl_Position = vec4((middle + float(margin)) / float(side + 2 * margin) * 2.0 - 1.0, 0.0, 1.0);
}
#endif

#ifdef FRAGMENT
flat in vec4 upper_ab, lower_ab, both_c, upper_first, lower_first;
out vec4 color;

void main()
{
    vec2 place = gl_FragCoord.xy - 0.5 - vec2(upper_first.w, lower_first.w);
    triangle upper = triangle(upper_ab.xy, upper_ab.zw, both_c.xy, upper_first.rgb);
    triangle lower = triangle(lower_ab.xy, lower_ab.zw, both_c.zw, lower_first.rgb);
    color = vec4(light_on(upper, place) + light_on(lower, place), 0.0);
}
#endif
