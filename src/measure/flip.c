/* ꟻLIP of pictures of low dynamic range: Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström & Fairchild 2020, "FLIP:
 * A Difference Evaluator for Alternating Images".
 *
 *   colours   sRGB → YCxCz, filtered as the eye does from afar, → L*a*b*, distance HyAB, mapped to 0 to 1
 *   features  edges and points of the luminance: how much stronger in one picture than in the other, 0 to 1
 *   ꟻLIP      colours ^ (1 - features)
 *
 * Every filter of the paper is a sum of products of a function of x and a function of y, and is applied as such. */
#include "dapple/measure.h"

#include "base/log.h"
#include "measure/pair.h"
#include "measure/space.h"

#include <math.h>
#include <stdlib.h>

#define PI 3.14159265358979323846
#define RADIUS_MAX 256        /* pixels, of a filter; at 67 pixels per degree it is 10 */
#define COLOR_EXPONENT 0.7    /* q_c */
#define COLOR_KNEE 0.4        /* p_c: share of the largest distance that is mapped to … */
#define COLOR_KNEE_VALUE 0.95 /* p_t */
#define FEATURE_EXPONENT 0.5  /* q_f */
#define FEATURE_WIDTH 0.082   /* w, degrees */

/* A filter along one axis at whole pixels, -radius to radius. */
struct kernel {
    int radius;
    float weights[2 * RADIUS_MAX + 1];
};

enum plane { LIGHTNESS, A, B, EDGES, POINTS, LUMINANCE, CHANNEL, FIRST, SECOND, BETWEEN, PLANES };

/* A picture on its way from sRGB to what is compared: the first five planes. */
struct sight {
    int width, height;
    size_t count; /* pixels */
    float *planes[PLANES];
};

/* L*a*b* whose colours lose strength in the dark (Hunt 1952). */
static void adjusted_lab(const double linear[3], double lab[3])
{
    space_linear_to_lab(linear, lab);
    lab[1] *= 0.01 * lab[0];
    lab[2] *= 0.01 * lab[0];
}

/* Distance of two colours, Abasi, Tehran & Fairchild 2019. */
static double hyab(const double a[3], const double b[3])
{
    return fabs(a[0] - b[0]) + hypot(a[1] - b[1], a[2] - b[2]);
}

/* Filters a plane along x and along y; beyond its edge the edge goes on. */
static void convolve(struct sight *sight, enum plane from, const struct kernel *x, const struct kernel *y,
                     enum plane to)
{
    int width = sight->width, height = sight->height;
    const float *in = sight->planes[from];
    float *between = sight->planes[BETWEEN], *out = sight->planes[to];
#pragma omp parallel for
    for (int j = 0; j < height; j++) {
        const float *row = in + (size_t)j * (size_t)width;
        for (int i = 0; i < width; i++) {
            float sum = 0;
            for (int k = -x->radius; k <= x->radius; k++)
                sum += x->weights[k + x->radius] * row[i + k < 0 ? 0 : i + k >= width ? width - 1 : i + k];
            between[(size_t)j * (size_t)width + (size_t)i] = sum;
        }
    }
#pragma omp parallel for
    for (int j = 0; j < height; j++) {
        float *row = out + (size_t)j * (size_t)width;
        for (int i = 0; i < width; i++)
            row[i] = 0;
        for (int k = -y->radius; k <= y->radius; k++) {
            int line = j + k < 0 ? 0 : j + k >= height ? height - 1 : j + k;
            for (int i = 0; i < width; i++)
                row[i] += y->weights[k + y->radius] * between[(size_t)line * (size_t)width + (size_t)i];
        }
    }
}

/* Returns the sum of the weights. */
static double fill_gaussian(struct kernel *kernel, int radius, double deviation, double factor)
{
    double sum = 0;
    kernel->radius = radius;
    for (int k = -radius; k <= radius; k++) {
        double weight = factor * exp(-0.5 * k * k / (deviation * deviation));
        kernel->weights[k + radius] = (float)weight;
        sum += weight;
    }
    return sum;
}

/* Filters CHANNEL, the c-th of YCxCz, by the eye's sensitivity to contrast, a sum of a √(π/b) exp(-π² d²/b) over d in
 * degrees, into plane c. */
static void filter_channel(struct sight *sight, int c, double pixels_per_degree)
{
    static const struct {
        double a, b;
    } terms[3][2] = {{{1, 0.0047}, {0, 1e-5}}, {{1, 0.0053}, {0, 1e-5}}, {{34.1, 0.04}, {13.5, 0.025}}};
    const double widest = 0.04; /* the largest b: one radius serves all */
    int radius = (int)ceil(3 * sqrt(widest / (2 * PI * PI)) * pixels_per_degree);
    struct kernel kernel;
    double total = 0, factors[2], deviations[2];
    for (int t = 0; t < 2; t++) {
        deviations[t] = pixels_per_degree * sqrt(terms[c][t].b / 2) / PI;
        factors[t] = terms[c][t].a * sqrt(PI / terms[c][t].b);
        total += factors[t] * pow(fill_gaussian(&kernel, radius, deviations[t], 1), 2);
    }
    for (int t = 0; t < 2 && factors[t] > 0; t++) {
        fill_gaussian(&kernel, radius, deviations[t], sqrt(factors[t] / total));
        convolve(sight, CHANNEL, &kernel, &kernel, FIRST);
        for (size_t i = 0; i < sight->count; i++)
            sight->planes[c][i] = (t ? sight->planes[c][i] : 0) + sight->planes[FIRST][i];
    }
}

