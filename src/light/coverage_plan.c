/* How finely a receiver is computed, and the sun's footprints on it.
 *
 * Each point of the sun throws its own caustics, moved a little. Their mean is a point sun's light with every piece of
 * it smeared over the footprint that the refracted disc has there: an ellipse, whose axes depend on how steeply the
 * light meets the surface. A few footprints, for slopes on a grid, serve all: light between them is shared out. */
#include "light/coverage.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define RADIUS_MAX 24.0 /* texels of a footprint: a wider one is computed with fewer */
#define RADIUS_END 64.0 /* likewise, where there is only one texel left */
#define WIDTHS 2.2      /* standard deviations of the slopes that the grid of kinds reaches over, to either side */

/* Covariance xx, xz, zz of the disc's footprint in square metres on a receiver `way` metres from the surface. */
static bool footprint_at(const struct light_input *input, const struct coverage_flat *flat, const double slopes[2],
                         double way, double covariance[3])
{
    const double step = 0.01; /* of the disc's radius */
    const struct optics_disc disc = optics_sun_disc(input->sun);
    memset(covariance, 0, 3 * sizeof *covariance);
    for (int axis = 0; axis < 2; axis++) {
        double ends[2][3];
        for (int end = 0; end < 2; end++) {
            double place[2] = {0}, sun[3];
            place[axis] = end == 0 ? -step : step;
            optics_disc_place(&disc, place, sun);
            if (!coverage_ray(sun, flat->ior, flat->upwards, slopes, ends[end]))
                return false;
        }
        double x = (ends[1][0] - ends[0][0]) / (2 * step) * way, z = (ends[1][1] - ends[0][1]) / (2 * step) * way;
        covariance[0] += x * x / 4; /* a uniform disc of radius 1 has variance 1/4 along either axis */
        covariance[1] += x * z / 4;
        covariance[2] += z * z / 4;
    }
    return true;
}

/* How far light goes down from a sample, or up. */
static double way_from(const struct light_samples *samples, int i, double receiver)
{
    double way = receiver - samples->height[i];
    return receiver > 0 ? fmax(way, 0) : fmin(way, 0);
}

/* What is known of the slopes along the sun's azimuth and across it. */
struct slopes {
    double axis[2][2];
    double mean[2], deviation[2];
};

static struct slopes measure_slopes(const struct light_input *input, const struct light_samples *samples)
{
    double elevation, azimuth, squares[2] = {0};
    optics_sun_angles(input->sun, &elevation, &azimuth);
    azimuth *= M_PI / 180;
    struct slopes slopes = {.axis = {{cos(azimuth), sin(azimuth)}, {-sin(azimuth), cos(azimuth)}}};
    for (int i = 0; i < LIGHT_SAMPLES; i++) {
        for (int a = 0; a < 2; a++) {
            double slope = slopes.axis[a][0] * samples->slopes[0][i] + slopes.axis[a][1] * samples->slopes[1][i];
            slopes.mean[a] += slope / LIGHT_SAMPLES;
            squares[a] += slope * slope / LIGHT_SAMPLES;
        }
    }
    for (int a = 0; a < 2; a++)
        slopes.deviation[a] = sqrt(fmax(squares[a] - slopes.mean[a] * slopes.mean[a], 0));
    return slopes;
}

/* How much the footprint changes over a standard deviation of the slopes along an axis, relative to its size. */
static double variation(const struct light_input *input, const struct coverage_flat *flat, const struct slopes *slopes,
                        int axis)
{
    double covariance[3][3], change = 0, size = 0;
    for (int k = 0; k < 3; k++) {
        double step = (k - 1) * slopes->deviation[axis];
        double at[2] = {step * slopes->axis[axis][0], step * slopes->axis[axis][1]};
        if (!footprint_at(input, flat, at, 1, covariance[k]))
            return 1;
    }
    for (int c = 0; c < 3; c++) {
        double twice = c == 1 ? 2 : 1, half = (covariance[2][c] - covariance[0][c]) / 2;
        double bend = (covariance[2][c] + covariance[0][c]) / 2 - covariance[1][c];
        change += twice * (half * half + bend * bend);
        size += twice * covariance[1][c] * covariance[1][c];
    }
    return sqrt(change / size);
}

