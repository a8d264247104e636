/* render/waves.h: the water's surface as sight wants it: with smaller levels, for what is far off. */
#ifndef RENDER_WAVES_H
#define RENDER_WAVES_H

#include "render/frame.h"

/* All zero: none yet. */
struct waves {
    struct gpu_program make;
    struct gpu_texture texels; /* height, slopes along x and z, square of the slopes */
    double reach;              /* m that the water stands above or below its rest surface, at most */
    double slope;              /* root mean square */
};

/* Makes it from the frame's surface. */
bool waves_update(struct waves *waves, const struct frame *frame);

/* Sets the uniforms of render/waves.glsl in the program in use, the texture on the given unit. */
void waves_bind(const struct waves *waves, const struct frame *frame, const struct gpu_program *program, int unit);

/* Half a side of the square of water that there is, m; 0: it has no end. */
double waves_extent(const struct frame *frame);

void waves_finish(struct waves *waves, struct dpl_gl *gl);

#endif
