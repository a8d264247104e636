/* tests/water.h: one point of a water model. */
#ifndef TESTS_WATER_H
#define TESTS_WATER_H

#include "water/water.h"

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

#endif
