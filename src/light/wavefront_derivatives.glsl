/* A pass of wavefront_gpu.c: ratios of areas by derivatives in the fragment stage. */
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

#ifdef FRAGMENT
#include "light/wavefront_area.glsl"
in vec2 before, after;
in vec3 weight;
out vec4 color;

void main()
{
    color = vec4(weight * texel_ratio(dFdx(before), dFdy(before), dFdx(after), dFdy(after)), 1.0);
}
#endif
