/* The footprint of the sun's disc as weights of texels, for coverage_gpu.c. */
#include "light/coverage.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define REACH 7 /* texels from the middle that a footprint may touch */
#define SIDE (2 * REACH + 1)
#define RADIUS_MAX 5.5 /* texels; a wider one is drawn with larger texels */

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
static double choose_side(struct coverage_disc *disc, double radius)
{
    while (radius * disc->side / disc->map_side > RADIUS_MAX && disc->side > 1) {
        disc->level++;
        disc->side = (disc->side + 1) / 2;
    }
    return radius * disc->side / disc->map_side;
}

/* The weight of texel (x, z) of a finer sharp map for a texel of the map: the mean over the latter's own. */
static double weight_at(double cells[SIDE][SIDE], int fineness, int x, int z)
{
    double sum = 0;
    for (int j = z; j > z - fineness; j--)
        for (int i = x; i > x - fineness; i--)
            if (abs(i) <= REACH && abs(j) <= REACH)
                sum += cells[j + REACH][i + REACH];
    return sum / (fineness * fineness);
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
    for (int z = -REACH; z < REACH + disc->fineness; z++) {
        for (int x = -REACH; x < REACH + disc->fineness; x++) {
            float *tap = disc->taps[disc->count], middle = (float)(disc->fineness - 1) / 2;
            tap[0] = (float)x - middle;
            tap[1] = (float)z - middle;
            tap[2] = (float)weight_at(cells, disc->fineness, x, z);
            disc->count += tap[2] > 0 && disc->count + 1 < COVERAGE_TAPS;
        }
    }
}

void coverage_disc_make(struct coverage_disc *disc, int side, const double covariance[3], int fineness)
{
    if (disc->map_side == side && disc->fineness == fineness &&
        !memcmp(disc->covariance, covariance, sizeof disc->covariance))
        return;
    *disc = (struct coverage_disc){.map_side = side, .side = side * fineness, .fineness = fineness};
    memcpy(disc->covariance, covariance, sizeof disc->covariance);
    double radius = choose_side(disc, 2 * sqrt(fmax(covariance[0], covariance[2])));
    if (radius >= COVERAGE_RADIUS_MIN)
        make_taps(disc, fmin(1, pow(RADIUS_MAX / radius, 2)));
}

int coverage_disc_fineness(double radius, int wanted)
{
    while (wanted > 1 && radius * wanted > RADIUS_MAX - 1)
        wanted--;
    return wanted;
}
