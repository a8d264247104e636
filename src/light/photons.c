/* Forward ray tracing, the naive way (as the articles tell it that look for something cheaper): light is shot from the
 * sun at the water, and counted in the texel that it hits.
 *
 *   1. a photon takes a place of the surface and of the sun's disc by chance
 *   2. the surface there, by straight lines between vertices, refracts it or throws it back
 *   3. its weight is added to the texel that it falls on, or shared out among the four around it
 *
 * Grain falls with the square root of the number of photons. `reference` sends them evenly, through the water's own
 * surface, and until there are enough. */
#include "light/tracing_gpu.h"

#include <math.h>

#define SIDE_MAX 32768 /* squares of photons along a side of the surface */
#define MARGIN 2       /* texels around the map that a photon on its edge lights */

enum spread { SPREAD_NEAREST, SPREAD_BILINEAR };

struct photons {
    int count;
    int spread; /* enum spread */
};

static const char *spread_name(int i)
{
    static const char *const names[] = {"nearest", "bilinear", NULL};
    return i >= 0 && i <= SPREAD_BILINEAR ? names[i] : NULL;
}

static const struct dpl_param params[] = {
    PARAM_INT(struct photons, count, 16, 1, 4096, "", "photons to send for each texel"),
    PARAM_CHOICE(struct photons, spread, SPREAD_NEAREST, spread_name,
                 "nearest: a photon lights the texel it falls on; bilinear: the four around it, softer"),
    PARAM_END,
};

struct state {
    struct tracing_sums sums;
    struct gpu_program program;
    struct tracing_blend blend;
};

/* What is the same for all photons on one receiver. */
struct task {
    const struct light_input *input;
    struct tracing_surface surface;
    struct tracing_view view;
    double receiver; /* m */
    struct optics_disc disc;
    struct ray_medium rays;
};

static void put(const struct task *task, double x, double z, const double light[3], struct tracing_sums *sums)
{
    const struct photons *p = task->input->params;
    if (p->spread == SPREAD_NEAREST) {
        tracing_sums_add(sums, (int)floor(x), (int)floor(z), light);
        return;
    }
    double left = floor(x - 0.5), upper = floor(z - 0.5), right_share = x - 0.5 - left, lower_share = z - 0.5 - upper;
    for (int k = 0; k < 4; k++) {
        double share = (k % 2 ? right_share : 1 - right_share) * (k / 2 ? lower_share : 1 - lower_share);
        const double part[3] = {share * light[0], share * light[1], share * light[2]};
        tracing_sums_add(sums, (int)left + k % 2, (int)upper + k / 2, part);
    }
}

/* A photon's light on the receiver, and where a periodic surface repeats it. */
static void land(const struct task *task, const struct ray_hit *hit, const double light[3], struct tracing_sums *sums)
{
    const struct tracing_view *view = &task->view;
    double x = (hit->x - view->corner[0]) * view->texels_a_meter, first_x;
    double z = (hit->z - view->corner[1]) * view->texels_a_meter, first_z;
    int columns = tracing_copies(view, x - 1, x + 1, &first_x), rows = tracing_copies(view, z - 1, z + 1, &first_z);
    for (int k = 0; k < rows * columns; k++)
        put(task, x + first_x + k % columns * view->period, z + first_z + k / columns * view->period, light, sums);
}

static void send(const struct task *task, const uint32_t counters[4], struct tracing_sums *sums)
{
    const struct light_input *input = task->input;
    double numbers[4], place[2], size = input->surface->size;
    struct ray_point point;
    tracing_random(counters, numbers);
    if (!tracing_surface_at(&task->surface, (numbers[0] - 0.5) * size, (numbers[1] - 0.5) * size, &point))
        return;
    optics_disc_spread(numbers[2], numbers[3], place);
    optics_disc_place(&task->disc, place, point.to_light);
    int together = tracing_colors_together(&task->rays);
    for (int c = 0; c < 3; c += together) {
        struct ray ray = ray_start(&task->rays, &point, ray_kind_of(task->receiver), c);
        struct ray_hit hit;
        double light[3] = {0};
        if (ray.weight <= 0 || !ray_meet(&ray, &point, task->receiver, &hit))
            continue;
        for (int i = c; i < c + together; i++)
            light[i] = ray_weight(&task->rays, &ray, &hit, task->receiver, i);
        land(task, &hit, light, sums);
    }
}

/* Squares of photons along a side of the surface; `per_texel`: how many photons a texel then gets under flat water. */
static int choose_squares(const struct photons *p, const struct tracing_view *view, double size, double *per_texel)
{
    double texels = size * view->texels_a_meter;
    int squares = (int)fmin(ceil(texels), SIDE_MAX);
    *per_texel = p->count * pow(squares / texels, 2);
    return squares;
}