/* Edges or points of the luminance: the length of the filtered luminance's gradient, or of its second derivatives. */
static void find_features(struct sight *sight, enum plane features, double pixels_per_degree)
{
    double deviation = 0.5 * FEATURE_WIDTH * pixels_per_degree, above = 0, below = 0;
    struct kernel smooth, derived;
    int radius = (int)ceil(3 * deviation);
    double sum = fill_gaussian(&smooth, radius, deviation, 1);
    fill_gaussian(&smooth, radius, deviation, 1 / sum);
    derived.radius = radius;
    for (int k = -radius; k <= radius; k++) {
        double order = features == EDGES ? -k : k * k / (deviation * deviation) - 1;
        float weight = (float)(order * smooth.weights[k + radius]);
        derived.weights[k + radius] = weight;
        above += fmax(weight, 0);
        below += fmax(-weight, 0);
    }
    for (int k = 0; k <= 2 * radius; k++)
        derived.weights[k] /= (float)(derived.weights[k] > 0 ? above : below);
    convolve(sight, LUMINANCE, &derived, &smooth, FIRST);
    convolve(sight, LUMINANCE, &smooth, &derived, SECOND);
    for (size_t i = 0; i < sight->count; i++)
        sight->planes[features][i] = hypotf(sight->planes[FIRST][i], sight->planes[SECOND][i]);
}

/* The c-th channel of YCxCz of a picture. */
static void fill_channel(struct sight *sight, const struct dpl_image *picture, int c)
{
    for (size_t i = 0; i < sight->count; i++) {
        const float *pixel = picture->pixels + i * 3;
        double linear[3] = {space_srgb_decode(pixel[0]), space_srgb_decode(pixel[1]), space_srgb_decode(pixel[2])},
               xyz[3];
        space_linear_to_xyz(linear, xyz);
        const double channels[3] = {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
        sight->planes[CHANNEL][i] = (float)channels[c];
        sight->planes[LUMINANCE][i] = (float)xyz[1];
    }
}

/* Turns the filtered channels into L*a*b*. */
static void filtered_to_lab(struct sight *sight)
{
    for (size_t i = 0; i < sight->count; i++) {
        float *const *planes = sight->planes;
        double y = (planes[0][i] + 16) / 116, linear[3], lab[3];
        const double xyz[3] = {y + planes[1][i] / 500, y, y - planes[2][i] / 200};
        space_xyz_to_linear(xyz, linear);
        for (int c = 0; c < 3; c++)
            linear[c] = fmin(fmax(linear[c], 0), 1);
        adjusted_lab(linear, lab);
        for (int c = 0; c < 3; c++)
            planes[c][i] = (float)lab[c];
    }
}

static bool see(struct sight *sight, const struct dpl_image *picture, double pixels_per_degree,
                const struct dpl_log *log)
{
    *sight = (struct sight){.width = picture->width, .height = picture->height};
    sight->count = (size_t)picture->width * (size_t)picture->height;
    float *values = base_allocate(log, sight->count * PLANES, sizeof *values, "picture to compare");
    if (!values)
        return false;
    for (int p = 0; p < PLANES; p++)
        sight->planes[p] = values + (size_t)p * sight->count;
    for (int c = 0; c < 3; c++) {
        fill_channel(sight, picture, c);
        filter_channel(sight, c, pixels_per_degree);
    }
    filtered_to_lab(sight);
    find_features(sight, EDGES, pixels_per_degree);
    find_features(sight, POINTS, pixels_per_degree);
    return true;
}

/* The largest distance that colours have: green from blue. */
static double largest_distance(void)
{
    double green[3], blue[3];
    adjusted_lab((const double[3]){0, 1, 0}, green);
    adjusted_lab((const double[3]){0, 0, 1}, blue);
    return pow(hyab(green, blue), COLOR_EXPONENT);
}

static double pixel_difference(const struct sight *a, const struct sight *b, size_t i, double largest)
{
    const double lab_a[3] = {a->planes[LIGHTNESS][i], a->planes[A][i], a->planes[B][i]};
    const double lab_b[3] = {b->planes[LIGHTNESS][i], b->planes[A][i], b->planes[B][i]};
    double distance = pow(hyab(lab_a, lab_b), COLOR_EXPONENT), knee = COLOR_KNEE * largest;
    double color = distance < knee ? distance / knee * COLOR_KNEE_VALUE
                                   : COLOR_KNEE_VALUE + (distance - knee) / (largest - knee) * (1 - COLOR_KNEE_VALUE);
    double edges = fabs(a->planes[EDGES][i] - b->planes[EDGES][i]);
    double points = fabs(a->planes[POINTS][i] - b->planes[POINTS][i]);
    double feature = fmin(pow(fmax(edges, points) / sqrt(2), FEATURE_EXPONENT), 1);
    return pow(color, 1 - feature);
}

bool dpl_measure_flip(const struct dpl_image *picture, const struct dpl_image *reference, double pixels_per_degree,
                      double *mean, const struct dpl_log *log)
{
    const double least = 10, most = 1000; /* the filters are then wide enough to have a shape, and fit RADIUS_MAX */
    if (!(pixels_per_degree >= least && pixels_per_degree <= most))
        return base_fail(log, DPL_REASON_RANGE, "pixels per degree: out of range: \"%g\" (accepted: %g to %g)",
                         pixels_per_degree, least, most);
    struct sight a = {0}, b = {0};
    bool ok = pair_check(picture, reference, log) && see(&a, picture, pixels_per_degree, log) &&
              see(&b, reference, pixels_per_degree, log);
    if (ok) {
        double sum = 0, largest = largest_distance();
        for (size_t i = 0; i < a.count; i++)
            sum += pixel_difference(&a, &b, i, largest);
        *mean = sum / (double)a.count;
    }
    free(a.planes[0]);
    free(b.planes[0]);
    return ok;
}
