#include "water/surface_gpu.h"

#include "base/log.h"

#include <stdlib.h>
#include <string.h>

bool surface_gpu_can_evaluate(const struct dpl_gl *gl, const struct water_model *model)
{
    return gl && gl->info.float_render && model->shader;
}

bool surface_gpu_evaluate(struct dpl_gl *gl, struct surface_gpu *surface, const struct water_model *model,
                          const struct water_setup *setup, double time)
{
    if (surface->model != model) {
        program_finish(gl, &surface->program);
        surface->model = model;
    }
    if (!program_ready(gl, &surface->program, model->shader, ""))
        return false;
    int side = model->grid(setup);
    float constants[WATER_CONSTANTS_MAX][4] = {{0}};
    int count = model->constants(setup, time, constants);
    surface->size = setup->size;
    surface->periodic = model->periodic;
    texture_resize(gl, &surface->texels, GL_RGBA32F, side, side, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_draw_to(gl, &surface->texels);
    program_use(gl, &surface->program);
    program_vec4s(gl, &surface->program, "constants", count, constants[0]);
    program_float(gl, &surface->program, "size", setup->size);
    program_float(gl, &surface->program, "spacing", setup->size / (model->periodic ? side : side - 1));
    gpu_draw_screen(gl);
    return true;
}

void surface_gpu_upload(struct dpl_gl *gl, struct surface_gpu *surface, const struct surface *from)
{
    surface->size = from->size;
    surface->periodic = from->periodic;
    texture_resize(gl, &surface->texels, GL_RGB32F, from->columns, from->rows, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_upload(gl, &surface->texels, from->texels);
}

bool surface_gpu_read(struct dpl_gl *gl, struct surface_gpu *surface, struct surface *to)
{
    int columns = surface->texels.width, rows = surface->texels.height;
    size_t count = (size_t)columns * (size_t)rows;
    float *texels = base_allocate(gl->log, count * 4, sizeof *texels, "water surface");
    bool ok = texels && surface_resize(to, columns, rows, surface->periodic, false, surface->size, gl->log);
    if (ok) {
        texture_draw_to(gl, &surface->texels);
        gl->ReadPixels(0, 0, columns, rows, GL_RGBA, GL_FLOAT, texels);
        for (size_t i = 0; i < count; i++)
            memcpy(to->texels + i * 3, texels + i * 4, 3 * sizeof(float));
    }
    free(texels);
    return ok;
}

void surface_gpu_bind(struct dpl_gl *gl, const struct surface_gpu *surface, const struct gpu_program *program, int unit)
{
    texture_bind(gl, &surface->texels, (GLenum)unit);
    program_int(gl, program, "surface_texels", unit);
    program_int(gl, program, "surface_periodic", surface->periodic);
    program_float(gl, program, "surface_size", surface->size);
}

void surface_gpu_finish(struct dpl_gl *gl, struct surface_gpu *surface)
{
    program_finish(gl, &surface->program);
    texture_finish(gl, &surface->texels);
}