/* From the sum of a texel's photons to units of flat water, whose light comes from all of the sun. */
static void find_scale(const struct ray_medium *rays, const struct optics_disc *disc, double receiver, double per_texel,
                       double scale[3])
{
    double flat[3];
    ray_flat_mean(rays, disc, receiver, flat);
    for (int c = 0; c < 3; c++)
        scale[c] = flat[c] > 0 ? 1 / (flat[c] * per_texel) : 0;
}

static bool trace(void *state_, const struct light_input *input, struct light_map *map)
{
    struct state *state = state_;
    const struct photons *p = input->params;
    struct task task = {
        .input = input, .surface = tracing_surface_of(input->surface), .disc = optics_sun_disc(input->sun)};
    ray_medium_start(&task.rays, input->medium, &task.disc);
    for (int slice = 0; slice < map->slices; slice++) {
        double scale[3], per_texel;
        task.view = tracing_view_of(input, input->surface->periodic, map->side, slice);
        task.receiver = input->receivers[slice];
        int squares = choose_squares(p, &task.view, input->surface->size, &per_texel);
        if (!tracing_sums_start(&state->sums, map->side, input->log))
            return false;
#pragma omp parallel for schedule(static)
        for (int j = 0; j < squares; j++)
            for (int i = 0; i < squares * p->count; i++)
                send(&task, (uint32_t[4]){(uint32_t)i, (uint32_t)j, (uint32_t)input->seed, 0}, &state->sums);
        find_scale(&task.rays, &task.disc, task.receiver, per_texel, scale);
        tracing_sums_read(&state->sums, scale, light_map_slice(map, slice));
    }
    return true;
}

/* The photons of some colours, in as many calls as a square sends photons. */
static void draw_color(struct state *state, struct dpl_gl *gl, const struct tracing_rays *rays)
{
    const struct light_input *input = rays->input;
    const struct photons *p = input->params;
    const struct gpu_program *program = &state->program;
    double scale[3], per_texel;
    int squares = choose_squares(p, &rays->view, input->setup->size, &per_texel);
    find_scale(&rays->medium, &rays->disc, rays->receiver, per_texel, scale);
    tracing_blend_begin(gl, &state->blend, rays->view.side, MARGIN, rays->color == 0);
    program_use(gl, program);
    tracing_rays_bind(gl, rays, program);
    program_vec3(gl, program, "disc_up", rays->disc.up);
    program_vec3(gl, program, "disc_across", rays->disc.across);
    program_int(gl, program, "squares", squares);
    program_int(gl, program, "count", p->count);
    program_int(gl, program, "seed", input->seed);
    program_int(gl, program, "side", rays->view.side);
    program_int(gl, program, "margin", MARGIN);
    program_float(gl, program, "width", p->spread == SPREAD_NEAREST ? 1 : 2);
    program_vec3(gl, program, "scale", scale);
    if (!gl->info.es)
        gl->Enable(GL_PROGRAM_POINT_SIZE);
    for (int i = 0; i < p->count; i++) {
        program_int(gl, program, "number", i);
        gl->DrawArrays(GL_POINTS, 0, squares * squares);
    }
    if (!gl->info.es)
        gl->Disable(GL_PROGRAM_POINT_SIZE);
    tracing_blend_end(gl);
}

static bool draw(void *state_, struct dpl_gl *gl, const struct light_input *input, struct gpu_texture *map)
{
    struct state *state = state_;
    if (!program_ready(gl, &state->program, "light/photons.glsl", "") || !tracing_blend_ready(gl, &state->blend))
        return false;
    for (int slice = 0; slice < input->slices; slice++) {
        struct tracing_rays rays = tracing_rays_of(input, input->sun, map->width, slice, 0);
        for (; rays.color < 3; rays.color += tracing_colors_together(&rays.medium))
            draw_color(state, gl, &rays);
        tracing_blend_draw(gl, &state->blend, input->surface_gpu->periodic, MARGIN, map, slice);
    }
    return true;
}

static void finish(void *state_, struct dpl_gl *gl)
{
    struct state *state = state_;
    if (gl) {
        program_finish(gl, &state->program);
        tracing_blend_finish(gl, &state->blend);
    }
    tracing_sums_finish(&state->sums);
    *state = (struct state){0};
}

const struct light_technique light_photons = {
    .name = "photons",
    .summary = "light shot from the sun at random places of the water and counted where it falls; grainy",
    .source = "forward ray tracing; Arvo 1986",
    .params = params,
    .params_size = sizeof(struct photons),
    .state_size = sizeof(struct state),
    .channels = 3,
    .physical = true,
    .energy = 0.005,
    .reflects = true,
    .trace = trace,
    .draw = draw,
    .finish = finish,
};
