/* The GPU's half of coverage.c.
 *
 * Light is added up as whole numbers by compute shaders, so that the order of the additions does not show; where there
 * are none, by blending, whose order OpenGL fixes, into a target with a margin, as what is drawn cannot wrap round. */
#include "light/coverage.h"

#include "base/log.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define ERROR_MIN 0.02 /* of the map: what one footprint for all slopes leaves makes finer maps useless */
#define SPARE 128      /* texels for margins beside a finer sharp map */
#define CELL_MAX 16    /* texels; larger cells are split, for points are not drawn in any size */
#define UNIT 65536.0   /* whole numbers in the light of flat water: the brightest texel may be 65536 times as bright */

/* One picture of the surface's cells on one receiver. */
struct receiver {
    double height;  /* m */
    double flat[3]; /* u, v, q of flat water */
    double absorption[3];
    double offset[2]; /* texels, from the map's corner to where flat water has the first vertex */
    int side, level;  /* texels of the sharp map */
    int cells, split; /* a side of the surface, and that each of them is split into */
    double cell;      /* texels, of what is split */
    double texels_a_meter;
    int widest, margin; /* texels of a cell's image; of the blended light */
    double unit;        /* whole numbers in the light of flat water */
};

/* Whether light of a map of that side is added up by compute shaders: a buffer must hold it. */
static bool is_computed(const struct dpl_gl *gl, int side)
{
    return gl->info.compute && (double)side * side * 3 * sizeof(GLint) <= gl->info.storage_max;
}

static bool is_upwards(const struct light_input *input)
{
    return input->receivers[0] > 0;
}

static struct coverage_flat find_flat(const struct light_input *input, double ior)
{
    double sun[3];
    optics_sun_direction(input->sun, sun);
    return coverage_flat_water(sun, ior, is_upwards(input));
}

void coverage_gpu_draw_rays(struct dpl_gl *gl, const struct gpu_program *program, const struct light_input *input,
                            double ior, struct gpu_texture *rays)
{
    const struct gpu_texture *surface = &input->surface_gpu->texels;
    const struct coverage_flat water = find_flat(input, ior);
    const float per_flux = water.share > 0 ? (float)(1 / (water.sun[1] * water.share)) : 0;
    const float flat[4] = {(float)water.u, (float)water.v, per_flux, 0};
    texture_resize(gl, rays, GL_RGBA32F, surface->width, surface->height, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_draw_to(gl, rays);
    program_use(gl, program);
    surface_gpu_bind(gl, input->surface_gpu, program, 0);
    program_vec3(gl, program, "sun", water.sun);
    program_float(gl, program, "ior", ior);
    program_int(gl, program, "upwards", water.upwards);
    program_vec4s(gl, program, "flat_water", 1, flat);
    gpu_draw_screen(gl);
}

/* Sets the uniforms of coverage_cell.glsl. */
static void bind_cells(struct dpl_gl *gl, const struct gpu_program *program, const struct light_input *input,
                       const struct receiver *receiver, const struct gpu_texture *rays, const double channels[3])
{
    const float flat[4] = {(float)receiver->flat[0], (float)receiver->flat[1], (float)receiver->flat[2], 0};
    double whole[2] = {floor(receiver->offset[0]), floor(receiver->offset[1])};
    const float offset[4] = {(float)whole[0], (float)whole[1], (float)(receiver->offset[0] - whole[0]),
                             (float)(receiver->offset[1] - whole[1])};
    program_use(gl, program);
    texture_bind(gl, rays, 0);
    program_int(gl, program, "rays", 0);
    program_int(gl, program, "choppy", input->surface_gpu->choppy);
    program_int(gl, program, "shifts", input->surface_gpu->choppy ? 1 : 0);
    if (input->surface_gpu->choppy)
        texture_bind(gl, &input->surface_gpu->shifts, 1);
    program_vec4s(gl, program, "flat_water", 1, flat);
    program_vec4s(gl, program, "offset", 1, offset);
    program_vec3(gl, program, "absorption", receiver->absorption);
    program_vec3(gl, program, "channels", channels);
    program_float(gl, program, "receiver", receiver->height);
    program_float(gl, program, "cell", receiver->cell);
    program_float(gl, program, "texels_a_meter", receiver->texels_a_meter);
    program_float(gl, program, "widest", receiver->widest);
    program_int(gl, program, "split", receiver->split);
    program_int(gl, program, "margin", receiver->margin);
    program_int(gl, program, "side", receiver->side);
    program_int(gl, program, "cells", receiver->cells * receiver->split);
    program_int(gl, program, "periodic", input->surface_gpu->periodic);
    program_float(gl, program, "unit", receiver->unit);
}

/* Makes the buffer hold zeros for a map of that side, or leaves it where it holds as many. */
static bool resize_light(struct coverage_gpu *gpu, struct dpl_gl *gl, int side)
{
    if (gpu->light && gpu->light_side >= side)
        return true;
    size_t size = (size_t)side * (size_t)side * 3;
    unsigned *zeros = base_allocate(gl->log, size, sizeof *zeros, "light");
    if (!zeros)
        return false;
    if (!gpu->light)
        gl->GenBuffers(1, &gpu->light);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, gpu->light);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)(size * sizeof *zeros), zeros, GL_DYNAMIC_COPY);
    gpu->light_side = side;
    free(zeros);
    return true;
}

