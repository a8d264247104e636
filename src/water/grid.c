#include "water/grid.h"

#include "base/vector.h"

#include <math.h>

/* The four vertices along one axis that a point's height depends on, and how: weights of the height and of the slope
 * per cell. */
struct stencil {
    int vertices[4];
    double value[4], slope[4];
};

static int vertex_at(const struct height_grid *grid, int place)
{
    int last = grid->side - 1;
    if (grid->periodic)
        return (place % grid->side + grid->side) % grid->side;
    return place < 0 ? 0 : place > last ? last : place;
}

/* `place` counts cells from the first vertex. */
static struct stencil stencil_at(const struct height_grid *grid, double place)
{
    double cell = floor(place), t = place - cell;
    struct stencil stencil = {
        .value = {t * (-1 + t * (2 - t)) / 2, 1 + t * t * (3 * t - 5) / 2, t * (1 + t * (4 - 3 * t)) / 2,
                  t * t * (t - 1) / 2},
        .slope = {(-1 + t * (4 - 3 * t)) / 2, t * (9 * t - 10) / 2, (1 + t * (8 - 9 * t)) / 2, t * (3 * t - 2) / 2},
    };
    for (int k = 0; k < 4; k++)
        stencil.vertices[k] = vertex_at(grid, (int)cell + k - 1);
    return stencil;
}

/* Where a coordinate lies, in cells from the first vertex. */
static double place_of(const struct height_grid *grid, double coordinate)
{
    double share = coordinate / grid->size + 0.5;
    if (grid->periodic)
        return (share - floor(share)) * grid->side;
    return fmin(fmax(share * (grid->side - 1), -2), grid->side + 1); /* flat beyond */
}

void grid_sample(const struct height_grid *grid, struct water_points *points)
{
    double per_spacing = (grid->periodic ? grid->side : grid->side - 1) / grid->size;
    for (int i = 0; i < points->count; i++) {
        struct stencil x = stencil_at(grid, place_of(grid, points->x[i]));
        struct stencil z = stencil_at(grid, place_of(grid, points->z[i]));
        double height = 0, slope_x = 0, slope_z = 0;
        for (int j = 0; j < 4; j++) {
            const float *row = grid->heights + (size_t)z.vertices[j] * (size_t)grid->side;
            double value = 0, slope = 0;
            for (int k = 0; k < 4; k++) {
                value += x.value[k] * (double)row[x.vertices[k]];
                slope += x.slope[k] * (double)row[x.vertices[k]];
            }
            height += z.value[j] * value;
            slope_x += z.value[j] * slope;
            slope_z += z.slope[j] * value;
        }
        points->height[i] = height;
        points->slope_x[i] = slope_x * per_spacing;
        points->slope_z[i] = slope_z * per_spacing;
    }
}

/* The vertices of a row that have neighbours on both sides. */
VECTOR_CLONES static void fill_inside(int side, float scale, const float *restrict above, const float *restrict row,
                                      const float *restrict below, float *restrict texels)
{
    for (int i = 1; i < side - 1; i++) {
        texels[3 * i] = row[i];
        texels[3 * i + 1] = (row[i + 1] - row[i - 1]) * scale;
        texels[3 * i + 2] = (below[i] - above[i]) * scale;
    }
}

static const float *row_of(const struct height_grid *grid, int j)
{
    return grid->heights + (size_t)vertex_at(grid, j) * (size_t)grid->side;
}

void grid_fill(const struct height_grid *grid, struct surface *surface)
{
    const int side = grid->side, alone = 256; /* vertices a side, at most: faster than threads that wait */
    float scale = (float)(0.5 / surface_spacing(surface));
#pragma omp parallel for if (side > alone)
    for (int j = 0; j < side; j++) {
        const float *above = row_of(grid, j - 1), *row = row_of(grid, j), *below = row_of(grid, j + 1);
        float *texels = surface->texels + (size_t)j * (size_t)side * 3;
        fill_inside(side, scale, above, row, below, texels);
        for (int edge = 0; edge < 2; edge++) {
            int i = edge * (side - 1);
            texels[3 * i] = row[i];
            texels[3 * i + 1] = (row[vertex_at(grid, i + 1)] - row[vertex_at(grid, i - 1)]) * scale;
            texels[3 * i + 2] = (below[i] - above[i]) * scale;
        }
    }
}
