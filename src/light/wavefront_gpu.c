/* The GPU's half of wavefront.c: the mesh drawn straight into the map.
 *
 * What is drawn beyond the map does not come in at its other side by itself. Periodic water is drawn once more for each
 * neighbouring tile, as far as its light may reach the map. */
#include "light/wavefront.h"

#include "base/log.h"

#include <math.h>

#define STRAY_MARGIN 2.0 /* times how far light strays at some places: as far as it may at any */
#define TURNS_MAX 4      /* tiles away, that light may come from */

/* What is drawn. */
struct drawing {
    const struct wavefront_receiver *receiver;
    const struct gpu_program *program;
    int side, cells;
    double stray;   /* texels from where flat water has it, that light may arrive at */
    bool triangles; /* of their own vertices, not in strips */
};

static int cells_of(const struct surface_gpu *surface)
{
    return surface->texels.width - (surface->periodic ? 0 : 1);
}

static enum wavefront_variant variant_of(const struct dpl_gl *gl, const struct wavefront *params)
{
    enum wavefront_variant wanted = (enum wavefront_variant)params->variant;
    return wanted == WAVEFRONT_GEOMETRY && !gl->info.geometry ? WAVEFRONT_NEIGHBOURS : wanted;
}

static bool build_programs(struct wavefront_state *state, struct dpl_gl *gl, enum wavefront_variant variant)
{
    struct gpu_program *program = state->programs + variant;
    struct surface_gpu *mesh = &state->mesh_gpu;
    if (!program_ready(gl, &mesh->program, "light/wavefront_mesh.glsl", "") ||
        !program_ready(gl, &mesh->shift_program, "light/wavefront_mesh.glsl", "#define SHIFTS\n") ||
        !program_ready(gl, &state->rays_program, "light/coverage_rays.glsl", ""))
        return false;
    if (variant == WAVEFRONT_DERIVATIVES)
        return program_ready(gl, program, "light/wavefront_derivatives.glsl", "");
    if (variant == WAVEFRONT_NEIGHBOURS)
        return program_ready(gl, program, "light/wavefront_neighbours.glsl", "");
    return program_geometry_ready(gl, program, "light/wavefront_geometry.glsl", "");
}

static void draw_numbers(struct dpl_gl *gl, const struct gpu_program *program, const struct surface_gpu *surface,
                         GLenum format, int cells, struct gpu_texture *numbers)
{
    int side = surface->periodic ? cells : cells + 1;
    texture_resize(gl, numbers, format, side, side, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_draw_to(gl, numbers);
    program_use(gl, program);
    surface_gpu_bind(gl, surface, program, 0);
    program_float(gl, program, "stride", (double)cells_of(surface) / cells);
    gpu_draw_screen(gl);
}

/* The surface at the vertices of a mesh of that many cells a side. */
static void draw_mesh(struct wavefront_state *state, struct dpl_gl *gl, const struct surface_gpu *surface, int cells)
{
    struct surface_gpu *mesh = &state->mesh_gpu;
    mesh->size = surface->size;
    mesh->periodic = surface->periodic;
    mesh->choppy = surface->choppy;
    draw_numbers(gl, &mesh->program, surface, GL_RGBA32F, cells, &mesh->texels);
    if (surface->choppy)
        draw_numbers(gl, &mesh->shift_program, surface, GL_RG32F, cells, &mesh->shifts);
}

/* How far light strays from where flat water has it, in texels: the most at some places of the water, and more. */
static double find_stray(const struct light_samples *samples, const struct wavefront_receiver *receiver)
{
    double most = 0, height = receiver->height;
    for (int i = 0; i < LIGHT_SAMPLES; i++) {
        double slopes[2] = {samples->slopes[0][i], samples->slopes[1][i]}, uvq[3], way = height - samples->height[i];
        if (!coverage_ray(receiver->flat.sun, receiver->flat.ior, receiver->flat.upwards, slopes, uvq))
            continue;
        way = way * height > 0 ? way : 0;
        most = fmax(most, fabs(uvq[0] * way - receiver->flat.u * height + samples->shifts[0][i]));
        most = fmax(most, fabs(uvq[1] * way - receiver->flat.v * height + samples->shifts[1][i]));
    }
    return most * STRAY_MARGIN * receiver->scale + receiver->cell;
}

static void bind_mesh(struct dpl_gl *gl, const struct light_input *input, const struct drawing *drawing,
                      const struct gpu_texture *bent)
{
    const struct wavefront *params = input->params;
    const struct surface_gpu *surface = input->surface_gpu;
    const struct wavefront_receiver *receiver = drawing->receiver;
    const struct gpu_program *program = drawing->program;
    const float flat[4] = {(float)receiver->flat.u, (float)receiver->flat.v, (float)receiver->flat.q, 0};
    program_use(gl, program);
    texture_bind(gl, bent, 0);
    program_int(gl, program, "rays", 0);
    program_int(gl, program, "choppy", surface->choppy);
    program_int(gl, program, "shifts", surface->choppy ? 1 : 0);
    if (surface->choppy)
        texture_bind(gl, &surface->shifts, 1);
    program_vec4s(gl, program, "flat_water", 1, flat);
    program_vec3(gl, program, "absorption", receiver->absorption);
    program_float(gl, program, "receiver", receiver->height);
    program_float(gl, program, "texels_a_meter", receiver->scale);
    program_float(gl, program, "cell", receiver->cell);
    program_float(gl, program, "side", drawing->side);
    program_float(gl, program, "most", params->most);
    program_int(gl, program, "lengths", params->area == WAVEFRONT_LENGTHS);
    program_int(gl, program, "weights", params->weights);
}

/* Cells of the mesh along one axis. */
struct stretch {
    int first, count;
};

/* Those whose light may reach the map where the first one is `start` texels from its edge. */
static struct stretch find_stretch(const struct drawing *drawing, double start)
{
    double first = floor((-drawing->stray - start) / drawing->receiver->cell);
    double end = ceil((drawing->side + drawing->stray - start) / drawing->receiver->cell);
    first = fmin(fmax(first, 0), drawing->cells);
    end = fmin(fmax(end, first), drawing->cells);
    return (struct stretch){(int)first, (int)(end - first)};
}

static void draw_part(struct dpl_gl *gl, const struct drawing *drawing, const double start[2])
{
    struct stretch x = find_stretch(drawing, start[0]), z = find_stretch(drawing, start[1]);
    const float part[4] = {(float)x.first, (float)z.first, (float)start[0], (float)start[1]};
    if (x.count == 0 || z.count == 0)
        return;
    program_vec4s(gl, drawing->program, "part", 1, part);
    if (drawing->triangles)
        gl->DrawArraysInstanced(GL_TRIANGLES, 0, 6 * x.count, z.count);
    else
        gl->DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 2 * x.count + 2, z.count);
}

