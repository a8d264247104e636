#include "scene/noise.h"

#include "base/random.h"

#include <math.h>

/* Random bits of a corner of the lattice. */
static uint64_t corner_bits(const int64_t corner[3], uint64_t seed)
{
    uint64_t bits = seed;
    for (int c = 0; c < 3; c++)
        bits = random_mix(bits + 0x9e3779b97f4a7c15u + (uint64_t)corner[c]);
    return bits;
}

/* The corner's gradient, one of the twelve to the middles of a cube's edges, times the way from the corner. */
static double ramp(const int64_t corner[3], const double way[3], uint64_t seed)
{
    uint64_t bits = corner_bits(corner, seed) >> 32;
    int across = (int)(bits % 3);
    double a = way[(across + 1) % 3], b = way[(across + 2) % 3];
    return (bits & 4096 ? a : -a) + (bits & 8192 ? b : -b);
}

double noise_smooth(const double place[3], uint64_t seed)
{
    int64_t low[3];
    double inside[3], blend[3], sum = 0;
    for (int c = 0; c < 3; c++) {
        double t = place[c] - floor(place[c]);
        low[c] = (int64_t)floor(place[c]);
        inside[c] = t;
        blend[c] = t * t * t * (t * (6 * t - 15) + 10);
    }
    for (int k = 0; k < 8; k++) {
        int64_t corner[3];
        double way[3], weight = 1;
        for (int c = 0; c < 3; c++) {
            int far = k >> c & 1;
            corner[c] = low[c] + far;
            way[c] = inside[c] - far;
            weight *= far ? blend[c] : 1 - blend[c];
        }
        sum += weight * ramp(corner, way, seed);
    }
    return sum;
}

double noise_fractal(const double place[3], int octaves, uint64_t seed)
{
    double sum = 0, weight = 0.5, at[3] = {place[0], place[1], place[2]};
    for (int o = 0; o < octaves; o++, weight *= 0.5) {
        sum += weight * noise_smooth(at, seed + (uint64_t)o);
        for (int c = 0; c < 3; c++)
            at[c] *= 2;
    }
    return sum;
}

double noise_ridged(const double place[3], int octaves, uint64_t seed)
{
    double sum = 0, weight = 0.5, strong = 1, at[3] = {place[0], place[1], place[2]};
    for (int o = 0; o < octaves; o++, weight *= 0.5) {
        double ridge = fmax(1 - fabs(noise_smooth(at, seed + (uint64_t)o)), 0);
        ridge *= ridge * strong;
        sum += weight * ridge;
        strong = fmin(2 * ridge, 1);
        for (int c = 0; c < 3; c++)
            at[c] *= 2;
    }
    return sum;
}

void noise_cells(const double place[3], uint64_t seed, double distances[2])
{
    distances[0] = distances[1] = INFINITY;
    for (int k = 0; k < 27; k++) {
        const int steps[3] = {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
        int64_t cell[3];
        double squared = 0;
        for (int c = 0; c < 3; c++)
            cell[c] = (int64_t)floor(place[c]) + steps[c];
        uint64_t bits = corner_bits(cell, seed);
        for (int c = 0; c < 3; c++) {
            double way = (double)cell[c] + random_fraction(bits + (uint64_t)c) - place[c];
            squared += way * way;
        }
        distances[1] = fmin(distances[1], fmax(distances[0], sqrt(squared)));
        distances[0] = fmin(distances[0], sqrt(squared));
    }
}
