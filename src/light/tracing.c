#include "light/tracing.h"

#include "base/log.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PARTS 0x1p20     /* of the light of flat water, in the sums */
#define LIGHT_MAX 0x1p20 /* that is added at a time: 2^24 such fill a sum */
#define COPIES_MAX 1024  /* along an axis */

struct tracing_surface tracing_surface_of(const struct surface *surface)
{
    return (struct tracing_surface){surface->texels,
                                    surface->shifts,
                                    surface->columns,
                                    surface->rows,
                                    surface->periodic,
                                    surface->size / 2,
                                    1 / surface_spacing(surface)};
}

/* floor() without a call. */
static inline double whole_of(double x)
{
    double whole = (double)(int64_t)x;
    return whole > x ? whole - 1 : whole;
}

/* The cell along one axis and the place in it, 0 to 1; false beyond a bounded surface. */
static inline bool find_cell(const struct tracing_surface *surface, int vertices, double position, int cell[2],
                             double *inside)
{
    double place = (position + surface->half) * surface->per_spacing;
    int last = surface->periodic ? vertices - 1 : vertices - 2;
    if (surface->periodic)
        place -= place >= 0 && place < vertices ? 0 : vertices * whole_of(place / vertices);
    else if (!(place >= 0 && place <= vertices - 1))
        return false;
    cell[0] = (int)place < last ? (int)place : last;
    cell[1] = cell[0] + 1 < vertices ? cell[0] + 1 : 0;
    *inside = place - cell[0];
    return true;
}

/* Moves the point by the vertices' shifts, and measures how these stretch the cell. */
static void shift_point(const struct tracing_surface *surface, const size_t corners[4], const double inside[2],
                        struct ray_point *point)
{
    double along_x[2], along_z[2], shift[2];
    for (size_t k = 0; k < 2; k++) {
        double at[4];
        for (int i = 0; i < 4; i++)
            at[i] = (double)surface->shifts[corners[i] * 2 + k];
        double upper = at[0] + (at[1] - at[0]) * inside[0], lower = at[2] + (at[3] - at[2]) * inside[0];
        shift[k] = upper + (lower - upper) * inside[1];
        along_x[k] = ((at[1] - at[0]) * (1 - inside[1]) + (at[3] - at[2]) * inside[1]) * surface->per_spacing;
        along_z[k] = (lower - upper) * surface->per_spacing;
    }
    point->x += shift[0];
    point->z += shift[1];
    point->area = (1 + along_x[0]) * (1 + along_z[1]) - along_x[1] * along_z[0];
}

bool tracing_surface_at(const struct tracing_surface *surface, double x, double z, struct ray_point *point)
{
    int columns[2], rows[2];
    double inside[2];
    if (!find_cell(surface, surface->columns, x, columns, inside) ||
        !find_cell(surface, surface->rows, z, rows, inside + 1))
        return false;
    size_t upper = (size_t)rows[0] * (size_t)surface->columns, lower = (size_t)rows[1] * (size_t)surface->columns;
    size_t left = (size_t)columns[0], right = (size_t)columns[1];
    const size_t corners[4] = {upper + left, upper + right, lower + left, lower + right};
    double last = inside[0] * inside[1];
    const double weights[4] = {1 - inside[0] - inside[1] + last, inside[0] - last, inside[1] - last, last};
    double values[3] = {0};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            values[k] += weights[i] * (double)surface->texels[corners[i] * 3 + (size_t)k];
    point->x = x;
    point->z = z;
    point->height = values[0];
    point->slope_x = values[1];
    point->slope_z = values[2];
    point->area = 1;
    if (surface->shifts)
        shift_point(surface, corners, inside, point);
    return true;
}

struct tracing_view tracing_view_of(const struct light_input *input, bool periodic, int side, int slice)
{
    const struct ray_window *window = input->windows + slice;
    return (struct tracing_view){
        .side = side,
        .corner = {window->x, window->z},
        .texels_a_meter = side / window->side,
        .period = periodic ? input->setup->size / window->side * side : 0,
    };
}

int tracing_copies(const struct tracing_view *view, double least, double most, double *first)
{
    *first = 0;
    if (view->period == 0)
        return least < view->side && most > 0;
    double before = floor(-most / view->period) + 1, after = ceil((view->side - least) / view->period);
    *first = before * view->period;
    return (int)fmin(fmax(after - before, 0), COPIES_MAX);
}

bool tracing_sums_start(struct tracing_sums *sums, int side, const struct dpl_log *log)
{
    size_t count = (size_t)side * (size_t)side * 3;
    if (sums->texels && sums->side == side) {
        memset(sums->texels, 0, count * sizeof *sums->texels);
        return true;
    }
    tracing_sums_finish(sums);
    sums->texels = base_allocate(log, count, sizeof *sums->texels, "light");
    sums->side = sums->texels ? side : 0;
    return sums->texels != NULL;
}

void tracing_sums_finish(struct tracing_sums *sums)
{
    free(sums->texels);
    *sums = (struct tracing_sums){0};
}

void tracing_sums_add(struct tracing_sums *sums, int x, int z, const double light[3])
{
    if (x < 0 || z < 0 || x >= sums->side || z >= sums->side)
        return;
    uint64_t *texel = sums->texels + ((size_t)z * (size_t)sums->side + (size_t)x) * 3;
    for (int c = 0; c < 3; c++) {
        if (!(light[c] > 0)) /* or no number */
            continue;
        uint64_t parts = (uint64_t)(fmin(light[c], LIGHT_MAX) * PARTS + 0.5);
#pragma omp atomic
        texel[c] += parts;
    }
}

void tracing_sums_read(const struct tracing_sums *sums, const double scale[3], float *texels)
{
    size_t count = (size_t)sums->side * (size_t)sums->side * 3;
    for (size_t i = 0; i < count; i++)
        texels[i] = (float)((double)sums->texels[i] * (scale[i % 3] / PARTS));
}

void tracing_random(const uint32_t counters[4], double numbers[4])
{
    uint32_t v[4];
    for (int i = 0; i < 4; i++)
        v[i] = counters[i] * 1664525u + 1013904223u;
    for (int round = 0; round < 2; round++) {
        for (int i = 0; round == 1 && i < 4; i++)
            v[i] ^= v[i] >> 16;
        v[0] += v[1] * v[3];
        v[1] += v[2] * v[0];
        v[2] += v[0] * v[1];
        v[3] += v[1] * v[2];
    }
    for (int i = 0; i < 4; i++)
        numbers[i] = (v[i] >> 8) * 0x1p-24; /* as many bits as a float holds: the GPU's are the same */
}

int tracing_colors_together(const struct ray_medium *rays)
{
    return rays->ior[0] == rays->ior[2] ? 3 : 1;
}
