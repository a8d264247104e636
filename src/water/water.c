#include "water/water.h"

#include "base/hash.h"
#include "base/log.h"

#include <math.h>
#include <stdlib.h>

extern const struct water_model water_sines, water_ocean, water_ripples, water_fbm, water_heightfield, water_collard,
    water_sum;

const struct water_model *const water_models[] = {&water_sines,       &water_ocean,   &water_ripples, &water_fbm,
                                                  &water_heightfield, &water_collard, &water_sum,     NULL};
_Static_assert(sizeof water_models / sizeof *water_models - 1 <= WATER_MODELS_MAX, "room for the state of each");

/* The sum comes last: it adds up those before it. */
const char *water_model_name(int i)
{
    const int count = sizeof water_models / sizeof *water_models - 1;
    return i >= 0 && i < count ? water_models[i]->name : NULL;
}

const struct dpl_param water_medium_params[] = {
    PARAM_CHOICE(struct water_medium, model, 0, water_model_name, "water model; see `dapple list waters`"),
    PARAM_FLOAT(struct water_medium, ior, 1.333, 1, 3, "", "refractive index of the water, for green light"),
    PARAM_FLOAT(
        struct water_medium, dispersion, 0, 0, 0.5, "",
        "refractive index of blue light less that of red; 0.006 in clear water; above 0 costs three times the time"),
    PARAM_CHOICE(struct water_medium, type, OPTICS_WATER_CUSTOM, optics_water_type_name,
                 "absorption and scattering: `custom` = those below; or of pure water, or of a type by Jerlov"),
    PARAM_FLOATS(struct water_medium, absorption, 3, 0, 100, "1/m",
                 "absorption coefficient in red, green and blue (625, 550, 450 nm), of the type `custom`", 0.35, 0.07,
                 0.03),
    PARAM_FLOATS(struct water_medium, scattering, 3, 0, 100, "1/m",
                 "scattering coefficient in red, green and blue, of the type `custom`", 0.04, 0.05, 0.07),
    PARAM_FLOAT(struct water_medium, anisotropy, 0.924, -0.99, 0.99, "",
                "mean cosine of the angle at which particles in the water scatter; 0 = evenly, 1 = straight on"),
    PARAM_FLOAT(
        struct water_medium, roughness, 0.02, 0, 0.5, "",
        "slopes (RMS) of ripples too fine for the grid, which widen the sun's glints (looks physical and path-traced)"),
    PARAM_END,
};

const struct dpl_param water_sphere_params[] = {
    PARAM_FLOAT(struct water_sphere, radius, 0, 0, 1000, "m",
                "of the ball, which `ripples` swim round and the look `pool` shows; 0 = there is none"),
    PARAM_FLOATS(struct water_sphere, position, 3, -10000, 10000, "m", "its middle", 0, 0, 0),
    PARAM_BOOL(struct water_sphere, gravity, false,
               "it falls, swims and sinks from there on; without, it stays where it has come to"),
    PARAM_END,
};

void water_refractive_indices(const struct water_medium *medium, double ior[3])
{
    for (int c = 0; c < 3; c++)
        ior[c] = fmax(medium->ior + (c - 1) * medium->dispersion / 2, 1);
}

struct optics_water water_optics(const struct water_medium *medium)
{
    if (medium->type != OPTICS_WATER_CUSTOM)
        return optics_water_type(medium->type, medium->anisotropy);
    struct optics_water water = {.anisotropy = medium->anisotropy};
    for (int c = 0; c < 3; c++) {
        water.absorption[c] = medium->absorption[c];
        water.scattering[c] = medium->scattering[c];
    }
    return water;
}

static int index_of(const struct water_model *model)
{
    int i = 0;
    while (water_models[i] && water_models[i] != model)
        i++;
    return i;
}

void *water_state(const struct water_model *model, const struct water_setup *setup, const struct dpl_log *log)
{
    void **state = setup->memory && model->state_size ? setup->memory->states + index_of(model) : NULL;
    if (state && !*state)
        *state = base_allocate(log, 1, model->state_size, model->name);
    return state ? *state : NULL;
}

bool water_prepare(const struct water_model *model, const struct water_setup *setup, double time,
                   const struct dpl_log *log)
{
    void *state = water_state(model, setup, log);
    return (state || !model->state_size) && (!model->prepare || model->prepare(state, setup, time, log));
}

