#include "water/normal_map.h"

#include "base/log.h"
#include "base/vector.h"

#include <math.h>
#include <stdlib.h>

static bool resize(struct normal_map *map, int columns, int rows, int side, const struct dpl_log *log)
{
    if (map->columns == columns && map->rows == rows && map->side == side)
        return true;
    normal_map_finish(map);
    bool ok = true;
    for (int c = 0; c < 3; c++) {
        map->vertices[c] = base_allocate(log, (size_t)columns * (size_t)rows, sizeof(float), "normals");
        ok = ok && map->vertices[c];
    }
    map->cells = base_allocate(log, (size_t)side, sizeof(int), "normals");
    map->inside = base_allocate(log, (size_t)side, sizeof(float), "normals");
    if (!ok || !map->cells || !map->inside) {
        normal_map_finish(map);
        return false;
    }
    map->columns = columns;
    map->rows = rows;
    map->side = side;
    return true;
}

/* The cell of a texel's middle along one axis of `cells` cells, and how far in. */
static int locate(int texel, int side, int cells, float *inside)
{
    double place = (texel + 0.5) / side * cells;
    int cell = (int)place;
    *inside = (float)(place - cell);
    return cell;
}

VECTOR_CLONES static void normalise_row(const float *restrict texels, int count, float *restrict x, float *restrict y,
                                        float *restrict z)
{
    for (int i = 0; i < count; i++) {
        float slope_x = texels[3 * i + 1], slope_z = texels[3 * i + 2];
        float scale = 1.0f / sqrtf(1.0f + slope_x * slope_x + slope_z * slope_z);
        x[i] = -slope_x * scale;
        y[i] = scale;
        z[i] = -slope_z * scale;
    }
}

bool normal_map_begin(struct normal_map *map, const struct surface *surface, int side, const struct dpl_log *log)
{
    int repeated = surface->periodic ? 1 : 0;
    if (!resize(map, surface->columns + repeated, surface->rows + repeated, side, log))
        return false;
#pragma omp parallel for
    for (int j = 0; j < map->rows; j++) {
        size_t from = (size_t)(j % surface->rows) * (size_t)surface->columns, to = (size_t)j * (size_t)map->columns;
        float *row[3] = {map->vertices[0] + to, map->vertices[1] + to, map->vertices[2] + to};
        normalise_row(surface->texels + from * 3, surface->columns, row[0], row[1], row[2]);
        for (int c = 0; repeated && c < 3; c++)
            row[c][surface->columns] = row[c][0];
    }
    for (int i = 0; i < side; i++)
        map->cells[i] = locate(i, side, map->columns - 1, map->inside + i);
    return true;
}

/* The texels of one row in turn; `first` is the corner of the row of cells, `v` how far in it the row lies. */
VECTOR_CLONES static void interpolate(const struct normal_map *map, size_t first, float v, float *restrict out_x,
                                      float *restrict out_y, float *restrict out_z)
{
    const float *restrict x = map->vertices[0] + first, *restrict y = map->vertices[1] + first;
    const float *restrict z = map->vertices[2] + first, *restrict inside = map->inside;
    const int *restrict cells = map->cells;
    const int columns = map->columns, side = map->side;
    for (int i = 0; i < side; i++) {
        float u = inside[i];
        int right = cells[i] + 1, below = cells[i] + columns;
        int second = u + v > 1.0f;
        int corner = second ? below + 1 : cells[i];
        float at_right = second ? 1.0f - v : u, at_below = second ? 1.0f - u : v;
        float at_corner = 1.0f - at_right - at_below;
        float nx = at_corner * x[corner] + at_right * x[right] + at_below * x[below];
        float ny = at_corner * y[corner] + at_right * y[right] + at_below * y[below];
        float nz = at_corner * z[corner] + at_right * z[right] + at_below * z[below];
        float scale = 1.0f / sqrtf(nx * nx + ny * ny + nz * nz);
        out_x[i] = nx * scale;
        out_y[i] = ny * scale;
        out_z[i] = nz * scale;
    }
}

void normal_map_row(const struct normal_map *map, int row, float *x, float *y, float *z)
{
    float v;
    int cell = locate(row, map->side, map->rows - 1, &v);
    interpolate(map, (size_t)cell * (size_t)map->columns, v, x, y, z);
}

void normal_map_finish(struct normal_map *map)
{
    for (int c = 0; c < 3; c++)
        free(map->vertices[c]);
    free(map->cells);
    free(map->inside);
    *map = (struct normal_map){0};
}
