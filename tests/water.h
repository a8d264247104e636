/* tests/water.h: one point of a water model; the water of a scene. */
#ifndef TESTS_WATER_H
#define TESTS_WATER_H

#include "support.h"

#include "scene/scene.h"

/* Height and slopes at a point of a model that moves up and down only. */
static inline void sample_water(const struct water_model *model, const struct water_setup *setup, double time, double x,
                                double z, double out[3])
{
    double shift[2], area;
    struct water_points point = {1, &x, &z, out, out + 1, out + 2, shift, shift + 1, &area};
    water_sample(model, setup, time, &point);
}

/* A point of any model. */
struct water_point {
    double height, slope[2], shift[2], area;
};

static inline struct water_point sample_point(const struct water_model *model, const struct water_setup *setup,
                                              double time, double x, double z)
{
    struct water_point p;
    struct water_points points = {1, &x, &z, &p.height, p.slope, p.slope + 1, p.shift, p.shift + 1, &p.area};
    water_sample(model, setup, time, &points);
    return p;
}

/* A scene's water at one time, and what its model was asked. */
struct water {
    struct dpl_scene *scene;
    const struct water_model *model;
    struct wave waves[WATER_WAVES_MAX];
    struct water_setup setup;
    struct water_memory memory;
    struct surface surface;
    double time;
};

/* Brings the water of the scene as it now is to that time. */
static inline void water_move(struct water *water, double time)
{
    water->time = time;
    water->model = water_models[water->scene->medium.model];
    water->setup = scene_water_setup(water->scene, water->waves);
    water->setup.memory = &water->memory;
    assert_true(water_prepare(water->model, &water->setup, time, NULL));
    assert_true(water_evaluate(water->model, &water->setup, time, &water->surface, NULL));
}

static inline void water_finish(struct water *water)
{
    surface_finish(&water->surface);
    water_memory_finish(&water->memory, NULL);
    dpl_scene_destroy(water->scene);
}

#endif