/* Kinds along an axis for an error of at most `error`: that of one footprint for all is about a quarter of its
 * variation, and falls with the square of the distance between kinds. */
static int count_kinds(double change, double error)
{
    double single = change / 4;
    int count = single <= error ? 1 : 3;
    while (count > 1 && count < COVERAGE_KINDS_MAX && 1.8 * single / ((count - 1) * (count - 1)) > error)
        count += 2;
    return count;
}

/* How near the crests' focus the receiver is: 1, in focus or beyond it. A low sun's way is longer and its image drawn
 * out, so that it focuses sooner. */
static double focusing_at(const struct light_samples *samples, const struct coverage_flat *flat, double receiver)
{
    double slant = pow(fabs(flat->q), 3);
    return fmin(fabs(receiver) * light_power(receiver, flat->ior) * samples->curvature * slant, 1);
}

int coverage_choose_fineness(const struct light_samples *samples, const struct coverage_flat *flat, double receiver,
                             double radius, double error, int most)
{
    double coarse = 0.075 * fmin(pow(radius, -1.75), pow(radius, 0.3)) * pow(focusing_at(samples, flat, receiver), 3.5);
    double order = radius < 0.7 ? 1.5 : 2.3, fineness = ceil(pow(coarse / error, 1 / order));
    const double seen = 0.6; /* fine texels: the ellipse of a smaller radius is all in one */
    return fineness <= 1 ? 1 : (int)fmin(fmax(fineness, ceil(seen / radius)), most);
}

bool coverage_mean_footprint(const struct light_input *input, const struct light_samples *samples,
                             const struct coverage_flat *flat, double receiver, double covariance[3])
{
    int count = 0;
    memset(covariance, 0, 3 * sizeof *covariance);
    for (int i = 0; i < LIGHT_SAMPLES; i += 8) {
        double one[3], at[2] = {samples->slopes[0][i], samples->slopes[1][i]};
        if (!footprint_at(input, flat, at, way_from(samples, i, receiver), one))
            continue;
        count++;
        for (int c = 0; c < 3; c++)
            covariance[c] += one[c];
    }
    for (int c = 0; c < 3; c++)
        covariance[c] /= count > 0 ? count : 1;
    return count > 0;
}

static void set_kinds(struct coverage_plan *plan, const struct slopes *slopes)
{
    struct coverage_kinds *kinds = &plan->kinds;
    for (int a = 0; a < 2; a++) {
        double range = WIDTHS * slopes->deviation[a];
        double per_slope = kinds->count[a] > 1 && range > 0 ? (kinds->count[a] - 1) / (2 * range) : 0;
        kinds->offset[a] = (kinds->count[a] - 1) / 2.0 - per_slope * slopes->mean[a];
        kinds->per_slope[a][0] = per_slope * slopes->axis[a][0];
        kinds->per_slope[a][1] = per_slope * slopes->axis[a][1];
    }
}

static double place_among(const struct coverage_kinds *kinds, int axis, const double slopes[2])
{
    double place = kinds->offset[axis] + kinds->per_slope[axis][0] * slopes[0] + kinds->per_slope[axis][1] * slopes[1];
    return fmin(fmax(place, 0), kinds->count[axis] - 1);
}

/* A footprint of thousands of tiles gives what one of some tens gives. */
static void limit(double covariance[3])
{
    double most = pow(RADIUS_END / 2, 2), scale = fmin(most / fmax(fmax(covariance[0], covariance[2]), most), 1);
    for (int c = 0; c < 3; c++)
        covariance[c] *= scale;
}

