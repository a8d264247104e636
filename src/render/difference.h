/* render/difference.h: the floor alone, coloured by how far one caustic map is from another. */
#ifndef RENDER_DIFFERENCE_H
#define RENDER_DIFFERENCE_H

#include "render/frame.h"

/* All zero: none yet. */
struct difference {
    struct gpu_program program;
    struct gpu_texture colors; /* of DPL_COLORS_DIFFERENCE, -1 to 1 */
};

/* Draws frame->map × gain less `other`; a difference of `range` has the strongest colour. */
bool difference_draw(struct difference *difference, const struct frame *frame, const struct gpu_texture *other,
                     double gain, double range);

void difference_finish(struct dpl_gl *gl, struct difference *difference);

#endif
