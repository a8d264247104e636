/* render/rings.h: a mesh of rings round the point below the eye, for surfaces that go on to the horizon. A shader's
 * vertex stage has its places from render/rings.glsl. */
#ifndef RENDER_RINGS_H
#define RENDER_RINGS_H

#include "render/frame.h"

/* All zero: none yet. */
struct rings {
    GLuint array, buffer;
    int count, around; /* rings, vertices in one */
};

/* Makes the triangles, or leaves them where they are as many. */
bool rings_ready(struct rings *rings, struct dpl_gl *gl, int count, int around);

/* Draws them with the program in use, as wide as the picture sees, from the eye outwards: so that what is near is drawn
 * before what it hides. `height`: m from the eye to the surface; `farthest`: m, of the last ring; `extent`: m, half a
 * side of the square that is drawn, 0: it has no end. */
void rings_draw(const struct rings *rings, const struct frame *frame, const struct gpu_program *program, double height,
                double farthest, double extent);

void rings_finish(struct rings *rings, struct dpl_gl *gl);

#endif
