#include "gpu/target.h"

#include "base/log.h"

static void resize_renderbuffer(struct dpl_gl *gl, GLuint *name, GLenum format, const struct gpu_target *target,
                                GLenum attachment)
{
    if (!*name)
        gl->GenRenderbuffers(1, name);
    gl->BindRenderbuffer(GL_RENDERBUFFER, *name);
    gl->RenderbufferStorageMultisample(GL_RENDERBUFFER, target->sample_count > 1 ? target->sample_count : 0, format,
                                       target->width, target->height);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, *name);
}

bool target_resize(struct dpl_gl *gl, struct gpu_target *target, GLenum format, int width, int height, int sample_count)
{
    if (sample_count > gl->info.samples_max)
        sample_count = gl->info.samples_max;
    if (target->framebuffer && target->width == width && target->height == height &&
        target->sample_count == sample_count)
        return true;
    if (width < 1 || height < 1 || width > gl->info.texture_max || height > gl->info.texture_max)
        return base_fail(gl->log, DPL_REASON_LIMIT, "picture size out of range: %d × %d (1 to %d each on this device)",
                         width, height, gl->info.texture_max);
    target->width = width;
    target->height = height;
    target->sample_count = sample_count;
    texture_resize(gl, &target->color, format, width, height, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_draw_to(gl, &target->color);
    if (!target->framebuffer)
        gl->GenFramebuffers(1, &target->framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    if (sample_count > 1)
        resize_renderbuffer(gl, &target->samples, format, target, GL_COLOR_ATTACHMENT0);
    else
        gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target->color.name, 0);
    resize_renderbuffer(gl, &target->depth, GL_DEPTH_COMPONENT24, target, GL_DEPTH_ATTACHMENT);
    if (gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE)
        return true;
    target->width = 0; /* so that the next frame tries again */
    return base_fail(gl->log, DPL_REASON_LIMIT, "the device cannot draw %d × %d pixels of %d samples", width, height,
                     sample_count);
}

void target_begin(struct dpl_gl *gl, struct gpu_target *target, const double background[3])
{
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    gl->Viewport(0, 0, target->width, target->height);
    gl->ClearColor((GLfloat)background[0], (GLfloat)background[1], (GLfloat)background[2], 1.0f);
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void target_resolve(struct dpl_gl *gl, struct gpu_target *target)
{
    if (target->sample_count <= 1)
        return;
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, target->framebuffer);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, target->color.framebuffer);
    gl->BlitFramebuffer(0, 0, target->width, target->height, 0, 0, target->width, target->height, GL_COLOR_BUFFER_BIT,
                        GL_NEAREST);
}

bool target_copy(struct dpl_gl *gl, struct gpu_target *target, GLuint framebuffer)
{
    if (!program_ready(gl, &target->copy, "gpu/copy.glsl", ""))
        return false;
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->Viewport(0, 0, target->width, target->height);
    program_use(gl, &target->copy);
    texture_bind(gl, &target->color, 0);
    program_int(gl, &target->copy, "picture", 0);
    gpu_draw_screen(gl);
    return true;
}

void target_finish(struct dpl_gl *gl, struct gpu_target *target)
{
    program_finish(gl, &target->copy);
    texture_finish(gl, &target->color);
    gl->DeleteFramebuffers(1, &target->framebuffer);
    gl->DeleteRenderbuffers(1, &target->samples);
    gl->DeleteRenderbuffers(1, &target->depth);
    *target = (struct gpu_target){0};
}
