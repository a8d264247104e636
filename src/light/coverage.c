/* Exact coverage: the images of the surface's cells, added up over the texels that they cover.
 *
 *   1. every vertex of the surface refracts (or throws back) the light from the middle of the sun, once for all
 * receivers
 *   2. on a receiver, the images of each cell's two triangles share its flux among texels by the area that they cover;
 *      folds add up, nothing is sampled, and no light is lost
 *   3. the sun's disc smears the light over a footprint that depends on the place's slope
 *
 * Energy of triangles after Watt 1990 and Nishita & Nakamae 1994, whose beams are drawn here with the exact area of
 * texels; balanced vertices and footprints by slope are dapple's own. docs/accuracy.md has the equations and the
 * errors. */
#include "light/coverage.h"

#include "base/log.h"

static const struct dpl_param params[] = {
    PARAM_INT(struct coverage, fineness, 0, 0, COVERAGE_FINENESS_MAX, "",
              "texels computed along each side of a texel of the map; 0 = as caustics.error needs"),
    PARAM_INT(
        struct coverage, footprints, 0, 0, COVERAGE_KINDS_MAX, "",
        "footprints of the sun's disc along either axis of slope (on the CPU; the GPU has one); 0 = as caustics.error "
        "needs"),
    PARAM_END,
};

struct state {
    struct coverage_rays rays;
    struct coverage_cells cells;
    struct light_samples samples;
    struct coverage_plan plan;
    struct coverage_bands bands;
    struct light_map small; /* room for half the map's side and less */
    struct coverage_gpu gpu;
};

/* The light of one refractive index: `color` is the one that it is for, -1 all. */
static bool trace_color(struct state *state, const struct light_input *input, double ior, int color,
                        struct light_map *map)
{
    bool upwards = input->receivers[0] > 0;
    struct optics_water water = water_optics(input->medium);
    double sun[3];
    optics_sun_direction(input->sun, sun);
    struct coverage_flat flat = coverage_flat_water(sun, ior, upwards);
    if (!coverage_rays_trace(&state->rays, input->surface, &flat, input->log))
        return false;
    for (int slice = 0; slice < map->slices; slice++) {
        double height = input->receivers[slice];
        if (!coverage_plan_make(&state->plan, input, &state->samples, &flat, slice, map->side))
            return false;
        bool whole = state->plan.side == map->side;
        const struct coverage_receiver receiver = {height, state->plan.side * state->plan.fineness,
                                                   input->windows[slice]};
        if (!whole && !light_map_resize(&state->small, (map->side + 1) / 2, map->channels, 1, input->log))
            return false;
        struct light_map small = state->small;
        small.side = state->plan.side;
        if (!coverage_cells_place(&state->cells, &state->rays, input->surface, &flat, water.absorption, &receiver,
                                  &state->plan.kinds, input->log) ||
            !coverage_bands_trace(&state->bands, &state->cells, &state->plan, color, whole ? map : &small,
                                  whole ? slice : 0, input->log))
            return false;
        if (!whole)
            coverage_enlarge(&small, color, input->surface->periodic, map, slice);
    }
    return true;
}

static bool trace(void *state_, const struct light_input *input, struct light_map *map)
{
    struct state *state = state_;
    double ior[3];
    light_samples_take(&state->samples, input->model, input->setup, input->time);
    water_refractive_indices(input->medium, ior);
    if (ior[0] == ior[2])
        return trace_color(state, input, ior[1], -1, map);
    for (int c = 0; c < 3; c++)
        if (!trace_color(state, input, ior[c], c, map))
            return false;
    return true;
}

static bool draw(void *state_, struct dpl_gl *gl, const struct light_input *input, struct gpu_texture *map)
{
    struct state *state = state_;
    light_samples_take(&state->samples, input->model, input->setup, input->time);
    return coverage_gpu_draw(&state->gpu, gl, input, &state->samples, map);
}

static void finish(void *state_, struct dpl_gl *gl)
{
    struct state *state = state_;
    if (gl)
        coverage_gpu_finish(&state->gpu, gl);
    coverage_rays_finish(&state->rays);
    coverage_cells_finish(&state->cells);
    coverage_plan_finish(&state->plan);
    coverage_bands_finish(&state->bands);
    light_map_finish(&state->small);
    *state = (struct state){0};
}

const struct light_technique light_coverage = {
    .name = "coverage",
    .summary = "exact areas of the images of the surface's cells, and the sun's disc by its own footprints",
    .source = "dapple",
    .params = params,
    .params_size = sizeof(struct coverage),
    .state_size = sizeof(struct state),
    .channels = 3,
    .physical = true,
    .energy = 1e-3,
    .reflects = true,
    .trace = trace,
    .draw = draw,
    .finish = finish,
};
