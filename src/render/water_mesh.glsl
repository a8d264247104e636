/* The vertex stage of what is drawn on the surface's triangles (water_mesh.c). */
#include "water/surface.glsl"

#ifdef VERTEX
uniform mat4 view_projection;
uniform vec3 tile;   /* m, where the tile's middle is drawn */
uniform int columns; /* vertices in a row of the mesh, the repeated edge of a periodic surface included */
uniform int stride;  /* from one of its vertices to the next on the surface; the last one is always there */
uniform int swapped; /* rows follow each other along x */
out vec3 position, normal;

void main()
{
    int last = textureSize(surface_texels, 0).x - (surface_periodic != 0 ? 0 : 1);
    ivec2 vertex = min(ivec2(gl_VertexID % columns, gl_VertexID / columns) * stride, last);
    if (swapped != 0)
        vertex = vertex.yx;
    vec3 texel = surface_vertex(vertex);
    vec2 xz = vec2(vertex) * surface_spacing() - 0.5 * surface_size + surface_shift(vertex);
    position = vec3(xz.x, texel.x, xz.y) + tile;
    normal = normalize(vec3(-texel.y, 1.0, -texel.z));
    gl_Position = view_projection * vec4(position, 1.0);
}
#else
in vec3 position, normal;
#endif
