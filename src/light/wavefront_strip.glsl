/* The vertex stage of passes that find areas in a later one. */
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
