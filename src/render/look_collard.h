/* render/look_collard.h: the picture as Collard & Mundi 2022 shade it. */
#ifndef RENDER_LOOK_COLLARD_H
#define RENDER_LOOK_COLLARD_H

#include "render/frame.h"

/* All zero: none yet. */
struct look_collard_state {
    struct gpu_program ground, water;
    GLuint cells_array, cells_buffer; /* the surface's triangles, as vertex numbers */
    int cells;                        /* a side, that they are for */
};

bool look_collard_draw(struct look_collard_state *state, const struct frame *frame);

void look_collard_finish(struct look_collard_state *state, struct dpl_gl *gl);

#endif