/* Gives each kind the mean footprint of the samples that belong to it; where there are none, that of all. */
static bool make_footprints(struct coverage_plan *plan, const struct light_input *input,
                            const struct light_samples *samples, const struct coverage_flat *flat, double receiver,
                            double scale)
{
    double sums[COVERAGE_KINDS_MAX * COVERAGE_KINDS_MAX][4] = {{0}}, covariance[3], total = 0;
    const struct coverage_kinds *kinds = &plan->kinds;
    for (int i = 0; i < LIGHT_SAMPLES; i++) {
        double at[2] = {samples->slopes[0][i], samples->slopes[1][i]};
        if (!footprint_at(input, flat, at, way_from(samples, i, receiver), covariance))
            continue;
        double place[2] = {place_among(kinds, 0, at), place_among(kinds, 1, at)};
        for (int k = 0; k < kinds->count[0] * kinds->count[1]; k++) {
            double first = 1 - fabs(place[0] - k % kinds->count[0]);
            double second = 1 - fabs(place[1] - k / kinds->count[0]);
            double share = fmax(first, 0) * fmax(second, 0);
            for (int c = 0; c < 3; c++)
                sums[k][c] += share * covariance[c];
            sums[k][3] += share;
            total += share;
        }
    }
    double mean[3];
    coverage_mean_footprint(input, samples, flat, receiver, mean);
    plan->count = plan->reach = 0;
    for (int k = 0; k < kinds->count[0] * kinds->count[1]; k++) {
        struct coverage_footprint *footprint = plan->footprints + plan->count++;
        double texels = scale * scale / fmax(sums[k][3], 1e-9);
        footprint->kind[0] = k % kinds->count[0];
        footprint->kind[1] = k / kinds->count[0];
        footprint->level = sums[k][3] / fmax(total, 1e-9);
        for (int c = 0; c < 3; c++)
            covariance[c] = sums[k][c] * texels;
        if (sums[k][3] == 0)
            for (int c = 0; c < 3; c++)
                covariance[c] = mean[c] * scale * scale;
        limit(covariance);
        if (!coverage_footprint_make(footprint, covariance, plan->fineness, &plan->raster, input->log))
            return false;
        plan->reach = footprint->reach > plan->reach ? footprint->reach : plan->reach;
    }
    return true;
}

static void plan_point_sun(struct coverage_plan *plan, int side, int fineness)
{
    plan->side = side;
    plan->fineness = fineness;
    plan->kinds = (struct coverage_kinds){.count = {1, 1}};
    plan->count = 1;
    plan->reach = 0;
    plan->footprints[0].count = 0;
    plan->footprints[0].level = 0;
}

bool coverage_plan_make(struct coverage_plan *plan, const struct light_input *input,
                        const struct light_samples *samples, const struct coverage_flat *flat, int slice, int side)
{
    const struct coverage *params = input->params;
    double receiver = input->receivers[slice], size = input->windows[slice].side;
    double covariance[3], scale = side / size, error = input->settings->error / 100;
    bool arrives = coverage_mean_footprint(input, samples, flat, receiver, covariance);
    double radius = 2 * sqrt(fmax(covariance[0], covariance[2])) * scale;
    if (!arrives || radius < COVERAGE_RADIUS_MIN) {
        plan_point_sun(plan, side, params->fineness ? params->fineness : 1);
        return true;
    }
    plan->side = side;
    while (radius * plan->side / side > RADIUS_MAX && plan->side > 1)
        plan->side = (plan->side + 1) / 2;
    radius *= (double)plan->side / side;
    double focusing = focusing_at(samples, flat, receiver);
    struct slopes slopes = measure_slopes(input, samples);
    plan->fineness = params->fineness
                         ? params->fineness
                         : coverage_choose_fineness(samples, flat, receiver, radius, error, COVERAGE_FINENESS_MAX);
    for (int a = 0; a < 2; a++)
        plan->kinds.count[a] = plan->side == 1 ? 1
                               : params->footprints
                                   ? params->footprints
                                   : count_kinds(variation(input, flat, &slopes, a) * focusing * focusing, error);
    set_kinds(plan, &slopes);
    return make_footprints(plan, input, samples, flat, receiver, plan->side / size * plan->fineness);
}

void coverage_plan_finish(struct coverage_plan *plan)
{
    for (int k = 0; k < COVERAGE_KINDS_MAX * COVERAGE_KINDS_MAX; k++)
        coverage_footprint_finish(plan->footprints + k);
    free(plan->raster.cells);
    *plan = (struct coverage_plan){0};
}
