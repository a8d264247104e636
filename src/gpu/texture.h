/* gpu/texture.h: textures that can be drawn to, and uploads. */
#ifndef GPU_TEXTURE_H
#define GPU_TEXTURE_H

#include "gpu/gl.h"

enum texture_wrap { TEXTURE_CLAMP, TEXTURE_REPEAT };
enum texture_filter { TEXTURE_NEAREST, TEXTURE_LINEAR, TEXTURE_MIPMAP };

/* A 2D texture, or an array of them, with, once drawn to, a framebuffer of its own. All zero: none yet. */
struct gpu_texture {
    GLuint name, framebuffer;
    GLenum format; /* sized internal format */
    int width, height;
    int layers; /* of an array; 0: not an array */
    enum texture_wrap wrap;
    enum texture_filter filter;
};

/* Makes the texture that size and format, or leaves it where it already is; contents are undefined after a change. */
void texture_resize(struct dpl_gl *gl, struct gpu_texture *texture, GLenum format, int width, int height,
                    enum texture_wrap wrap, enum texture_filter filter);

/* The same for an array of `layers` textures. */
void texture_resize_array(struct dpl_gl *gl, struct gpu_texture *texture, GLenum format, int width, int height,
                          int layers, enum texture_wrap wrap, enum texture_filter filter);

/* Replaces the contents by rows of floats, as many a texel as the format has channels; those of an array
 * layer after layer. */
void texture_upload(struct dpl_gl *gl, const struct gpu_texture *texture, const float *texels);

/* Makes the smaller levels of a TEXTURE_MIPMAP texture from its contents. */
void texture_make_mipmaps(struct dpl_gl *gl, const struct gpu_texture *texture);

/* Binds the texture's framebuffer and sets the viewport to all of it. */
void texture_draw_to(struct dpl_gl *gl, struct gpu_texture *texture);

/* The same for one layer of an array. */
void texture_draw_to_layer(struct dpl_gl *gl, struct gpu_texture *texture, int layer);

/* Binds to a texture unit. */
void texture_bind(struct dpl_gl *gl, const struct gpu_texture *texture, GLenum unit);

/* Takes a zeroed one. Leaves it zeroed. */
void texture_finish(struct dpl_gl *gl, struct gpu_texture *texture);

/* True where the device can draw to textures of that format. */
bool texture_can_render(struct dpl_gl *gl, GLenum format);

#endif
