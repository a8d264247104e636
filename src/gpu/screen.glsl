/* The vertex stage of a pass over the whole target: one triangle, no buffers. */
#ifdef VERTEX
#ifndef SCREEN_DEPTH
#define SCREEN_DEPTH 0.0 /* in clip space */
#endif
out vec2 target; /* 0 to 1, from the target's first row and column to its last */

void main()
{
    target = vec2(float((gl_VertexID & 1) << 1), float(gl_VertexID & 2));
    gl_Position = vec4(target * 2.0 - 1.0, SCREEN_DEPTH, 1.0);
}
#else
in vec2 target;
#endif
