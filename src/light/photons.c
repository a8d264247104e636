/* Forward ray tracing, the naive way (as the articles tell it that look for something cheaper): light is shot from the
 * sun at the water, and counted in the texel that it hits.
 *
 *   1. a photon takes a place of the surface and of the sun's disc by chance
 *   2. the surface there, by straight lines between vertices, refracts it or throws it back
 *   3. its weight is added to the texel that it falls on, or shared out among the four around it
 *
 * Grain falls with the square root of the number of photons. `reference` sends them evenly, through the water's own
 * surface, and until there are enough. */
#include "light/tracing.h"

#include <math.h>

#define SIDE_MAX 32768 /* squares of photons along a side of the surface */

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
};

/* What is the same for all photons on one receiver. */
struct task {
    const struct light_input *input;
    struct tracing_surface surface;
    struct tracing_view view;
    double receiver; /* m */
    int side;        /* squares along a side of the surface; each sends `count` photons, to anywhere */
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

static bool trace(void *state_, const struct light_input *input, struct light_map *map)
{
    struct state *state = state_;
    const struct photons *p = input->params;
    struct task task = {
        .input = input, .surface = tracing_surface_of(input->surface), .disc = optics_sun_disc(input->sun)};
    ray_medium_start(&task.rays, input->medium, &task.disc);
    for (int slice = 0; slice < map->slices; slice++) {
        double flat[3], scale[3];
        task.view = tracing_view_of(input, input->surface->periodic, map->side, slice);
        task.receiver = input->receivers[slice];
        task.side = (int)fmin(ceil(input->surface->size * task.view.texels_a_meter), SIDE_MAX);
        if (!tracing_sums_start(&state->sums, map->side, input->log))
            return false;
#pragma omp parallel for schedule(static)
        for (int j = 0; j < task.side; j++)
            for (int i = 0; i < task.side * p->count; i++)
                send(&task, (uint32_t[4]){(uint32_t)i, (uint32_t)j, (uint32_t)input->seed, 0}, &state->sums);
        ray_flat_mean(&task.rays, &task.disc, task.receiver, flat);
        double per_texel = p->count * pow(task.side / (input->surface->size * task.view.texels_a_meter), 2);
        for (int c = 0; c < 3; c++)
            scale[c] = flat[c] > 0 ? 1 / (flat[c] * per_texel) : 0;
        tracing_sums_read(&state->sums, scale, light_map_slice(map, slice));
    }
    return true;
}

static void finish(void *state_, struct dpl_gl *gl)
{
    struct state *state = state_;
    (void)gl;
    tracing_sums_finish(&state->sums);
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
    .finish = finish,
};
