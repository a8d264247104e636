/* A pass of wavefront_gpu.c: ratios of areas by vertices that belong to one triangle each and find its other two. */
#include "light/wavefront_light.glsl"

#ifdef VERTEX
#include "light/wavefront_area.glsl"
#include "light/wavefront_vertex.glsl"
out vec3 light;

void main()
{
    int triangle = gl_VertexID / 3, own = gl_VertexID % 3;
    mesh_vertex vertex = find_vertex(strip_vertex(triangle + own));
    mesh_vertex next = find_vertex(strip_vertex(triangle + (own + 1) % 3));
    mesh_vertex last = find_vertex(strip_vertex(triangle + (own + 2) % 3));
    light = vertex.weight * triangle_ratio(next.before - vertex.before, last.before - vertex.before,
                                           next.after - vertex.after, last.after - vertex.after);
    gl_Position = map_position(vertex.after);
}
#endif
