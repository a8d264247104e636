/* gpu/target.h: what a picture is drawn into: colour, depth, and several samples a pixel if wanted. */
#ifndef GPU_TARGET_H
#define GPU_TARGET_H

#include "gpu/program.h"
#include "gpu/texture.h"

/* All zero: none yet. */
struct gpu_target {
    struct gpu_texture color;           /* one sample: the finished picture */
    GLuint framebuffer, samples, depth; /* what is drawn to; `samples` and `depth` are renderbuffers */
    int width, height, sample_count;
    struct gpu_program copy;
};

/* Makes it that size, of RGBA8 or RGBA16F; more samples than the device has become as many as it has. */
bool target_resize(struct dpl_gl *gl, struct gpu_target *target, GLenum format, int width, int height,
                   int sample_count);

/* Binds it for drawing and clears it. */
void target_begin(struct dpl_gl *gl, struct gpu_target *target, const double background[3]);

/* Merges the samples into `color`. */
void target_resolve(struct dpl_gl *gl, struct gpu_target *target);

/* Draws `color` over a framebuffer of the same size; 0 is the window. */
bool target_copy(struct dpl_gl *gl, struct gpu_target *target, GLuint framebuffer);

void target_finish(struct dpl_gl *gl, struct gpu_target *target);

#endif
