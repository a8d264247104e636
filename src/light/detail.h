/* light/detail.h: how fine a mesh and a map must be for a wanted error, from the water itself. */
#ifndef LIGHT_DETAIL_H
#define LIGHT_DETAIL_H

#include "water/water.h"

/* The water at points spread over the tile. */
#define LIGHT_SAMPLES 1024
struct light_samples {
    double arrays[8][LIGHT_SAMPLES];
    const double *height, *slopes[2], *shifts[2]; /* in `arrays` */
    double curvature; /* 1/m: of the crests of a wave alone; the root of the sum of squares of many */
    double change;    /* 1/m²: of the curvature along the way, root mean square */
};
void light_samples_take(struct light_samples *samples, const struct water_model *model, const struct water_setup *setup,
                        double time);

/* How strongly the surface bends light: the deflection of a ray by a slope, 1 - 1 / ior for light that is let in, 2 for
 * light that is thrown back. */
double light_power(double receiver, double ior);

/* Vertices a side that a physical map of the receiver needs for an error of at most `error`; `setup` without its mesh.
 * `blur`: metres on the receiver that are seen as one: a texel, or the sun's radius there. */
int light_choose_mesh(const struct water_model *model, const struct water_setup *setup, double receiver, double ior,
                      double blur, double error);

#endif
