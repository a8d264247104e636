/* A pass of wavefront_gpu.c: ratios of areas by a geometry stage, which sees all three vertices of a triangle. */
#include "light/wavefront_strip.glsl"
#include "light/wavefront_light.glsl"

#ifdef GEOMETRY
#include "light/wavefront_area.glsl"
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
in vec2 before[], after[];
in vec3 weight[];
out vec3 light;

void main()
{
    float ratio =
        triangle_ratio(before[1] - before[0], before[2] - before[0], after[1] - after[0], after[2] - after[0]);
    for (int k = 0; k < 3; k++) {
        light = weight[k] * ratio;
        gl_Position = gl_in[k].gl_Position;
        EmitVertex();
    }
}
#endif
