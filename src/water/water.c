#include "water/water.h"

#include <math.h>

extern const struct water_model water_sines, water_collard;

const struct water_model *const water_models[] = {&water_sines, &water_collard, NULL};

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
    PARAM_FLOATS(struct water_medium, absorption, 3, 0, 100, "1/m", "absorption coefficient in red, green and blue",
                 0.35, 0.07, 0.03),
    PARAM_END,
};

void water_refractive_indices(const struct water_medium *medium, double ior[3])
{
    for (int c = 0; c < 3; c++)
        ior[c] = fmax(medium->ior + (c - 1) * medium->dispersion / 2, 1);
}

void water_sample(const struct water_model *model, const struct water_setup *setup, double time,
                  struct water_points *points)
{
    for (int i = 0; i < points->count && !model->choppy; i++) {
        points->shift_x[i] = points->shift_z[i] = 0;
        points->area[i] = 1;
    }
    model->sample(setup, time, points);
}

bool water_evaluate(const struct water_model *model, const struct water_setup *setup, double time,
                    struct surface *surface, const struct dpl_log *log)
{
    int side = model->grid(setup);
    if (!surface_resize(surface, side, side, model->periodic, model->choppy, setup->size, log))
        return false;
    model->evaluate(setup, time, surface);
    return true;
}
