/* water/surface_gpu.h: the surface as a texture: height, slope along x, slope along z in red, green and blue, a texel
 * a vertex; and, where it is choppy, a second one of shifts. Shaders read them through water/surface.glsl. */
#ifndef WATER_SURFACE_GPU_H
#define WATER_SURFACE_GPU_H

#include "gpu/program.h"
#include "gpu/texture.h"
#include "water/water.h"

/* All zero: none yet. */
struct surface_gpu {
    struct gpu_texture texels, shifts;
    struct gpu_program program, shift_program; /* of the model that the GPU evaluates */
    const struct water_model *model;           /* whose programs these are */
    double size;                               /* m */
    bool periodic, choppy;
};

/* True where the model can be evaluated on this device. */
bool surface_gpu_can_evaluate(const struct dpl_gl *gl, const struct water_model *model);

/* Evaluates the model on the GPU. */
bool surface_gpu_evaluate(struct dpl_gl *gl, struct surface_gpu *surface, const struct water_model *model,
                          const struct water_setup *setup, double time);

/* Makes `to` what a choppy surface is like straight above and below its vertices; see surface_flatten(). */
bool surface_gpu_flatten(struct dpl_gl *gl, const struct surface_gpu *from, struct surface_gpu *to);

/* Copies a surface evaluated on the CPU. */
void surface_gpu_upload(struct dpl_gl *gl, struct surface_gpu *surface, const struct surface *from);

/* Copies the other way; the target is resized. */
bool surface_gpu_read(struct dpl_gl *gl, struct surface_gpu *surface, struct surface *to);

/* Sets the uniforms of water/surface.glsl in the program in use, the texture on the given unit; shifts are on the last
 * one. */
void surface_gpu_bind(struct dpl_gl *gl, const struct surface_gpu *surface, const struct gpu_program *program,
                      int unit);

void surface_gpu_finish(struct dpl_gl *gl, struct surface_gpu *surface);

#endif
