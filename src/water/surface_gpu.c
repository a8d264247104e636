#include "water/surface_gpu.h"

#include "base/log.h"

#include <stdlib.h>
#include <string.h>

bool surface_gpu_can_evaluate(const struct dpl_gl *gl, const struct water_model *model)
{
    return gl && gl->info.float_render && (model->shader || model->draw);
}

/* One pass of a model's shader file over the grid. */
static bool draw_shader(struct dpl_gl *gl, struct gpu_program *program, const char *defines, GLenum format,
                        struct gpu_texture *texture, const struct water_model *model, const struct water_setup *setup,
                        double time)
{
    if (!program_ready(gl, program, model->shader, defines))
        return false;
    struct water_shape shape = model->shape(setup);
    float constants[WATER_CONSTANTS_MAX][4] = {{0}};
    int count = model->constants(setup, time, constants);
    texture_resize(gl, texture, format, shape.side, shape.side, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_draw_to(gl, texture);
    program_use(gl, program);
    program_vec4s(gl, program, "constants", count, constants[0]);
    program_float(gl, program, "size", setup->size);
    program_float(gl, program, "spacing", setup->size / (shape.periodic ? shape.side : shape.side - 1));
    gpu_draw_screen(gl);
    return true;
}

bool surface_gpu_evaluate(struct dpl_gl *gl, struct surface_gpu *surface, const struct water_model *model,
                          const struct water_setup *setup, double time)
{
    struct water_shape shape = model->shape(setup);
    if (surface->model != model) {
        program_finish(gl, &surface->program);
        program_finish(gl, &surface->shift_program);
        surface->model = model;
    }
    surface->size = setup->size;
    surface->periodic = shape.periodic;
    surface->choppy = shape.choppy;
    if (model->draw)
        return model->draw(water_state(model, setup, gl->log), gl, setup, time, &surface->texels, &surface->shifts);
    return draw_shader(gl, &surface->program, "", GL_RGBA32F, &surface->texels, model, setup, time) &&
           (!shape.choppy || draw_shader(gl, &surface->shift_program, "#define SHIFTS\n", GL_RG32F, &surface->shifts,
                                         model, setup, time));
}

bool surface_gpu_flatten(struct dpl_gl *gl, const struct surface_gpu *from, struct surface_gpu *to)
{
    if (!program_ready(gl, &to->program, "water/flatten.glsl", ""))
        return false;
    to->size = from->size;
    to->periodic = from->periodic;
    texture_resize(gl, &to->texels, GL_RGBA32F, from->texels.width, from->texels.height, TEXTURE_CLAMP,
                   TEXTURE_NEAREST);
    texture_draw_to(gl, &to->texels);
    program_use(gl, &to->program);
    surface_gpu_bind(gl, from, &to->program, 0);
    gpu_draw_screen(gl);
    return true;
}

void surface_gpu_upload(struct dpl_gl *gl, struct surface_gpu *surface, const struct surface *from)
{
    surface->size = from->size;
    surface->periodic = from->periodic;
    surface->choppy = from->shifts;
    texture_resize(gl, &surface->texels, GL_RGB32F, from->columns, from->rows, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_upload(gl, &surface->texels, from->texels);
    if (!from->shifts)
        return;
    texture_resize(gl, &surface->shifts, GL_RG32F, from->columns, from->rows, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_upload(gl, &surface->shifts, from->shifts);
}

/* The first channels of a texture; `room` is for 4 a texel. */
static void read_texture(struct dpl_gl *gl, struct gpu_texture *texture, size_t channels, float *room, float *out)
{
    texture_draw_to(gl, texture);
    gl->ReadPixels(0, 0, texture->width, texture->height, GL_RGBA, GL_FLOAT, room);
    for (size_t i = 0; i < (size_t)texture->width * (size_t)texture->height; i++)
        memcpy(out + i * channels, room + i * 4, channels * sizeof(float));
}

bool surface_gpu_read(struct dpl_gl *gl, struct surface_gpu *surface, struct surface *to)
{
    int columns = surface->texels.width, rows = surface->texels.height;
    float *room = base_allocate(gl->log, (size_t)columns * (size_t)rows * 4, sizeof *room, "water surface");
    bool ok = room && surface_resize(to, columns, rows, surface->periodic, surface->choppy, surface->size, gl->log);
    if (ok)
        read_texture(gl, &surface->texels, 3, room, to->texels);
    if (ok && surface->choppy)
        read_texture(gl, &surface->shifts, 2, room, to->shifts);
    free(room);
    return ok;
}

void surface_gpu_bind(struct dpl_gl *gl, const struct surface_gpu *surface, const struct gpu_program *program, int unit)
{
    texture_bind(gl, &surface->texels, (GLenum)unit);
    program_int(gl, program, "surface_texels", unit);
    program_int(gl, program, "surface_periodic", surface->periodic);
    program_float(gl, program, "surface_size", surface->size);
    program_int(gl, program, "surface_choppy", surface->choppy);
    if (surface->choppy)
        texture_bind(gl, &surface->shifts, GPU_TEXTURE_UNITS - 1);
    program_int(gl, program, "surface_shifts", surface->choppy ? GPU_TEXTURE_UNITS - 1 : unit);
}

void surface_gpu_finish(struct dpl_gl *gl, struct surface_gpu *surface)
{
    program_finish(gl, &surface->program);
    program_finish(gl, &surface->shift_program);
    texture_finish(gl, &surface->texels);
    texture_finish(gl, &surface->shifts);
}
