/* The sum of two other models, such as a swell and the ripples on it.
 *
 * 1. The first model moves the points, up and sideways.
 * 2. The second, which may not move any sideways, adds its height and slopes where the points are then.
 *
 * The grid is the finer one of the two. */
#include "base/log.h"
#include "water/water.h"

#include <string.h>

extern const struct water_model water_sum;

struct sum {
    int first, second; /* indices into water_models */
};

/* The models that may be added: those before this one, which is the last in the list. */
static const char *part_name(int i)
{
    const char *name = water_model_name(i);
    return name && strcmp(name, water_sum.name) ? name : NULL;
}

static const struct dpl_param params[] = {
    PARAM_CHOICE(struct sum, first, 1, part_name, "model of the larger waves"),
    PARAM_CHOICE(struct sum, second, 2, part_name, "model of the waves on them; moves points up and down only"),
    PARAM_END,
};

bool water_model_has(int model, int part, const void *const *all_params)
{
    const struct sum *sum = all_params[model];
    return model == part || (water_models[model] == &water_sum && (sum->first == part || sum->second == part));
}

/* The two models and what each is asked. */
struct parts {
    const struct water_model *models[2];
    struct water_setup setups[2];
    struct water_shape shapes[2];
    struct water_shape shape; /* of the sum */
};

static struct parts parts_of(const struct water_setup *setup)
{
    const struct sum *sum = setup->params;
    const int chosen[2] = {sum->first, sum->second};
    struct parts parts = {.shape = {.periodic = true}};
    for (int k = 0; k < 2; k++) {
        parts.models[k] = water_models[chosen[k]];
        parts.setups[k] = *setup;
        parts.setups[k].params = setup->all_params[chosen[k]];
        parts.shapes[k] = parts.models[k]->shape(parts.setups + k);
        if (parts.shapes[k].side > parts.shape.side)
            parts.shape.side = parts.shapes[k].side;
        parts.shape.periodic = parts.shape.periodic && parts.shapes[k].periodic;
    }
    parts.shape.choppy = parts.shapes[0].choppy;
    for (int k = 0; k < 2; k++) { /* who has no grid of its own takes the sum's */
        parts.setups[k].mesh = parts.shape.side;
        parts.shapes[k] = parts.models[k]->shape(parts.setups + k);
    }
    return parts;
}

static struct water_shape shape(const struct water_setup *setup)
{
    return parts_of(setup).shape;
}

static bool has_grid_of_sum(const struct parts *parts, int k)
{
    return parts->shapes[k].side == parts->shape.side && parts->shapes[k].periodic == parts->shape.periodic;
}

struct state {
    struct surface second; /* where both models have the same grid */
};

static bool prepare(void *state_, const struct water_setup *setup, double time, const struct dpl_log *log)
{
    struct state *state = state_;
    struct parts parts = parts_of(setup);
    int side = parts.shape.side;
    if (parts.shapes[1].choppy)
        return base_fail(
            log, DPL_REASON_UNSUPPORTED,
            "sum.second: %s moves points sideways (accepted there: models that move them up and down only)",
            parts.models[1]->name);
    if (parts.models[1] == parts.models[0])
        return base_fail(log, DPL_REASON_UNSUPPORTED, "sum.second: as sum.first: \"%s\" (accepted: another model)",
                         parts.models[1]->name);
    if (!water_prepare(parts.models[0], parts.setups, time, log) ||
        !water_prepare(parts.models[1], parts.setups + 1, time, log))
        return false;
    return parts.shape.choppy || !has_grid_of_sum(&parts, 1) ||
           surface_resize(&state->second, side, side, parts.shape.periodic, false, setup->size, log);
}

#define BLOCK 256 /* points */

/* Height and slopes of the second model at up to that many places. */
static void second_at(const struct parts *parts, double time, int count, const double *x, const double *z,
                      double out[3][BLOCK])
{
    double shift_x[BLOCK], shift_z[BLOCK], area[BLOCK];
    struct water_points points = {count, x, z, out[0], out[1], out[2], shift_x, shift_z, area};
    water_sample(parts->models[1], parts->setups + 1, time, &points);
}

static void sample(const void *state, const struct water_setup *setup, double time, struct water_points *points)
{
    (void)state;
    struct parts parts = parts_of(setup);
    water_sample(parts.models[0], parts.setups, time, points);
    for (int from = 0; from < points->count; from += BLOCK) {
        int count = points->count - from < BLOCK ? points->count - from : BLOCK;
        double x[BLOCK], z[BLOCK], second[3][BLOCK];
        for (int i = 0; i < count; i++) {
            x[i] = points->x[from + i] + points->shift_x[from + i];
            z[i] = points->z[from + i] + points->shift_z[from + i];
        }
        second_at(&parts, time, count, x, z, second);
        for (int i = 0; i < count; i++) {
            points->height[from + i] += second[0][i];
            points->slope_x[from + i] += second[1][i];
            points->slope_z[from + i] += second[2][i];
        }
    }
}

static void add_row(const struct parts *parts, double time, struct surface *surface, int row)
{
    double spacing = surface_spacing(surface), half = surface->size / 2;
    size_t first = (size_t)row * (size_t)surface->columns;
    float *texel = surface->texels + first * 3, *shift = surface->shifts ? surface->shifts + first * 2 : NULL;
    for (int from = 0; from < surface->columns; from += BLOCK) {
        int count = surface->columns - from < BLOCK ? surface->columns - from : BLOCK;
        double x[BLOCK], z[BLOCK], second[3][BLOCK];
        for (int i = 0; i < count; i++) {
            x[i] = (from + i) * spacing - half + (shift ? (double)shift[2 * (from + i)] : 0);
            z[i] = row * spacing - half + (shift ? (double)shift[2 * (from + i) + 1] : 0);
        }
        second_at(parts, time, count, x, z, second);
        for (int i = 0; i < count; i++, texel += 3)
            for (int c = 0; c < 3; c++)
                texel[c] += (float)second[c][i];
    }
}

static void evaluate(void *state_, const struct water_setup *setup, double time, struct surface *surface)
{
    struct state *state = state_;
    struct parts parts = parts_of(setup);
    if (has_grid_of_sum(&parts, 0))
        water_evaluate_grid(parts.models[0], parts.setups, time, surface);
    else
        water_fill(parts.models[0], parts.setups, time, surface);
    if (parts.shape.choppy || !has_grid_of_sum(&parts, 1)) {
#pragma omp parallel for
        for (int j = 0; j < surface->rows; j++)
            add_row(&parts, time, surface, j);
        return;
    }
    water_evaluate_grid(parts.models[1], parts.setups + 1, time, &state->second);
    for (size_t i = 0; i < (size_t)surface->columns * (size_t)surface->rows * 3; i++)
        surface->texels[i] += state->second.texels[i];
}

static void sphere(const void *state, const struct water_setup *setup, double center[3])
{
    (void)state;
    struct parts parts = parts_of(setup);
    int k = parts.models[0]->sphere ? 0 : 1;
    water_sphere_center(parts.models[k], parts.setups + k, center);
}

static void finish(void *state_, struct dpl_gl *gl)
{
    (void)gl;
    struct state *state = state_;
    surface_finish(&state->second);
}

const struct water_model water_sum = {
    .name = "sum",
    .summary = "two other models, added up",
    .source = "dapple",
    .params = params,
    .params_size = sizeof(struct sum),
    .state_size = sizeof(struct state),
    .shape = shape,
    .prepare = prepare,
    .evaluate = evaluate,
    .sample = sample,
    .sphere = sphere,
    .finish = finish,
};
