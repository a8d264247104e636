/* A pass of wavefront_gpu.c: ratios of areas by a geometry stage, which sees all three vertices of a triangle. */
#ifdef VERTEX
#include "light/wavefront_vertex.glsl"
out vec2 before, after;
out vec3 weight;

void main()
{
    mesh_vertex vertex = find_vertex(strip_vertex(gl_VertexID));
    before = vertex.before;
    after = vertex.after;
    weight = vertex.weight;
    gl_Position = map_position(vertex.after);
}
#endif

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

#ifdef FRAGMENT
in vec3 light;
out vec4 color;

void main()
{
    color = vec4(light, 1.0);
}
#endif
