#include "render/difference.h"

#include "dapple/measure.h"
#include "light/map_texture.h"

#define COLORS 257 /* an odd number has one for 0 */

static void update_colors(struct difference *difference, struct dpl_gl *gl)
{
    float colors[COLORS][3];
    if (difference->colors.name)
        return;
    for (int i = 0; i < COLORS; i++)
        dpl_false_color(DPL_COLORS_DIFFERENCE, 2.0 * i / (COLORS - 1) - 1, colors[i]);
    texture_resize(gl, &difference->colors, GL_RGB16F, COLORS, 1, TEXTURE_CLAMP, TEXTURE_LINEAR);
    texture_upload(gl, &difference->colors, colors[0]);
}

bool difference_draw(struct difference *difference, const struct frame *frame, const struct gpu_texture *other,
                     double gain, double range)
{
    struct dpl_gl *gl = frame->gl;
    const struct gpu_program *program = &difference->program;
    double receivers[LIGHT_SLICES_MAX];
    if (!program_ready(gl, &difference->program, "render/difference.glsl", ""))
        return false;
    update_colors(difference, gl);
    scene_receivers(frame->scene, receivers);
    timer_pass(frame->timer, "difference");
    program_use(gl, program);
    program_mat4(gl, program, "view_projection", frame->view_projection);
    program_float(gl, program, "size", frame->scene->settings.size);
    program_float(gl, program, "height", receivers[0]);
    program_float(gl, program, "gain", gain);
    program_float(gl, program, "range", range);
    map_texture_bind(gl, frame->map, frame->windows, frame->scene->settings.size, program, 0);
    texture_bind(gl, other, 1);
    texture_bind(gl, &difference->colors, 2);
    program_int(gl, program, "other_texels", 1);
    program_int(gl, program, "other_channels", map_texture_channels(other));
    program_int(gl, program, "colors", 2);
    gl->BindVertexArray(gl->empty_array);
    gl->DrawArrays(GL_TRIANGLES, 0, 6);
    return true;
}

void difference_finish(struct dpl_gl *gl, struct difference *difference)
{
    program_finish(gl, &difference->program);
    texture_finish(gl, &difference->colors);
}
