#include "render/tone.h"

#include <math.h>

bool tone_ready(struct dpl_gl *gl, struct tone *tone, int width, int height, int samples)
{
    if (samples > 1)
        texture_resize(gl, &tone->mean, GL_RGBA16F, width, height, TEXTURE_CLAMP, TEXTURE_NEAREST);
    return target_resize(gl, &tone->radiance, GL_RGBA16F, width, height, 1) &&
           program_ready(gl, &tone->add, "render/tone_add.glsl", "") &&
           program_ready(gl, &tone->show, "render/tone.glsl", "");
}

/* A lattice that fills the pixel evenly for every count (Roberts 2018). */
void tone_place(int index, int count, double place[2])
{
    place[0] = count == 1 ? 0 : fmod(0.5 + 0.7548776662466927 * index, 1) - 0.5;
    place[1] = count == 1 ? 0 : fmod(0.5 + 0.5698402909980532 * index, 1) - 0.5;
}

void tone_add(struct dpl_gl *gl, struct tone *tone, int index)
{
    texture_draw_to(gl, &tone->mean);
    program_use(gl, &tone->add);
    texture_bind(gl, &tone->radiance.color, 0);
    program_int(gl, &tone->add, "radiance", 0);
    program_float(gl, &tone->add, "share", 1.0 / (index + 1));
    if (index > 0)
        gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gpu_draw_screen(gl);
    gl->Disable(GL_BLEND);
}

struct gpu_texture *tone_radiance(struct tone *tone, int samples)
{
    return samples > 1 ? &tone->mean : &tone->radiance.color;
}

void tone_show(struct tone *tone, const struct frame *frame)
{
    struct dpl_gl *gl = frame->gl;
    const struct scene_render *render = &frame->scene->render;
    double exposure[3];
    for (int c = 0; c < 3; c++)
        exposure[c] = M_PI * exp2(frame->camera->exposure) / fmax(frame->camera->white[c], 1e-3);
    program_use(gl, &tone->show);
    texture_bind(gl, tone_radiance(tone, render->samples), 0);
    program_int(gl, &tone->show, "radiance", 0);
    program_vec3(gl, &tone->show, "exposure", exposure);
    program_int(gl, &tone->show, "filmic", render->tone == SCENE_TONE_FILMIC);
    program_vec2(gl, &tone->show, "corner", frame->view.left, frame->view.bottom);
    gpu_draw_screen(gl);
}

void tone_finish(struct dpl_gl *gl, struct tone *tone)
{
    target_finish(gl, &tone->radiance);
    texture_finish(gl, &tone->mean);
    program_finish(gl, &tone->add);
    program_finish(gl, &tone->show);
}
