#include "gpu/texture.h"

#include <assert.h>
#include <stddef.h>

struct pixel_format {
    GLenum sized, channels, type;
};

static const struct pixel_format formats[] = {
    {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
    {GL_R16F, GL_RED, GL_FLOAT},
    {GL_RGB16F, GL_RGB, GL_FLOAT},
    {GL_RGBA16F, GL_RGBA, GL_FLOAT},
    {GL_R32F, GL_RED, GL_FLOAT},
    {GL_RGB32F, GL_RGB, GL_FLOAT},
    {GL_RGBA32F, GL_RGBA, GL_FLOAT},
    {GL_RG32F, GL_RG, GL_FLOAT},
    {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT},
};

static const struct pixel_format *find_format(GLenum sized)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (formats[i].sized == sized)
            return formats + i;
    assert(false && "the texture format is in the table");
    return NULL;
}

static GLenum target_of(const struct gpu_texture *texture)
{
    return texture->layers ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
}

static void set_sampling(struct dpl_gl *gl, GLenum target, enum texture_wrap wrap, enum texture_filter filter)
{
    GLint wraps = wrap == TEXTURE_REPEAT ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    GLint near = filter == TEXTURE_NEAREST ? GL_NEAREST : GL_LINEAR;
    gl->TexParameteri(target, GL_TEXTURE_WRAP_S, wraps);
    gl->TexParameteri(target, GL_TEXTURE_WRAP_T, wraps);
    gl->TexParameteri(target, GL_TEXTURE_MAG_FILTER, near);
    gl->TexParameteri(target, GL_TEXTURE_MIN_FILTER, filter == TEXTURE_MIPMAP ? GL_LINEAR_MIPMAP_LINEAR : near);
}

void texture_resize_array(struct dpl_gl *gl, struct gpu_texture *texture, GLenum format, int width, int height,
                          int layers, enum texture_wrap wrap, enum texture_filter filter)
{
    bool fits = texture->name && texture->format == format && texture->width == width && texture->height == height &&
                texture->layers == layers;
    if (fits && texture->wrap == wrap && texture->filter == filter)
        return;
    if (texture->name && !texture->layers != !layers)
        texture_finish(gl, texture); /* a name stays what it was first bound as */
    if (!texture->name)
        gl->GenTextures(1, &texture->name);
    texture->layers = layers;
    texture->wrap = wrap;
    texture->filter = filter;
    GLenum target = target_of(texture);
    gl->BindTexture(target, texture->name);
    set_sampling(gl, target, wrap, filter);
    if (fits)
        return;
    const struct pixel_format *pixels = find_format(format);
    if (layers)
        gl->TexImage3D(target, 0, (GLint)format, width, height, layers, 0, pixels->channels, pixels->type, NULL);
    else
        gl->TexImage2D(target, 0, (GLint)format, width, height, 0, pixels->channels, pixels->type, NULL);
    texture->format = format;
    texture->width = width;
    texture->height = height;
}

void texture_resize(struct dpl_gl *gl, struct gpu_texture *texture, GLenum format, int width, int height,
                    enum texture_wrap wrap, enum texture_filter filter)
{
    texture_resize_array(gl, texture, format, width, height, 0, wrap, filter);
}

void texture_upload(struct dpl_gl *gl, const struct gpu_texture *texture, const float *texels)
{
    GLenum channels = find_format(texture->format)->channels, target = target_of(texture);
    int width = texture->width, height = texture->height;
    gl->BindTexture(target, texture->name);
    if (texture->layers)
        gl->TexSubImage3D(target, 0, 0, 0, 0, width, height, texture->layers, channels, GL_FLOAT, texels);
    else
        gl->TexSubImage2D(target, 0, 0, 0, width, height, channels, GL_FLOAT, texels);
}

void texture_make_mipmaps(struct dpl_gl *gl, const struct gpu_texture *texture)
{
    gl->BindTexture(target_of(texture), texture->name);
    gl->GenerateMipmap(target_of(texture));
}

/* Binds the texture's framebuffer, which is new where this returns true. */
static bool bind_framebuffer(struct dpl_gl *gl, struct gpu_texture *texture)
{
    bool new = texture->framebuffer == 0;
    if (new)
        gl->GenFramebuffers(1, &texture->framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, texture->framebuffer);
    gl->Viewport(0, 0, texture->width, texture->height);
    return new;
}

void texture_draw_to(struct dpl_gl *gl, struct gpu_texture *texture)
{
    if (bind_framebuffer(gl, texture))
        gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture->name, 0);
}

void texture_draw_to_layer(struct dpl_gl *gl, struct gpu_texture *texture, int layer)
{
    bind_framebuffer(gl, texture);
    gl->FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture->name, 0, layer);
}

void texture_bind(struct dpl_gl *gl, const struct gpu_texture *texture, GLenum unit)
{
    gl->ActiveTexture(GL_TEXTURE0 + unit);
    gl->BindTexture(target_of(texture), texture->name);
}

void texture_finish(struct dpl_gl *gl, struct gpu_texture *texture)
{
    gl->DeleteFramebuffers(1, &texture->framebuffer);
    gl->DeleteTextures(1, &texture->name);
    *texture = (struct gpu_texture){0};
}

bool texture_can_render(struct dpl_gl *gl, GLenum format)
{
    struct gpu_texture texture = {0};
    texture_resize(gl, &texture, format, 4, 4, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_draw_to(gl, &texture);
    bool complete = gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    texture_finish(gl, &texture);
    while (gl->GetError() != GL_NO_ERROR) {
        /* drains what an unsupported format raised */
    }
    return complete;
}
