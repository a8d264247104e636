/* gpu/layer.h: a picture and its depths, both to be read by later passes. */
#ifndef GPU_LAYER_H
#define GPU_LAYER_H

#include "gpu/texture.h"

/* All zero: none yet. */
struct gpu_layer {
    struct gpu_texture color; /* RGBA16F, or none */
    struct gpu_texture depth; /* 24 bits; 1 where nothing was drawn */
    GLuint framebuffer;
};

/* Makes it that size; `format` 0: depth alone. False (logged) where the device cannot draw to it. */
bool layer_resize(struct dpl_gl *gl, struct gpu_layer *layer, GLenum format, int width, int height);

/* Binds it for drawing, sets the viewport to all of it, clears colour to zeros and depth to 1. */
void layer_begin(struct dpl_gl *gl, const struct gpu_layer *layer);

/* Goes on drawing to it, all of it being the viewport. */
void layer_resume(struct dpl_gl *gl, const struct gpu_layer *layer);

/* Takes a zeroed one. Leaves it zeroed. */
void layer_finish(struct dpl_gl *gl, struct gpu_layer *layer);

#endif
