/* light/beams.h: what the halves of the technique `beams` share. */
#ifndef LIGHT_BEAMS_H
#define LIGHT_BEAMS_H

#include "light/tracing_gpu.h"

/* Section [beams]. */
struct beams {
    double most;
};

/* The GPU's half. All zero: none yet. */
struct beams_gpu {
    struct gpu_program rays_program, program;
    struct gpu_texture ends; /* where the vertices' rays meet the receiver */
    struct tracing_blend blend;
};
bool beams_gpu_draw(struct beams_gpu *gpu, struct dpl_gl *gl, const struct light_input *input, struct gpu_texture *map);
void beams_gpu_finish(struct beams_gpu *gpu, struct dpl_gl *gl);

#endif
