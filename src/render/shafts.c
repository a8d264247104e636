/* Light shafts, seen from in the water: marched in a small picture, smoothed, and read by those who draw the large one.
 */
#include "render/physical.h"

#include "base/blue_noise.h"

#include <math.h>

static void make_noise(struct shafts *shafts, struct dpl_gl *gl)
{
    enum { COUNT = BLUE_NOISE_SIDE * BLUE_NOISE_SIDE };
    float texels[COUNT * 2];
    int ranks[COUNT];
    for (int channel = 0; channel < 2; channel++) {
        blue_noise(channel, ranks);
        for (int i = 0; i < COUNT; i++)
            texels[2 * i + channel] = ((float)ranks[i] + 0.5f) / COUNT;
    }
    texture_resize(gl, &shafts->noise, GL_RG32F, BLUE_NOISE_SIDE, BLUE_NOISE_SIDE, TEXTURE_REPEAT, TEXTURE_NEAREST);
    texture_upload(gl, &shafts->noise, texels);
}

bool shafts_prepare(struct shafts *shafts, const struct frame *frame, const struct quality *quality)
{
    struct dpl_gl *gl = frame->gl;
    int share = quality->shaft_share;
    int width = (frame->view.columns + share - 1) / share, height = (frame->view.rows + share - 1) / share;
    if (!shafts->noise.name)
        make_noise(shafts, gl);
    texture_resize(gl, &shafts->raw, GL_RGBA16F, width, height, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_resize(gl, &shafts->smooth, GL_RGBA16F, width, height, TEXTURE_CLAMP, TEXTURE_NEAREST);
    return program_ready(gl, &shafts->program, "render/shafts.glsl", "") &&
           program_ready(gl, &shafts->smooth_program, "render/shafts_smooth.glsl", "");
}

void shafts_draw(struct physical *physical, const struct frame *frame)
{
    struct dpl_gl *gl = frame->gl;
    struct shafts *shafts = &physical->shafts;
    const struct gpu_program *march = &shafts->program;
    double high = sqrt(frame->rays.up[0] * frame->rays.up[0] + frame->rays.up[1] * frame->rays.up[1] +
                       frame->rays.up[2] * frame->rays.up[2]);
    texture_draw_to(gl, &shafts->raw);
    program_use(gl, march);
    physical_bind(physical, frame, march);
    physical_bind_layers(physical, frame, march);
    texture_bind(gl, &shafts->noise, UNIT_NOISE);
    program_int(gl, march, "noise", UNIT_NOISE);
    program_vec2(gl, march, "shafts_corner", frame->view.left / physical->quality.shaft_share,
                 frame->view.bottom / physical->quality.shaft_share);
    program_int(gl, march, "steps", physical->quality.shaft_steps);
    program_float(gl, march, "pixel", 2 * high / shafts->raw.height);
    gpu_draw_screen(gl);
    texture_draw_to(gl, &shafts->smooth);
    program_use(gl, &shafts->smooth_program);
    texture_bind(gl, &shafts->raw, UNIT_SHAFTS);
    program_int(gl, &shafts->smooth_program, "shafts_texels", UNIT_SHAFTS);
    gpu_draw_screen(gl);
}

void shafts_finish(struct shafts *shafts, struct dpl_gl *gl)
{
    program_finish(gl, &shafts->program);
    program_finish(gl, &shafts->smooth_program);
    texture_finish(gl, &shafts->raw);
    texture_finish(gl, &shafts->smooth);
    texture_finish(gl, &shafts->noise);
}
