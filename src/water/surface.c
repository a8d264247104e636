#include "water/surface.h"

#include "base/log.h"

#include <math.h>
#include <stdlib.h>

bool surface_resize(struct surface *surface, int columns, int rows, bool periodic, bool choppy, double size,
                    const struct dpl_log *log)
{
    surface->size = size;
    surface->periodic = periodic;
    if (surface->texels && surface->columns == columns && surface->rows == rows && choppy == (surface->shifts != NULL))
        return true;
    surface_finish(surface);
    size_t count = (size_t)columns * (size_t)rows;
    float *texels = base_allocate(log, count * 3, sizeof *texels, "water surface");
    float *shifts = choppy ? base_allocate(log, count * 2, sizeof *shifts, "water surface") : NULL;
    *surface = (struct surface){columns, rows, periodic, size, texels, shifts};
    if (texels && (shifts || !choppy))
        return true;
    surface_finish(surface);
    return false;
}

void surface_finish(struct surface *surface)
{
    free(surface->texels);
    free(surface->shifts);
    *surface = (struct surface){0};
}

double surface_spacing(const struct surface *surface)
{
    return surface->size / (surface->periodic ? surface->columns : surface->columns - 1);
}

static float *texel(const struct surface *surface, int i, int j)
{
    return surface->texels + ((size_t)j * (size_t)surface->columns + (size_t)i) * 3;
}

/* Adds the unit normal of one of the two triangles of cell (i, j); outside the grid there is none. */
static void add_face(const struct surface *surface, int i, int j, bool second, float per_spacing, float sum[3])
{
    if (i < 0 || j < 0 || i + 1 >= surface->columns || j + 1 >= surface->rows)
        return;
    float right = texel(surface, i + 1, j)[0], below = texel(surface, i, j + 1)[0];
    float corner = second ? texel(surface, i + 1, j + 1)[0] : texel(surface, i, j)[0];
    float slope_x = (second ? corner - below : right - corner) * per_spacing;
    float slope_z = (second ? corner - right : below - corner) * per_spacing;
    float scale = 1.0f / sqrtf(slope_x * slope_x + slope_z * slope_z + 1.0f);
    sum[0] -= slope_x * scale;
    sum[1] += scale;
    sum[2] -= slope_z * scale;
}

void surface_slopes_from_faces(struct surface *surface)
{
    float per_spacing = (float)(1.0 / surface_spacing(surface));
#pragma omp parallel for
    for (int j = 0; j < surface->rows; j++) {
        for (int i = 0; i < surface->columns; i++) {
            float sum[3] = {0, 0, 0};
            add_face(surface, i, j, false, per_spacing, sum);
            add_face(surface, i - 1, j, false, per_spacing, sum);
            add_face(surface, i - 1, j, true, per_spacing, sum);
            add_face(surface, i, j - 1, false, per_spacing, sum);
            add_face(surface, i, j - 1, true, per_spacing, sum);
            add_face(surface, i - 1, j - 1, true, per_spacing, sum);
            texel(surface, i, j)[1] = -sum[0] / sum[1];
            texel(surface, i, j)[2] = -sum[2] / sum[1];
        }
    }
}

/* Numbers between the vertices around a place in cells, by straight lines. */
static void blend(const struct surface *surface, const float *numbers, size_t count, double x, double z, double *out)
{
    int columns = surface->columns, rows = surface->rows, repeated = surface->periodic ? 0 : 1;
    x = surface->periodic ? x - floor(x / columns) * columns : fmin(fmax(x, 0), columns - 1);
    z = surface->periodic ? z - floor(z / rows) * rows : fmin(fmax(z, 0), rows - 1);
    int i = (int)fmin(x, columns - 1 - repeated), j = (int)fmin(z, rows - 1 - repeated);
    double u = x - i, v = z - j, weights[4] = {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v};
    for (size_t c = 0; c < count; c++)
        out[c] = 0;
    for (int k = 0; k < 4; k++) {
        size_t at = (size_t)((j + k / 2) % rows) * (size_t)columns + (size_t)((i + k % 2) % columns);
        for (size_t c = 0; c < count; c++)
            out[c] += weights[k] * (double)numbers[at * count + c];
    }
}

void surface_blend(const struct surface *surface, double column, double row, double texel[3])
{
    blend(surface, surface->texels, 3, column, row, texel);
}

bool surface_flatten(const struct surface *from, struct surface *to, const struct dpl_log *log)
{
    const int iterations = 8;
    double per_meter = 1 / surface_spacing(from);
    if (!surface_resize(to, from->columns, from->rows, from->periodic, false, from->size, log))
        return false;
#pragma omp parallel for
    for (int j = 0; j < from->rows; j++) {
        for (int i = 0; i < from->columns; i++) {
            double shift[2] = {0, 0}, texels[3];
            for (int k = 0; k < iterations; k++)
                blend(from, from->shifts, 2, i - shift[0] * per_meter, j - shift[1] * per_meter, shift);
            blend(from, from->texels, 3, i - shift[0] * per_meter, j - shift[1] * per_meter, texels);
            for (int c = 0; c < 3; c++)
                texel(to, i, j)[c] = (float)texels[c];
        }
    }
    return true;
}
