/* The sun's disc as a sum along rows: the footprint of one kind of light. */
#include "light/coverage.h"

#include "base/log.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void coverage_ellipse(const double covariance[3], int reach, double *cells)
{
    double high = 2 * sqrt(covariance[2]), lean = covariance[1] / fmax(covariance[2], 1e-300);
    double wide = 2 * sqrt(fmax(covariance[0] - lean * covariance[1], 0)), total = 0;
    int side = 2 * reach + 1, chords = 256 + 32 * (int)high;
    memset(cells, 0, (size_t)side * (size_t)side * sizeof *cells);
    for (int k = 0; k < chords; k++) {
        double part = 2 * (k + 0.5) / chords - 1, weight = sqrt(1 - part * part);
        double half = fmax(wide * weight, 1e-9), middle = lean * part * high + 0.5 + reach;
        int row = (int)floor(part * high + 0.5) + reach;
        for (int i = (int)floor(middle - half); i <= (int)floor(middle + half); i++)
            cells[row * side + i] += weight * (fmin(i + 1, middle + half) - fmax(i, middle - half)) / (2 * half);
        total += weight;
    }
    for (int i = 0; i < side * side; i++)
        cells[i] /= total;
}

double coverage_ellipse_weight(const double *cells, int reach, int fineness, int x, int z)
{
    double sum = 0;
    for (int j = 0; j < fineness; j++)
        for (int i = 0; i < fineness; i++)
            if (abs(x - i) <= reach && abs(z - j) <= reach)
                sum += cells[(z - j + reach) * (2 * reach + 1) + x - i + reach];
    return sum / (fineness * fineness);
}

static bool make_room(struct coverage_footprint *footprint, int count, const struct dpl_log *log)
{
    if (footprint->room >= count)
        return true;
    free(footprint->taps);
    footprint->taps = base_allocate(log, (size_t)count, sizeof *footprint->taps, "footprint of the sun");
    footprint->room = footprint->taps ? count : 0;
    return footprint->taps != NULL;
}

static bool grow(struct coverage_raster *raster, size_t count, const struct dpl_log *log)
{
    if (raster->room >= count)
        return true;
    free(raster->cells);
    raster->cells = base_allocate(log, count, sizeof *raster->cells, "footprint of the sun");
    raster->room = raster->cells ? count : 0;
    return raster->cells != NULL;
}

bool coverage_footprint_make(struct coverage_footprint *footprint, const double covariance[3], int fineness,
                             struct coverage_raster *raster, const struct dpl_log *log)
{
    const double changes_nothing = 1e-9;
    double extent = 2 * sqrt(fmax(covariance[0], covariance[2]));
    int reach = (int)floor(extent + 0.5) + 1, side = 2 * reach + 1, wide = 2 * reach + fineness + 1;
    if (!grow(raster, (size_t)side * (size_t)side, log) || !make_room(footprint, wide * wide, log))
        return false;
    double *cells = raster->cells;
    coverage_ellipse(covariance, reach, cells);
    footprint->reach = reach;
    footprint->count = 0;
    for (int z = -reach; z < fineness + reach; z++) {
        double before = 0; /* the weight of the column to the left */
        for (int x = -reach; x <= fineness + reach; x++) {
            double here = coverage_ellipse_weight(cells, reach, fineness, x, z);
            if (fabs(before - here) > changes_nothing)
                footprint->taps[footprint->count++] = (struct coverage_tap){x - 1, z, (float)(before - here)};
            before = here;
        }
    }
    return true;
}

void coverage_footprint_finish(struct coverage_footprint *footprint)
{
    free(footprint->taps);
    *footprint = (struct coverage_footprint){0};
}