/* The mesh, and its repetitions as far as they are seen. */
static void draw_tiles(struct dpl_gl *gl, const struct drawing *drawing)
{
    const struct wavefront_receiver *receiver = drawing->receiver;
    double period = receiver->period;
    int turns = period > 0 ? (int)fmin(ceil(drawing->stray / period) + 1, TURNS_MAX) : 0;
    for (int z = -turns; z <= turns; z++)
        for (int x = -turns; x <= turns; x++)
            draw_part(gl, drawing,
                      (const double[2]){receiver->offset[0] + x * period, receiver->offset[1] + z * period});
}

static void draw_slice(struct wavefront_state *state, struct dpl_gl *gl, const struct light_input *input,
                       struct gpu_texture *map, int slice)
{
    const struct wavefront *params = input->params;
    int cells = cells_of(input->surface_gpu);
    const struct wavefront_receiver receiver =
        wavefront_receiver_find(input, slice, map->width, cells, input->surface_gpu->periodic);
    enum wavefront_variant variant = variant_of(gl, params);
    const struct drawing drawing = {
        .receiver = &receiver,
        .program = state->programs + variant,
        .side = map->width,
        .cells = cells,
        .stray = receiver.period > 0 ? find_stray(&state->samples, &receiver) : INFINITY,
        .triangles = variant == WAVEFRONT_NEIGHBOURS,
    };
    texture_draw_to_layer(gl, map, slice);
    gl->ClearColor(0, 0, 0, 0);
    gl->Clear(GL_COLOR_BUFFER_BIT);
    bind_mesh(gl, input, &drawing, &state->bent);
    if (params->folds == WAVEFRONT_ADD)
        gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    gl->BindVertexArray(gl->empty_array);
    draw_tiles(gl, &drawing);
    gl->Disable(GL_BLEND);
}

bool wavefront_draw(void *state_, struct dpl_gl *gl, const struct light_input *input, struct gpu_texture *map)
{
    struct wavefront_state *state = state_;
    const struct wavefront *params = input->params;
    struct light_input meshed = *input;
    int cells = params->mesh ? params->mesh : cells_of(input->surface_gpu);
    if (cells >= gl->info.texture_max)
        return base_fail(gl->log, DPL_REASON_LIMIT, "wavefront.mesh: too large for this device: %d (at most %d)", cells,
                         gl->info.texture_max - 1);
    if (!build_programs(state, gl, variant_of(gl, params)))
        return false;
    if (cells != cells_of(input->surface_gpu)) {
        draw_mesh(state, gl, input->surface_gpu, cells);
        meshed.surface_gpu = &state->mesh_gpu;
    }
    coverage_gpu_draw_rays(gl, &state->rays_program, &meshed, input->medium->ior, &state->bent);
    if (meshed.surface_gpu->periodic)
        light_samples_take(&state->samples, input->model, input->setup, input->time);
    for (int slice = 0; slice < input->slices; slice++)
        draw_slice(state, gl, &meshed, map, slice);
    return true;
}

void wavefront_gpu_finish(struct wavefront_state *state, struct dpl_gl *gl)
{
    program_finish(gl, &state->rays_program);
    for (int i = 0; i < WAVEFRONT_VARIANTS; i++)
        program_finish(gl, state->programs + i);
    surface_gpu_finish(gl, &state->mesh_gpu);
    texture_finish(gl, &state->bent);
}
