/* How finely a receiver is computed, and the sun's footprints on it.
 *
 * Each point of the sun throws its own caustics, moved a little. Their mean is a point sun's light with every piece of
 * it smeared over the footprint that the refracted disc has there: an ellipse, whose axes depend on how steeply the
 * light meets the surface. A few footprints, for slopes on a grid, serve all: light between them is shared out. */
#include "light/coverage.h"

#include <math.h>
#include <string.h>

#define SAMPLES 48 /* vertices a side that the surface's slopes are known from */
#define WIDTHS 2.2 /* standard deviations of the slopes that the grid of kinds reaches over, to either side */

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

/* The i-th of SAMPLES² vertices: its slopes and how far its light goes down, or up. */
static double sample(const struct light_input *input, double receiver, int i, double slopes[2])
{
    const struct surface *surface = input->surface;
    size_t column = (size_t)(i % SAMPLES) * (size_t)surface->columns / SAMPLES;
    size_t row = (size_t)(i / SAMPLES) * (size_t)surface->rows / SAMPLES;
    const float *texel = surface->texels + (row * (size_t)surface->columns + column) * 3;
    slopes[0] = (double)texel[1];
    slopes[1] = (double)texel[2];
    return receiver > 0 ? fmax(receiver - (double)texel[0], 0) : fmin(receiver - (double)texel[0], 0);
}

/* What is known of the surface: its slopes along the sun's azimuth and across it, and how curved it is. */
struct slopes {
    double axis[2][2];
    double mean[2], deviation[2];
    double curvature; /* 1/m: of the crests of a wave alone; the root of the sum of squares of many */
};

/* Sum of the second derivatives at the i-th of the vertices, by differences. */
static double bend(const struct surface *surface, int i)
{
    int column = i % SAMPLES * (surface->columns - 1) / SAMPLES, row = i / SAMPLES * (surface->rows - 1) / SAMPLES;
    const float *here = surface->texels + ((size_t)row * (size_t)surface->columns + (size_t)column) * 3;
    const float *right = here + 3, *below = here + 3 * (size_t)surface->columns;
    return (double)(right[1] - here[1] + below[2] - here[2]) / surface_spacing(surface);
}

