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

/* Height and slopes, from the vertices around a point. */
static void blend(const struct height_grid *grid, const struct stencil *x, const struct stencil *z, double out[3])
{
    double per_spacing = (grid->periodic ? grid->side : grid->side - 1) / grid->size;
    double height = 0, slope_x = 0, slope_z = 0;
    for (int j = 0; j < 4; j++) {
        const float *row = grid->heights + (size_t)z->vertices[j] * (size_t)grid->side;
        double value = 0, slope = 0;
        for (int k = 0; k < 4; k++) {
            value += x->value[k] * (double)row[x->vertices[k]];
            slope += x->slope[k] * (double)row[x->vertices[k]];
        }
        height += z->value[j] * value;
        slope_x += z->value[j] * slope;
        slope_z += z->slope[j] * value;
    }
    out[0] = height;
    out[1] = slope_x * per_spacing;
    out[2] = slope_z * per_spacing;
}

void grid_sample(const struct height_grid *grid, struct water_points *points)
{
    for (int i = 0; i < points->count; i++) {
        struct stencil x = stencil_at(grid, place_of(grid, points->x[i]));
        struct stencil z = stencil_at(grid, place_of(grid, points->z[i]));
        double out[3];
        blend(grid, &x, &z, out);
        points->height[i] = out[0];
        points->slope_x[i] = out[1];
        points->slope_z[i] = out[2];
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

static void fill_same(const struct height_grid *grid, struct surface *surface)
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

/* A thread takes a strip of columns, whose stencils serve all of their rows. */
static void fill_other(const struct height_grid *grid, struct surface *surface)
{
    enum { STRIP = 32 };
    double spacing = surface_spacing(surface), half = surface->size / 2;
#pragma omp parallel for
    for (int from = 0; from < surface->columns; from += STRIP) {
        int count = surface->columns - from < STRIP ? surface->columns - from : STRIP;
        struct stencil x[STRIP];
        for (int i = 0; i < count; i++)
            x[i] = stencil_at(grid, place_of(grid, (from + i) * spacing - half));
        for (int j = 0; j < surface->rows; j++) {
            struct stencil z = stencil_at(grid, place_of(grid, j * spacing - half));
            float *texel = surface->texels + ((size_t)j * (size_t)surface->columns + (size_t)from) * 3;
            for (int i = 0; i < count; i++, texel += 3) {
                double out[3];
                blend(grid, x + i, &z, out);
                for (int c = 0; c < 3; c++)
                    texel[c] = (float)out[c];
            }
        }
    }
}

void grid_fill(const struct height_grid *grid, struct surface *surface)
{
    if (surface->columns == grid->side && surface->periodic == grid->periodic)
        fill_same(grid, surface);
    else
        fill_other(grid, surface);
}
