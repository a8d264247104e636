#include "render/waves.h"

#include <math.h>

#define WALL 0.005 /* m */

enum { UNIT_SURFACE };

/* How far and how steeply the surface departs from its rest, from points all over the tile; of how far, something more
 * for what lies between them. */
static void measure(struct waves *waves, const struct frame *frame)
{
    enum { SIDE = 16 };
    double x[SIDE * SIDE], z[SIDE * SIDE], height[SIDE * SIDE], slopes[2][SIDE * SIDE], shifts[2][SIDE * SIDE],
        area[SIDE * SIDE], size = frame->scene->settings.size, reach = 0, square = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        x[i] = ((i % SIDE + 0.5) / SIDE - 0.5) * size;
        z[i] = ((i / SIDE + 0.5) / SIDE - 0.5) * size;
    }
    struct water_points points = {SIDE * SIDE, x, z, height, slopes[0], slopes[1], shifts[0], shifts[1], area};
    water_sample(water_models[frame->scene->medium.model], frame->setup, frame->time, &points);
    for (int i = 0; i < SIDE * SIDE; i++) {
        reach = fmax(reach, fabs(height[i]));
        square += slopes[0][i] * slopes[0][i] + slopes[1][i] * slopes[1][i];
    }
    waves->reach = 2 * reach + 0.05;
    waves->slope = sqrt(square / (SIDE * SIDE));
}

bool waves_update(struct waves *waves, const struct frame *frame)
{
    struct dpl_gl *gl = frame->gl;
    const struct surface_gpu *surface = frame->above;
    if (!program_ready(gl, &waves->make, "render/waves_make.glsl", ""))
        return false;
    texture_resize(gl, &waves->texels, GL_RGBA16F, surface->texels.width, surface->texels.height,
                   surface->periodic ? TEXTURE_REPEAT : TEXTURE_CLAMP, TEXTURE_MIPMAP);
    texture_draw_to(gl, &waves->texels);
    program_use(gl, &waves->make);
    surface_gpu_bind(gl, surface, &waves->make, UNIT_SURFACE);
    gpu_draw_screen(gl);
    texture_make_mipmaps(gl, &waves->texels);
    measure(waves, frame);
    return true;
}

double waves_extent(const struct frame *frame)
{
    const struct scene_settings *settings = &frame->scene->settings;
    return settings->edge != SCENE_EDGE_OPEN || !frame->above->periodic ? settings->size / 2 : 0;
}

void waves_bind(const struct waves *waves, const struct frame *frame, const struct gpu_program *program, int unit)
{
    struct dpl_gl *gl = frame->gl;
    const struct surface_gpu *surface = frame->above;
    int cells = surface->texels.width - (surface->periodic ? 0 : 1);
    texture_bind(gl, &waves->texels, (GLenum)unit);
    program_int(gl, program, "waves_texels", unit);
    program_float(gl, program, "waves_size", surface->size);
    program_float(gl, program, "waves_spacing", surface->size / cells);
    program_float(gl, program, "waves_extent", waves_extent(frame));
    program_float(gl, program, "waves_wall",
                  waves_extent(frame) + (frame->scene->settings.edge == SCENE_EDGE_GLASS ? -WALL : WALL));
    program_float(gl, program, "waves_roughness", frame->scene->medium.roughness * frame->scene->medium.roughness);
}

void waves_finish(struct waves *waves, struct dpl_gl *gl)
{
    program_finish(gl, &waves->make);
    texture_finish(gl, &waves->texels);
}
