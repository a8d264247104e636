/* light/tracing_gpu.h: what the techniques that follow single rays share on the GPU: one receiver, as
 * light/tracing.glsl sees it, and light that is added up by blending. */
#ifndef LIGHT_TRACING_GPU_H
#define LIGHT_TRACING_GPU_H

#include "light/tracing.h"

#include "gpu/program.h"

/* What is the same for all rays of some colours to one receiver. */
struct tracing_rays {
    const struct light_input *input;
    struct tracing_view view;
    struct optics_disc disc;
    struct ray_medium medium;
    double receiver; /* m */
    int color;       /* the first of those that are meant: one, or all three */
};
struct tracing_rays tracing_rays_of(const struct light_input *input, const struct optics_sun *sun, int side, int slice,
                                    int color);

/* Sets the uniforms of light/tracing.glsl in the program in use, the surface on texture unit 0. */
void tracing_rays_bind(struct dpl_gl *gl, const struct tracing_rays *rays, const struct gpu_program *program);

/* Light on a receiver with a margin around it, so that what is drawn over the edge of periodic water comes in at the
 * other side. All zero: none yet. */
struct tracing_blend {
    struct gpu_program program;
    struct gpu_texture light;
};
bool tracing_blend_ready(struct dpl_gl *gl, struct tracing_blend *blend);

/* What is drawn from now on is added up. `margin`: texels; `clear`: begins with darkness. Textures are bound after it.
 */
void tracing_blend_begin(struct dpl_gl *gl, struct tracing_blend *blend, int side, int margin, bool clear);
void tracing_blend_end(struct dpl_gl *gl);

/* The sum, into a layer of the map. */
void tracing_blend_draw(struct dpl_gl *gl, struct tracing_blend *blend, bool periodic, int margin,
                        struct gpu_texture *map, int slice);
void tracing_blend_finish(struct dpl_gl *gl, struct tracing_blend *blend);

#endif
