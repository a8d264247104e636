#include "light/detail.h"

#include "light/light.h"

#include <math.h>

#define MESH_SHARE 0.5 /* of the wanted error, that may be the mesh's */

/* The water at points spread evenly over the tile by the additive sequence of Roberts 2018, moved by a step along x and
 * z. */
static void sample_water(const struct water_model *model, const struct water_setup *setup, double time, double step_x,
                         double step_z, double (*arrays)[LIGHT_SAMPLES])
{
    const double inside = 0.98; /* of the tile: steps do not leave it */
    for (int i = 0; i < LIGHT_SAMPLES; i++) {
        double x = 0.75487766624669276 * i, z = 0.56984029099805327 * i;
        arrays[0][i] = (x - floor(x) - 0.5) * setup->size * inside + step_x;
        arrays[1][i] = (z - floor(z) - 0.5) * setup->size * inside + step_z;
    }
    struct water_points points = {LIGHT_SAMPLES, arrays[0], arrays[1], arrays[2], arrays[3],
                                  arrays[4],     arrays[5], arrays[6], arrays[7]};
    water_sample(model, setup, time, &points);
}

void light_samples_take(struct light_samples *samples, const struct water_model *model, const struct water_setup *setup,
                        double time)
{
    double step = setup->size / 1024, bends[LIGHT_SAMPLES] = {0}, sums[2][LIGHT_SAMPLES] = {{0}};
    double curvature = 0, change = 0, (*arrays)[LIGHT_SAMPLES] = samples->arrays;
    for (int side = 0; side < 4; side++) { /* before and after, along x and along z */
        int axis = side / 2;
        double sign = side % 2 ? 1 : -1;
        sample_water(model, setup, time, axis == 0 ? sign * step : 0, axis == 1 ? sign * step : 0, arrays);
        for (int i = 0; i < LIGHT_SAMPLES; i++) {
            bends[i] += sign * arrays[3 + axis][i] / (2 * step);
            sums[axis][i] += arrays[3 + axis][i];
        }
    }
    sample_water(model, setup, time, 0, 0, arrays);
    for (int i = 0; i < LIGHT_SAMPLES; i++) {
        curvature += bends[i] * bends[i] / LIGHT_SAMPLES;
        for (int axis = 0; axis < 2; axis++)
            change += pow((sums[axis][i] - 2 * arrays[3 + axis][i]) / (step * step), 2) / LIGHT_SAMPLES;
    }
    samples->height = arrays[2];
    samples->slopes[0] = arrays[3];
    samples->slopes[1] = arrays[4];
    samples->shifts[0] = arrays[5];
    samples->shifts[1] = arrays[6];
    samples->curvature = sqrt(2 * curvature);
    samples->change = sqrt(change);
}

double light_power(double receiver, double ior)
{
    return receiver > 0 ? 2 : 1 - 1 / ior;
}

/* A cell's image is bent: its middle is off by the second difference of its vertices' places. A 24th of that, in texels
 * of the map, is b; the error was measured to be at most 5 b^1.2 (docs/accuracy.md). */
int light_choose_mesh(const struct water_model *model, const struct water_setup *setup, double receiver, double ior,
                      double blur, double error)
{
    const int least = 32, step = 16;
    struct light_samples samples;
    light_samples_take(&samples, model, setup, 0);
    double bend = fabs(receiver) * light_power(receiver, ior) * samples.change * pow(setup->size, 2) / (24 * blur);
    double mesh = sqrt(bend / pow(error * MESH_SHARE / 5, 1 / 1.2));
    return (int)fmin(fmax(ceil(mesh / step) * step, least), LIGHT_MESH_MAX);
}