static void compute_cells(struct coverage_gpu *gpu, struct dpl_gl *gl, const struct light_input *input,
                          const struct receiver *receiver, const struct gpu_texture *rays, const double channels[3])
{
    GLuint groups = (GLuint)(receiver->cells * receiver->split + 7) / 8;
    bind_cells(gl, &gpu->add_program, input, receiver, rays, channels);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, gpu->light);
    gl->DispatchCompute(groups, groups, 1);
}

/* `first`: of the passes that draw on this receiver. */
static void blend_cells(struct coverage_gpu *gpu, struct dpl_gl *gl, const struct light_input *input,
                        const struct receiver *receiver, const struct gpu_texture *rays, const double channels[3],
                        bool first)
{
    int side = receiver->side + 2 * receiver->margin, cells = receiver->cells * receiver->split;
    struct gpu_texture *blended = gpu->blended + receiver->level;
    texture_resize(gl, blended, gl->info.float_blend ? GL_RGBA32F : GL_RGBA16F, side, side, TEXTURE_CLAMP,
                   TEXTURE_NEAREST);
    texture_draw_to(gl, blended);
    gl->ClearColor(0, 0, 0, 0);
    if (first)
        gl->Clear(GL_COLOR_BUFFER_BIT);
    bind_cells(gl, &gpu->points_program, input, receiver, rays, channels);
    if (!gl->info.es)
        gl->Enable(GL_PROGRAM_POINT_SIZE);
    gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    gl->BindVertexArray(gl->empty_array);
    gl->DrawArrays(GL_POINTS, 0, cells * cells);
    gl->Disable(GL_BLEND);
    if (!gl->info.es)
        gl->Disable(GL_PROGRAM_POINT_SIZE);
}

/* What was blended, into the framebuffer. */
static void fold(struct coverage_gpu *gpu, struct dpl_gl *gl, const struct light_input *input,
                 const struct receiver *receiver)
{
    const struct gpu_program *program = &gpu->fold_program;
    program_use(gl, program);
    texture_bind(gl, gpu->blended + receiver->level, 0);
    program_int(gl, program, "blended", 0);
    program_int(gl, program, "side", receiver->side);
    program_int(gl, program, "margin", receiver->margin);
    program_int(gl, program, "repeats",
                input->surface_gpu->periodic ? (receiver->margin + receiver->side - 1) / receiver->side : 0);
    gpu_draw_screen(gl);
}

