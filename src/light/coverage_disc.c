/* The footprint of the sun's disc as weights of texels, for coverage_gpu.c. */
#include "light/coverage.h"

#include <math.h>
#include <string.h>

#define REACH 7 /* texels from the middle that a footprint may touch */
#define SIDE (2 * REACH + 1)
#define RADIUS_MAX 5.5 /* texels; a wider one is drawn with larger texels */

static double mean_square(const double *cells)
{
    double sum = 0;
    for (int j = -REACH; j <= REACH; j++)
        for (int i = -REACH; i <= REACH; i++)
            sum += cells[(j + REACH) * SIDE + i + REACH] * (i * i + j * j);
    return sum;
}

/* Texels are squares that smear too: the ellipse is made smaller, until all together smear as widely as the disc. */
static void fit(const double covariance[3], double wanted, double *cells)
{
    double least = 0, most = 1;
    for (int i = 0; i < 24; i++) {
        double scale = (least + most) / 2;
        coverage_ellipse((const double[3]){covariance[0] * scale, covariance[1] * scale, covariance[2] * scale}, REACH,
                         cells);
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

/* Makes the taps; `scale`: of the covariance. */
static void make_taps(struct coverage_disc *disc, double scale)
{
    double cells[SIDE * SIDE], texel = (double)disc->map_side / disc->side, covariance[3];
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
            tap[2] = (float)coverage_ellipse_weight(cells, REACH, disc->fineness, x, z);
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