static struct slopes measure_slopes(const struct light_input *input, double receiver)
{
    double azimuth = input->sun->azimuth * M_PI / 180, sum[2] = {0}, squares[2] = {0}, bends = 0, at[2];
    struct slopes slopes = {.axis = {{cos(azimuth), sin(azimuth)}, {-sin(azimuth), cos(azimuth)}}};
    for (int i = 0; i < SAMPLES * SAMPLES; i++) {
        sample(input, receiver, i, at);
        bends += pow(bend(input->surface, i), 2) / (SAMPLES * SAMPLES);
        for (int a = 0; a < 2; a++) {
            double slope = slopes.axis[a][0] * at[0] + slopes.axis[a][1] * at[1];
            sum[a] += slope / (SAMPLES * SAMPLES);
            squares[a] += slope * slope / (SAMPLES * SAMPLES);
        }
    }
    for (int a = 0; a < 2; a++) {
        slopes.mean[a] = sum[a];
        slopes.deviation[a] = sqrt(fmax(squares[a] - sum[a] * sum[a], 0));
    }
    slopes.curvature = sqrt(2 * bends);
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

/* Kinds along an axis for an error of at most `error`: that of one footprint for all is about a sixth of its variation,
 * and falls with the square of the distance between kinds. */
static int count_kinds(double change, double error)
{
    double single = change / 6;
    int count = single <= error ? 1 : 3;
    while (count > 1 && count < COVERAGE_KINDS_MAX && 1.8 * single / ((count - 1) * (count - 1)) > error)
        count += 2;
    return count;
}

/* Texels computed along each side of one of the map. What smearing whole texels adds was measured: most where the
 * disc's radius is a texel, less the finer they are, and little where crests do not focus yet. */
static int choose_fineness(const struct coverage_flat *flat, const struct slopes *slopes, double receiver,
                           double radius, double error)
{
    double power = flat->upwards ? 2 : 1 - 1 / flat->ior;                  /* of a curved surface as a lens or mirror */
    double focusing = fmin(fabs(receiver) * power * slopes->curvature, 1); /* 1: in focus */
    double coarse = 0.075 * fmin(pow(radius, -1.75), pow(radius, 0.6)) * pow(focusing, 3.5);
    double order = radius < 0.7 ? 1.5 : 2.3;
    return (int)fmin(fmax(ceil(pow(coarse / error, 1 / order)), 1), COVERAGE_FINENESS_MAX);
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

/* Gives each kind the mean footprint of the light that belongs to it. Kinds without light are left out. */
static bool make_footprints(struct coverage_plan *plan, const struct light_input *input,
                            const struct coverage_flat *flat, double receiver, double scale)
{
    double sums[COVERAGE_KINDS_MAX * COVERAGE_KINDS_MAX][4] = {{0}}, at[2], covariance[3], total = 0;
    const struct coverage_kinds *kinds = &plan->kinds;
    for (int i = 0; i < SAMPLES * SAMPLES; i++) {
        double way = sample(input, receiver, i, at);
        if (!footprint_at(input, flat, at, way, covariance))
            continue;
        for (int k = 0; k < kinds->count[0] * kinds->count[1]; k++) {
            double first = 1 - fabs(place_among(kinds, 0, at) - k % kinds->count[0]);
            double second = 1 - fabs(place_among(kinds, 1, at) - k / kinds->count[0]);
            double share = fmax(first, 0) * fmax(second, 0);
            for (int c = 0; c < 3; c++)
                sums[k][c] += share * covariance[c];
            sums[k][3] += share;
            total += share;
        }
    }
    plan->count = plan->reach = 0;
    for (int k = 0; k < kinds->count[0] * kinds->count[1]; k++) {
        struct coverage_footprint *footprint = plan->footprints + plan->count++;
        double texels = scale * scale / fmax(sums[k][3], 1e-9);
        footprint->kind[0] = k % kinds->count[0];
        footprint->kind[1] = k / kinds->count[0];
        footprint->level = sums[k][3] / fmax(total, 1e-9);
        for (int c = 0; c < 3; c++)
            covariance[c] = sums[k][c] * texels;
        if (!coverage_footprint_make(footprint, covariance, plan->fineness, input->log))
            return false;
        plan->reach = footprint->reach > plan->reach ? footprint->reach : plan->reach;
    }
    return true;
}

static void plan_point_sun(struct coverage_plan *plan, int fineness)
{
    plan->fineness = fineness;
    plan->kinds = (struct coverage_kinds){.count = {1, 1}};
    plan->count = 1;
    plan->reach = 0;
    plan->footprints[0].count = 0;
    plan->footprints[0].level = 0;
}

bool coverage_plan_make(struct coverage_plan *plan, const struct light_input *input, const struct coverage_flat *flat,
                        double receiver, int side)
{
    const struct coverage *params = input->params;
    const double smallest = 0.02; /* texels: a footprint below it is a point */
    double covariance[3] = {0}, scale = side / input->surface->size, error = input->settings->error / 100;
    footprint_at(input, flat, (const double[2]){0, 0}, receiver, covariance);
    double radius = 2 * sqrt(fmax(covariance[0], covariance[2])) * scale;
    if (radius < smallest) {
        plan_point_sun(plan, params->fineness ? params->fineness : 1);
        return true;
    }
    struct slopes slopes = measure_slopes(input, receiver);
    plan->fineness = params->fineness ? params->fineness : choose_fineness(flat, &slopes, receiver, radius, error);
    for (int a = 0; a < 2; a++)
        plan->kinds.count[a] =
            params->footprints ? params->footprints : count_kinds(variation(input, flat, &slopes, a), error);
    set_kinds(plan, &slopes);
    return make_footprints(plan, input, flat, receiver, scale * plan->fineness);
}

void coverage_plan_finish(struct coverage_plan *plan)
{
    for (int k = 0; k < COVERAGE_KINDS_MAX * COVERAGE_KINDS_MAX; k++)
        coverage_footprint_finish(plan->footprints + k);
    *plan = (struct coverage_plan){0};
}