/* What was computed, into the framebuffer. */
static void resolve(struct coverage_gpu *gpu, struct dpl_gl *gl, const struct receiver *receiver)
{
    gl->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    program_use(gl, &gpu->resolve_program);
    program_int(gl, &gpu->resolve_program, "side", receiver->side);
    program_float(gl, &gpu->resolve_program, "unit", receiver->unit);
    gpu_draw_screen(gl);
    gl->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

/* Which of the sharp maps is the disc's: the map's own side and below come first, then finer ones. */
static int level_of(const struct coverage_disc *disc)
{
    return disc->fineness > 1 ? COVERAGE_LEVELS - disc->fineness + 1 : disc->level;
}

static void draw_disc(struct coverage_gpu *gpu, struct dpl_gl *gl, const struct light_input *input,
                      const struct coverage_disc *disc)
{
    const struct gpu_program *program = &gpu->disc_program;
    program_use(gl, program);
    texture_bind(gl, gpu->sharp + level_of(disc), 0);
    program_int(gl, program, "sharp", 0);
    program_int(gl, program, "tap_count", disc->count);
    program_int(gl, program, "periodic", input->surface_gpu->periodic);
    program_vec4s(gl, program, "taps", disc->count, disc->taps[0]);
    gpu_draw_screen(gl);
}

/* The footprints of all receivers; returns the side of the largest sharp map. */
static int make_discs(struct coverage_gpu *gpu, const struct dpl_gl *gl, const struct light_input *input,
                      const struct light_samples *samples, int side)
{
    double error = fmax(input->settings->error / 100, ERROR_MIN);
    int largest = side;
    const struct coverage *params = input->params;
    const struct coverage_flat flat = find_flat(input, input->medium->ior);
    for (int slice = 0; slice < input->slices; slice++) {
        double covariance[3], scale = side / input->windows[slice].side;
        coverage_mean_footprint(input, samples, &flat, input->receivers[slice], covariance);
        for (int c = 0; c < 3; c++)
            covariance[c] *= scale * scale;
        double radius = 2 * sqrt(fmax(covariance[0], covariance[2]));
        int fineness = params->fineness < COVERAGE_FINEST ? params->fineness : COVERAGE_FINEST;
        if (fineness == 0)
            fineness =
                coverage_choose_fineness(samples, &flat, input->receivers[slice], radius, error, COVERAGE_FINEST);
        while (fineness > 1 && side * fineness + SPARE > gl->info.texture_max)
            fineness--;
        coverage_disc_make(gpu->discs + slice, side, covariance, coverage_disc_fineness(radius, fineness));
        largest = gpu->discs[slice].side > largest ? gpu->discs[slice].side : largest;
    }
    return largest;
}

static struct receiver find_receiver(const struct dpl_gl *gl, const struct light_input *input, int slice, double ior,
                                     const struct coverage_disc *disc, bool computed)
{
    const struct surface_gpu *surface = input->surface_gpu;
    const struct ray_window *window = input->windows + slice;
    struct receiver receiver = {.height = input->receivers[slice], .side = disc->side, .level = level_of(disc)};
    const struct coverage_flat water = find_flat(input, ior);
    receiver.flat[0] = water.u;
    receiver.flat[1] = water.v;
    receiver.flat[2] = water.q;
    receiver.cells = surface->texels.width - (surface->periodic ? 0 : 1);
    receiver.split = (int)(surface->size / window->side * receiver.side / receiver.cells) / CELL_MAX + 1;
    receiver.texels_a_meter = receiver.side / window->side;
    receiver.cell = surface->size * receiver.texels_a_meter / receiver.cells / receiver.split;
    receiver.widest = (int)(64 + 4 * receiver.cell);
    if (!computed && receiver.widest > gl->info.point_max - 2)
        receiver.widest = gl->info.point_max > CELL_MAX ? gl->info.point_max - 2 : CELL_MAX;
    double side = receiver.side, least = UNIT * fmax(1, pow(receiver.cell, -2)); /* so that a cell has many */
    receiver.unit = fmin(least, fmax(UNIT, 0x1p28 / (side * side)));             /* so that a texel can hold all */
    receiver.margin = receiver.widest / 2 + 2;
    for (int i = 0; i < 2; i++) {
        double corner = -surface->size / 2 - (i == 0 ? window->x : window->z);
        receiver.offset[i] = (corner + receiver.flat[i] * receiver.height) * receiver.texels_a_meter;
        const double outside = 1e7; /* texels: whatever lies there is not seen */
        if (surface->periodic)
            receiver.offset[i] = fmod(receiver.offset[i], receiver.side);
        receiver.offset[i] = fmin(fmax(receiver.offset[i], -outside), outside);
    }
    struct optics_water optics = water_optics(input->medium);
    for (int c = 0; c < 3 && !is_upwards(input); c++)
        receiver.absorption[c] = optics.absorption[c];
    return receiver;
}

static bool build_programs(struct coverage_gpu *gpu, struct dpl_gl *gl)
{
    bool built = program_ready(gl, &gpu->rays_program, "light/coverage_rays.glsl", "") &&
                 program_ready(gl, &gpu->disc_program, "light/coverage_disc.glsl", "");
    if (gpu->computed)
        return built && program_compute_ready(gl, &gpu->add_program, "light/coverage_add.glsl", "") &&
               program_ready(gl, &gpu->resolve_program, "light/coverage_resolve.glsl", "");
    return built && program_ready(gl, &gpu->points_program, "light/coverage_points.glsl", "") &&
           program_ready(gl, &gpu->fold_program, "light/coverage_fold.glsl", "");
}

/* The light of a point sun. `passes`: 1, or 3 with an index for each colour. */
static struct receiver add_cells(struct coverage_gpu *gpu, struct dpl_gl *gl, const struct light_input *input,
                                 int passes, const double *ior, int slice)
{
    static const double all[3] = {1, 1, 1}, one[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    struct receiver receiver = {0};
    for (int pass = 0; pass < passes; pass++) {
        const double *channels = passes == 1 ? all : one[pass];
        receiver = find_receiver(gl, input, slice, ior[pass], gpu->discs + slice, gpu->computed);
        if (gpu->computed)
            compute_cells(gpu, gl, input, &receiver, gpu->rays + pass, channels);
        else
            blend_cells(gpu, gl, input, &receiver, gpu->rays + pass, channels, pass == 0);
    }
    return receiver;
}

static void draw_slice(struct coverage_gpu *gpu, struct dpl_gl *gl, const struct light_input *input, int passes,
                       const double *ior, struct gpu_texture *map, int slice)
{
    struct coverage_disc *disc = gpu->discs + slice;
    struct gpu_texture *sharp = gpu->sharp;
    struct receiver receiver = add_cells(gpu, gl, input, passes, ior, slice);
    if (disc->count == 0) {
        texture_draw_to_layer(gl, map, slice);
    } else {
        sharp += level_of(disc);
        texture_resize(gl, sharp, disc->level ? GL_RGBA16F : GL_RGBA32F, receiver.side, receiver.side,
                       input->surface_gpu->periodic ? TEXTURE_REPEAT : TEXTURE_CLAMP,
                       disc->level ? TEXTURE_LINEAR : TEXTURE_NEAREST);
        texture_draw_to(gl, sharp);
    }
    if (gpu->computed)
        resolve(gpu, gl, &receiver);
    else
        fold(gpu, gl, input, &receiver);
    if (disc->count > 0) {
        texture_draw_to_layer(gl, map, slice);
        draw_disc(gpu, gl, input, disc);
    }
}

bool coverage_gpu_draw(struct coverage_gpu *gpu, struct dpl_gl *gl, const struct light_input *input,
                       const struct light_samples *samples, struct gpu_texture *map)
{
    double iors[3];
    int passes = input->medium->dispersion > 0 ? 3 : 1, largest = make_discs(gpu, gl, input, samples, map->width);
    gpu->computed = is_computed(gl, largest);
    if (!build_programs(gpu, gl) || (gpu->computed && !resize_light(gpu, gl, largest)))
        return false;
    water_refractive_indices(input->medium, iors);
    if (passes == 1)
        iors[0] = input->medium->ior;
    for (int pass = 0; pass < passes; pass++)
        coverage_gpu_draw_rays(gl, &gpu->rays_program, input, iors[pass], gpu->rays + pass);
    for (int slice = 0; slice < input->slices; slice++)
        draw_slice(gpu, gl, input, passes, iors, map, slice);
    return true;
}

void coverage_gpu_finish(struct coverage_gpu *gpu, struct dpl_gl *gl)
{
    program_finish(gl, &gpu->rays_program);
    program_finish(gl, &gpu->add_program);
    program_finish(gl, &gpu->points_program);
    program_finish(gl, &gpu->resolve_program);
    program_finish(gl, &gpu->fold_program);
    program_finish(gl, &gpu->disc_program);
    for (int i = 0; i < 3; i++)
        texture_finish(gl, gpu->rays + i);
    for (int i = 0; i < COVERAGE_LEVELS; i++) {
        texture_finish(gl, gpu->sharp + i);
        texture_finish(gl, gpu->blended + i);
    }
    gl->DeleteBuffers(1, &gpu->light);
    *gpu = (struct coverage_gpu){0};
}