void water_memory_finish(struct water_memory *memory, struct dpl_gl *gl)
{
    for (int i = 0; water_models[i]; i++) {
        if (memory->states[i] && water_models[i]->finish)
            water_models[i]->finish(memory->states[i], gl);
        free(memory->states[i]);
    }
    *memory = (struct water_memory){0};
}

void water_sphere_center(const struct water_model *model, const struct water_setup *setup, double center[3])
{
    for (int c = 0; c < 3; c++)
        center[c] = setup->sphere->position[c];
    if (model->sphere)
        model->sphere(water_state(model, setup, NULL), setup, center);
}

void water_sample(const struct water_model *model, const struct water_setup *setup, double time,
                  struct water_points *points)
{
    if (!model->shape(setup).choppy) {
        for (int i = 0; i < points->count; i++) {
            points->shift_x[i] = points->shift_z[i] = 0;
            points->area[i] = 1;
        }
    }
    model->sample(water_state(model, setup, NULL), setup, time, points);
}

uint64_t water_hash(uint64_t value, const struct water_model *model, const struct water_setup *setup, double time)
{
    enum { POINTS = 64 };
    double arrays[8][POINTS] = {{0}};
    for (int i = 0; i < POINTS; i++) {
        arrays[0][i] = ((i % 8 + 0.47) / 8 - 0.5) * setup->size;
        arrays[1][i] = ((i / 8 + 0.59) / 8 - 0.5) * setup->size;
    }
    struct water_points points = {POINTS,    arrays[0], arrays[1], arrays[2], arrays[3],
                                  arrays[4], arrays[5], arrays[6], arrays[7]};
    water_sample(model, setup, time, &points);
    return hash_bytes(value, arrays, sizeof arrays);
}

/* Vertices of a row, from column `from` on. */
#define BLOCK 256

static void fill_block(const struct water_model *model, const struct water_setup *setup, double time,
                       struct surface *surface, int row, int from)
{
    double x[BLOCK], z[BLOCK], height[BLOCK], slope_x[BLOCK], slope_z[BLOCK], shift_x[BLOCK], shift_z[BLOCK];
    double area[BLOCK], spacing = surface_spacing(surface), half = surface->size / 2;
    int count = surface->columns - from < BLOCK ? surface->columns - from : BLOCK;
    size_t first = (size_t)row * (size_t)surface->columns + (size_t)from;
    for (int i = 0; i < count; i++) {
        x[i] = (from + i) * spacing - half;
        z[i] = row * spacing - half;
    }
    struct water_points points = {count, x, z, height, slope_x, slope_z, shift_x, shift_z, area};
    water_sample(model, setup, time, &points);
    float *texel = surface->texels + first * 3, *shift = surface->shifts ? surface->shifts + first * 2 : NULL;
    for (int i = 0; i < count; i++) {
        texel[3 * i] = (float)height[i];
        texel[3 * i + 1] = (float)slope_x[i];
        texel[3 * i + 2] = (float)slope_z[i];
        if (shift) {
            shift[2 * i] = (float)shift_x[i];
            shift[2 * i + 1] = (float)shift_z[i];
        }
    }
}

void water_fill(const struct water_model *model, const struct water_setup *setup, double time, struct surface *surface)
{
#pragma omp parallel for
    for (int j = 0; j < surface->rows; j++)
        for (int from = 0; from < surface->columns; from += BLOCK)
            fill_block(model, setup, time, surface, j, from);
}

void water_evaluate_grid(const struct water_model *model, const struct water_setup *setup, double time,
                         struct surface *surface)
{
    if (model->evaluate)
        model->evaluate(water_state(model, setup, NULL), setup, time, surface);
    else
        water_fill(model, setup, time, surface);
}

bool water_evaluate(const struct water_model *model, const struct water_setup *setup, double time,
                    struct surface *surface, const struct dpl_log *log)
{
    struct water_shape shape = model->shape(setup);
    if (!surface_resize(surface, shape.side, shape.side, shape.periodic, shape.choppy, setup->size, log))
        return false;
    water_evaluate_grid(model, setup, time, surface);
    return true;
}
