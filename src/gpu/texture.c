#include "gpu/texture.h"

#include <assert.h>
#include <stddef.h>

struct pixel_format {
    GLenum sized, channels, type;
};

static const struct pixel_format formats[] = {
    {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE}, {GL_R16F, GL_RED, GL_FLOAT}, {GL_RGB16F, GL_RGB, GL_FLOAT},
    {GL_RGBA16F, GL_RGBA, GL_FLOAT},       {GL_R32F, GL_RED, GL_FLOAT}, {GL_RGB32F, GL_RGB, GL_FLOAT},
    {GL_RGBA32F, GL_RGBA, GL_FLOAT},
};

static const struct pixel_format *find_format(GLenum sized)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (formats[i].sized == sized)
            return formats + i;
    assert(false && "the texture format is in the table");
    return NULL;
}

static void set_sampling(struct dpl_gl *gl, enum texture_wrap wrap, enum texture_filter filter)
{
    GLint wraps = wrap == TEXTURE_REPEAT ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    GLint near = filter == TEXTURE_NEAREST ? GL_NEAREST : GL_LINEAR;
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wraps);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wraps);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, near);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter == TEXTURE_MIPMAP ? GL_LINEAR_MIPMAP_LINEAR : near);
}

void texture_resize(struct dpl_gl *gl, struct gpu_texture *texture, GLenum format, int width, int height,
                    enum texture_wrap wrap, enum texture_filter filter)
{
    bool fits = texture->name && texture->format == format && texture->width == width && texture->height == height;
    if (fits && texture->filter == filter)
        return;
    if (!texture->name)
        gl->GenTextures(1, &texture->name);
    gl->BindTexture(GL_TEXTURE_2D, texture->name);
    set_sampling(gl, wrap, filter);
    texture->filter = filter;
    if (fits)
        return;
    const struct pixel_format *pixels = find_format(format);
    gl->TexImage2D(GL_TEXTURE_2D, 0, (GLint)format, width, height, 0, pixels->channels, pixels->type, NULL);
    texture->format = format;
    texture->width = width;
    texture->height = height;
}

void texture_upload(struct dpl_gl *gl, const struct gpu_texture *texture, const float *texels)
{
    gl->BindTexture(GL_TEXTURE_2D, texture->name);
    gl->TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, texture->width, texture->height, find_format(texture->format)->channels,
                      GL_FLOAT, texels);
}

void texture_make_mipmaps(struct dpl_gl *gl, const struct gpu_texture *texture)
{
    gl->BindTexture(GL_TEXTURE_2D, texture->name);
    gl->GenerateMipmap(GL_TEXTURE_2D);
}

void texture_draw_to(struct dpl_gl *gl, struct gpu_texture *texture)
{
    bool made = texture->framebuffer != 0;
    if (!made)
        gl->GenFramebuffers(1, &texture->framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, texture->framebuffer);
    if (!made)
        gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture->name, 0);
    gl->Viewport(0, 0, texture->width, texture->height);
}

void texture_bind(struct dpl_gl *gl, const struct gpu_texture *texture, GLenum unit)
{
    gl->ActiveTexture(GL_TEXTURE0 + unit);
    gl->BindTexture(GL_TEXTURE_2D, texture->name);
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
