#include "gpu/layer.h"

#include "base/log.h"

bool layer_resize(struct dpl_gl *gl, struct gpu_layer *layer, GLenum format, int width, int height)
{
    if (layer->framebuffer && layer->depth.width == width && layer->depth.height == height &&
        layer->color.format == format)
        return true;
    texture_resize(gl, &layer->depth, GL_DEPTH_COMPONENT24, width, height, TEXTURE_CLAMP, TEXTURE_NEAREST);
    if (format)
        texture_resize(gl, &layer->color, format, width, height, TEXTURE_CLAMP, TEXTURE_LINEAR);
    if (!layer->framebuffer)
        gl->GenFramebuffers(1, &layer->framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, layer->framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, layer->depth.name, 0);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, layer->color.name, 0);
    const GLenum buffer = format ? GL_COLOR_ATTACHMENT0 : GL_NONE;
    gl->DrawBuffers(1, &buffer);
    gl->ReadBuffer(buffer);
    if (gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE)
        return true;
    layer_finish(gl, layer); /* so that the next frame tries again */
    return base_fail(gl->log, DPL_REASON_UNSUPPORTED, "the device cannot draw %d × %d pixels of %s", width, height,
                     format ? "floats with depth" : "depth");
}

void layer_resume(struct dpl_gl *gl, const struct gpu_layer *layer)
{
    gl->BindFramebuffer(GL_FRAMEBUFFER, layer->framebuffer);
    gl->Viewport(0, 0, layer->depth.width, layer->depth.height);
}

void layer_begin(struct dpl_gl *gl, const struct gpu_layer *layer)
{
    layer_resume(gl, layer);
    gl->ClearColor(0, 0, 0, 0);
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void layer_finish(struct dpl_gl *gl, struct gpu_layer *layer)
{
    gl->DeleteFramebuffers(1, &layer->framebuffer);
    texture_finish(gl, &layer->color);
    texture_finish(gl, &layer->depth);
    *layer = (struct gpu_layer){0};
}
