#include "water/water.h"

extern const struct water_model water_sines, water_collard;

const struct water_model *const water_models[] = {&water_sines, &water_collard, NULL};

const char *water_model_name(int i)
{
    const int count = sizeof water_models / sizeof *water_models - 1;
    return i >= 0 && i < count ? water_models[i]->name : NULL;
}

bool water_evaluate(const struct water_model *model, const struct water_setup *setup, double time,
                    struct surface *surface, const struct dpl_log *log)
{
    int side = model->grid(setup);
    if (!surface_resize(surface, side, side, model->periodic, setup->size, log))
        return false;
    model->evaluate(setup, time, surface);
    return true;
}
