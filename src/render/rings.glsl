/* The vertex stage of the floor and of the water's surface: rings round the point below the eye, each wider than the
 * one before by the same factor, so that a cell is about as large as it looks (render/rings.c). */
#ifdef VERTEX
uniform ivec2 rings_count;  /* rings; vertices in one */
uniform vec2 rings_radii;   /* m, of the first and of the last */
uniform vec2 rings_angles;  /* radians: of the first vertex, and from one to the next */
uniform vec2 rings_middle;  /* m, x and z */
uniform float rings_extent; /* m, half a side of the square that is drawn; 0: it has no end */

/* The vertex's place at rest; `spacing`: m from ring to ring there. */
vec2 rings_place(out float spacing)
{
    ivec2 vertex = ivec2(gl_VertexID / rings_count.y, gl_VertexID % rings_count.y);
    float factor = pow(rings_radii.y / rings_radii.x, 1.0 / float(rings_count.x - 1));
    float radius = vertex.x == 0 ? 0.0 : rings_radii.x * pow(factor, float(vertex.x));
    float angle = rings_angles.x + rings_angles.y * float(vertex.y);
    spacing = radius * (factor - 1.0);
    return rings_middle + radius * vec2(cos(angle), sin(angle));
}
#endif
