/* The footprint of the sun's disc as weights of texels, for coverage_gpu.c. */
#include "light/coverage_gpu.h"

#include <math.h>
#include <string.h>

#define REACH 7 /* texels from the middle that a footprint may touch */
#define SIDE (2 * REACH + 1)
#define RADIUS_POINT 0.02 /* texels; a narrower disc is a point */
#define RADIUS_NARROW 1.0 /* texels; a narrower one is left to the cells, which know places between texels */
#define RADIUS_MAX 5.5    /* texels; a wider one is drawn with larger texels */

/* The share of a uniform ellipse in each texel. */
static void rasterise(const double covariance[3], double cells[SIDE][SIDE])
{
    enum { LINES = 512 };
    double high = 2 * sqrt(covariance[2]), lean = covariance[1] / fmax(covariance[2], 1e-12);
    double wide = 2 * sqrt(fmax(covariance[0] - lean * covariance[1], 0)), total = 0;
    memset(cells, 0, sizeof(double[SIDE][SIDE]));
    for (int l = 0; l < LINES; l++) {
        double part = 2 * (l + 0.5) / LINES - 1, z = part * high, share = sqrt(1 - part * part); /* of a chord */
        double left = lean * z - wide * share + 0.5 + REACH, right = lean * z + wide * share + 0.5 + REACH;
        int row = (int)floor(z + 0.5) + REACH;
        right = fmax(right, left + 1e-9);
        for (int i = (int)floor(left); i <= (int)floor(right); i++)
            cells[row][i] += share * (fmin(i + 1, right) - fmax(i, left)) / (right - left);
        total += share;
    }
    for (int i = 0; i < SIDE * SIDE; i++)
        cells[i / SIDE][i % SIDE] /= total;
}

static double mean_square(double cells[SIDE][SIDE])
{
    double sum = 0;
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++)
            sum += cells[j][i] * ((i - REACH) * (i - REACH) + (j - REACH) * (j - REACH));
    return sum;
}

/* Texels are squares that smear too: the ellipse is made smaller, until all together smear as widely as the disc. */
static void fit(const double covariance[3], double wanted, double cells[SIDE][SIDE])
{
    double least = 0, most = 1;
    for (int i = 0; i < 24; i++) {
        double scale = (least + most) / 2;
        rasterise((const double[3]){covariance[0] * scale, covariance[1] * scale, covariance[2] * scale}, cells);
        *(mean_square(cells) < wanted ? &least : &most) = scale;
    }
}

/* The largest texels of the sharp map in which the footprint is still drawn well; returns the footprint's radius there.
 */
static double choose_side(struct coverage_disc *disc)
{
    double radius = 2 * sqrt(fmax(disc->covariance[0], disc->covariance[2]));
    while (radius * disc->side / disc->map_side > RADIUS_MAX && disc->side > 1) {
        disc->level++;
        disc->side = (disc->side + 1) / 2;
    }
    return radius * disc->side / disc->map_side;
}

/* Makes the taps; `scale`: of the covariance. */
static void make_taps(struct coverage_disc *disc, double scale)
{
    double cells[SIDE][SIDE], texel = (double)disc->map_side / disc->side, covariance[3];
    for (int i = 0; i < 3; i++)
        covariance[i] = disc->covariance[i] * scale / (texel * texel);
    /* Larger texels, and values between them, smear by 1/12 and 1/6 along each axis; the map's own by 1/12 of theirs.
     */
    double smeared = disc->level ? 2 * (1.0 / 12 + 1.0 / 6 - 1.0 / 12 / (texel * texel)) : 0;
    fit(covariance, covariance[0] + covariance[2] - smeared, cells);
    for (int i = 0; i < SIDE * SIDE; i++) {
        float *tap = disc->taps[disc->count];
        tap[0] = (float)(i % SIDE - REACH);
        tap[1] = (float)(i / SIDE - REACH);
        tap[2] = (float)cells[i / SIDE][i % SIDE];
        disc->count += tap[2] > 0 && disc->count + 1 < COVERAGE_TAPS;
    }
}

void coverage_disc_make(struct coverage_disc *disc, int side, const double covariance[3])
{
    if (disc->map_side == side && !memcmp(disc->covariance, covariance, sizeof disc->covariance))
        return;
    *disc = (struct coverage_disc){.map_side = side, .side = side};
    memcpy(disc->covariance, covariance, sizeof disc->covariance);
    double radius = choose_side(disc);
    disc->narrow = radius > RADIUS_POINT && radius < RADIUS_NARROW;
    if (radius >= RADIUS_NARROW)
        make_taps(disc, fmin(1, pow(RADIUS_MAX / radius, 2)));
}
