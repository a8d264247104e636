/* The second part of coverage.c: where the cells of the surface have their images on a receiver, and how bright these
 * are. */
#include "light/coverage.h"

#include "base/exponential.h"
#include "base/log.h"
#include "optics/refraction.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define AREA_MIN 1e-5f /* of an image to the area in flat water: below it is a point */
#define CHUNK 64       /* vertices or cells at a time */
#define FARTHEST 64.0f /* sides of the map that an image may lie off */

static bool resize(struct coverage_cells *cells, int columns, int rows, const struct dpl_log *log)
{
    if (cells->moved[0] && cells->columns == columns && cells->rows == rows)
        return true;
    coverage_cells_finish(cells);
    size_t vertices = (size_t)(columns + 1) * (size_t)(rows + 1), padded = (size_t)(columns + 2) * (size_t)(rows + 2);
    cells->columns = columns;
    cells->rows = rows;
    cells->blocks_across = columns / COVERAGE_BLOCK + 1;
    float *numbers = base_allocate(log, vertices * 9, sizeof *numbers, "cells");
    cells->moved[0] = numbers;
    cells->density = base_allocate(log, padded * 2, sizeof *cells->density, "cells");
    cells->blocks =
        base_allocate(log, (size_t)(rows + 1) * (size_t)cells->blocks_across, sizeof *cells->blocks, "cells");
    cells->spread = base_allocate(log, (size_t)rows * 3, sizeof *cells->spread, "cells");
    if (!numbers || !cells->density || !cells->blocks || !cells->spread) {
        coverage_cells_finish(cells);
        return false;
    }
    float **const arrays[] = {cells->moved + 1, cells->exact,     cells->exact + 1, cells->light,
                              cells->light + 1, cells->light + 2, cells->kind,      cells->kind + 1};
    for (size_t k = 0; k < 8; k++)
        *arrays[k] = numbers + (k + 1) * vertices;
    for (size_t i = 0; i < padded * 2; i++)
        cells->density[i] = (coverage_light){0, 0, 0, COVERAGE_DARK};
    return true;
}

void coverage_cells_finish(struct coverage_cells *cells)
{
    free(cells->moved[0]);
    free(cells->density);
    free(cells->blocks);
    free(cells->spread);
    *cells = (struct coverage_cells){0};
}

/* What all vertices share. */
struct placing {
    float receiver;       /* m, its height */
    float direction;      /* 1 for a receiver above the water, -1 for one below */
    float scale;          /* texels a metre */
    float flat_x, flat_z; /* texels: where flat water's light goes */
    float flat_length;    /* m: how long its way is */
    float absorption[3];  /* 1/m */
    float kind[2][3];     /* a place among the kinds: constant, per slope_x, per slope_z */
    float kind_most[2];
};

/* A row of vertices, or a part of one. */
struct vertex_row {
    const float *texels, *u, *v, *q, *weight;
    float *x, *z, *light[3], *kind[2];
};

VECTOR_CLONES static void place_vertices(const struct placing *placing, const struct vertex_row *row, int count)
{
    const float receiver = placing->receiver, scale = placing->scale, direction = placing->direction;
    const float flat_x = placing->flat_x, flat_z = placing->flat_z, flat_length = placing->flat_length;
    const float *restrict texels = row->texels, *restrict u = row->u, *restrict v = row->v, *restrict q = row->q;
    const float *restrict weight = row->weight, most_gain = (float)OPTICS_GAIN_MOST;
    float *restrict x = row->x, *restrict z = row->z;
    for (int i = 0; i < count; i++) {
        float way = direction * vector_positive(direction * (receiver - texels[3 * i])); /* 0: water beyond it */
        x[i] = u[i] * way * scale - flat_x;
        z[i] = v[i] * way * scale - flat_z;
    }
    for (int c = 0; c < 3; c++) {
        const float absorption = placing->absorption[c];
        float *restrict light = row->light[c];
        for (int i = 0; i < count; i++) {
            float way = direction * vector_positive(direction * (receiver - texels[3 * i]));
            float gain = absorption * (flat_length - q[i] * way);
            light[i] = weight[i] * exponential(most_gain - vector_positive(most_gain - gain));
        }
    }
    for (int a = 0; a < 2; a++) {
        const float constant = placing->kind[a][0], per_x = placing->kind[a][1], per_z = placing->kind[a][2];
        const float most = placing->kind_most[a];
        float *restrict kind = row->kind[a];
        for (int i = 0; i < count; i++)
            kind[i] = vector_clamp(constant + per_x * texels[3 * i + 1] + per_z * texels[3 * i + 2], 0, most);
    }
}

static void place_row(struct coverage_cells *cells, const struct coverage_rays *rays, const struct surface *surface,
                      const struct placing *placing, int j)
{
    size_t to = (size_t)j * (size_t)rays->columns, end = to + (size_t)surface->columns;
    size_t from = (size_t)(j % surface->rows) * (size_t)surface->columns;
    struct vertex_row row = {
        .texels = surface->texels + from * 3,
        .u = rays->u + to,
        .v = rays->v + to,
        .q = rays->q + to,
        .weight = rays->weight + to,
        .x = cells->exact[0] + to,
        .z = cells->exact[1] + to,
        .light = {cells->light[0] + to, cells->light[1] + to, cells->light[2] + to},
        .kind = {cells->kind[0] + to, cells->kind[1] + to},
    };
    place_vertices(placing, &row, surface->columns);
    for (size_t i = 0; surface->shifts && i < (size_t)surface->columns; i++) {
        row.x[i] += surface->shifts[(from + i) * 2] * placing->scale;
        row.z[i] += surface->shifts[(from + i) * 2 + 1] * placing->scale;
    }
    float *const arrays[] = {cells->exact[0], cells->exact[1], cells->light[0], cells->light[1],
                             cells->light[2], cells->kind[0],  cells->kind[1]};
    for (int k = 0; surface->periodic && k < 7; k++)
        arrays[k][end] = arrays[k][to];
}

/* Between its vertices an image is curved, and the triangles that stand for it all err to the same side. Moved by the
 * mean of that error, which is 1/24 of the sum of second differences along the mesh's three directions, they err by
 * half as much and to both sides. */
VECTOR_CLONES static void balance_vertices(const float *restrict above, const float *restrict here,
                                           const float *restrict below, int count, float *restrict out)
{
    for (int i = 0; i < count; i++) {
        float around = here[i - 1] + here[i + 1] + above[i] + above[i + 1] + below[i] + below[i - 1];
        out[i] = here[i] - (around - 6.0f * here[i]) * (1.0f / 24.0f);
    }
}

static void balance_row(const struct coverage_cells *cells, int axis, int j)
{
    size_t columns = (size_t)cells->columns + 1;
    const float *exact = cells->exact[axis], *here = exact + (size_t)j * columns;
    float *out = cells->moved[axis] + (size_t)j * columns;
    int rows = cells->rows, last = cells->columns;
    memcpy(out, here, columns * sizeof *out);
    if (!cells->periodic && (j == 0 || j == rows))
        return;
    const float *above = exact + (size_t)((j + rows - 1) % rows) * columns;
    const float *below = exact + (size_t)((j + 1) % rows) * columns;
    if (!cells->periodic && j + 1 == rows)
        below = exact + (size_t)rows * columns;
    balance_vertices(above + 1, here + 1, below + 1, last - 1, out + 1);
    if (!cells->periodic)
        return;
    float around = here[last - 1] + here[1] + above[0] + above[1] + below[0] + below[last - 1];
    out[0] = out[last] = here[0] - (around - 6 * here[0]) / 24;
}

static void bound_row(struct coverage_cells *cells, int side, int j)
{
    const float farthest = FARTHEST * (float)side;
    size_t row = (size_t)j * ((size_t)cells->columns + 1);
    float rest = (float)(cells->origin[1] + j * cells->spacing);
    for (int b = 0; b < cells->blocks_across; b++) {
        struct coverage_block block = {INFINITY, -INFINITY, {INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
        int first = b > 0 ? b * COVERAGE_BLOCK - 1 : 0, last = (b + 1) * COVERAGE_BLOCK;
        last = last < cells->columns ? last : cells->columns;
        for (int i = first; i <= last; i++) {
            float z = rest + vector_clamp(cells->moved[1][row + (size_t)i], -farthest, farthest);
            float rounding = 0.01f + 1e-6f * fabsf(z); /* what is drawn is not rounded */
            block.least_z = z - rounding < block.least_z ? z - rounding : block.least_z;
            block.most_z = z + rounding > block.most_z ? z + rounding : block.most_z;
            for (int a = 0; a < 2; a++) {
                float kind = cells->kind[a][row + (size_t)i];
                block.least_kind[a] = kind < block.least_kind[a] ? kind : block.least_kind[a];
                block.most_kind[a] = kind > block.most_kind[a] ? kind : block.most_kind[a];
            }
        }
        cells->blocks[(size_t)j * (size_t)cells->blocks_across + (size_t)b] = block;
    }
}

/* One of the two triangles of each cell of a stretch: the corner at the right angle, the corner beside it along x, and
 * the one along z, as offsets into the arrays. */
struct corners {
    size_t right, along_x, along_z;
    float spacing;  /* positive for the first triangle, negative for the second, which is the first turned round */
    float farthest; /* texels that an image may lie off; else its size counts as without end */
};

/* What is known of such triangles. */
struct images {
    float area[CHUNK], size[CHUNK]; /* the latter not less than its largest extent */
    float light[3][CHUNK];          /* mean of the vertices' */
    float kind[CHUNK];
};

VECTOR_CLONES static void measure(const struct coverage_cells *cells, const struct corners *corners, int count,
                                  struct images *images)
{
    const size_t right = corners->right, along_x = corners->along_x, along_z = corners->along_z;
    const float *restrict x = cells->moved[0], *restrict z = cells->moved[1], spacing = corners->spacing;
    const float farthest = corners->farthest;
    for (int i = 0; i < count; i++) {
        float ax = spacing + (x[along_x + (size_t)i] - x[right + (size_t)i]);
        float az = z[along_x + (size_t)i] - z[right + (size_t)i];
        float bx = x[along_z + (size_t)i] - x[right + (size_t)i];
        float bz = spacing + (z[along_z + (size_t)i] - z[right + (size_t)i]);
        images->area[i] = 0.5f * (ax * bz - az * bx);
        float off = fabsf(x[right + (size_t)i]) + fabsf(z[right + (size_t)i]);
        images->size[i] = fabsf(ax) + fabsf(bx) + fabsf(az) + fabsf(bz) + 1e6f * vector_positive(off - farthest);
    }
    for (int c = 0; c < 3; c++) {
        const float *restrict light = cells->light[c];
        for (int i = 0; i < count; i++)
            images->light[c][i] =
                (light[right + (size_t)i] + light[along_x + (size_t)i] + light[along_z + (size_t)i]) * (1.0f / 3);
    }
    const float *restrict first = cells->kind[0], *restrict second = cells->kind[1];
    const float steps = COVERAGE_KIND_STEPS / 3;
    for (int i = 0; i < count; i++) {
        float a = first[right + (size_t)i] + first[along_x + (size_t)i] + first[along_z + (size_t)i];
        float b = second[right + (size_t)i] + second[along_x + (size_t)i] + second[along_z + (size_t)i];
        images->kind[i] = rintf(a * steps) + COVERAGE_KIND_ROW * rintf(b * steps);
    }
}

/* Area of the i-th triangle of a choppy surface seen from above; none where the surface overhangs. */
static float choppy_patch(const struct coverage_cells *cells, const struct surface *surface, double scale, int i, int j,
                          int second)
{
    int column[3] = {i + second, i + 1 - second, i + second}, row[3] = {j + second, j + second, j + 1 - second};
    double x[3], z[3];
    for (int k = 0; k < 3; k++) {
        size_t at =
            (size_t)(row[k] % surface->rows) * (size_t)surface->columns + (size_t)(column[k] % surface->columns);
        x[k] = column[k] * cells->spacing + (double)surface->shifts[at * 2] * scale;
        z[k] = row[k] * cells->spacing + (double)surface->shifts[at * 2 + 1] * scale;
    }
    return (float)fmax(((x[1] - x[0]) * (z[2] - z[0]) - (z[1] - z[0]) * (x[2] - x[0])) / 2, 0);
}

static void write_density(const struct images *images, int i, float patch, float widest, double *spread,
                          coverage_light *out)
{
    float area = images->area[i], kind = images->kind[i];
    coverage_light flux = {images->light[0][i] * patch, images->light[1][i] * patch, images->light[2][i] * patch, 0};
    if (!(images->size[i] <= widest)) {
        for (int c = 0; spread && c < 3; c++)
            spread[c] += (double)flux[c];
        kind = COVERAGE_DARK;
        flux = (coverage_light){0};
    } else if (fabsf(area) < AREA_MIN * patch) {
        kind = COVERAGE_POINT - kind;
    } else {
        flux /= area;
    }
    flux[3] = kind;
    *out = flux;
}

static void fill_densities(struct coverage_cells *cells, const struct surface *surface,
                           const struct coverage_receiver *receiver, int j)
{
    size_t columns = (size_t)cells->columns + 1, row = (size_t)j * columns;
    coverage_light *out = cells->density + ((size_t)(j + 1) * (columns + 1) + 1) * 2;
    double *spread = cells->spread + 3 * (size_t)j;
    double scale = receiver->side / receiver->window.side;
    float widest = (float)fmax(receiver->side, 8 * cells->spacing); /* sum of four extents */
    float spacing = (float)cells->spacing, farthest = FARTHEST * (float)receiver->side;
    struct images images;
    spread[0] = spread[1] = spread[2] = 0;
    for (int from = 0; from < cells->columns; from += CHUNK) {
        int count = cells->columns - from < CHUNK ? cells->columns - from : CHUNK;
        size_t at = row + (size_t)from;
        const struct corners corners[2] = {{at, at + 1, at + columns, spacing, farthest},
                                           {at + columns + 1, at + columns, at + 1, -spacing, farthest}};
        for (int second = 0; second < 2; second++) {
            measure(cells, corners + second, count, &images);
            for (int i = 0; i < count; i++) {
                float patch = surface->shifts ? choppy_patch(cells, surface, scale, from + i, j, second)
                                              : 0.5f * spacing * spacing;
                write_density(&images, i, patch, widest, cells->periodic ? spread : NULL,
                              out + 2 * (from + i) + second);
            }
        }
    }
}

static struct placing make_placing(const struct coverage_flat *flat, const double absorption[3],
                                   const struct coverage_receiver *receiver, double scale,
                                   const struct coverage_kinds *kinds)
{
    struct placing placing = {
        .receiver = (float)receiver->height,
        .direction = flat->upwards ? 1.0f : -1.0f,
        .scale = (float)scale,
        .flat_x = (float)(flat->u * receiver->height * scale),
        .flat_z = (float)(flat->v * receiver->height * scale),
        .flat_length = (float)(flat->q * receiver->height),
    };
    for (int c = 0; c < 3; c++)
        placing.absorption[c] = flat->upwards ? 0.0f : (float)absorption[c];
    for (int a = 0; a < 2; a++) {
        placing.kind[a][0] = (float)kinds->offset[a];
        placing.kind[a][1] = (float)kinds->per_slope[a][0];
        placing.kind[a][2] = (float)kinds->per_slope[a][1];
        placing.kind_most[a] = (float)(kinds->count[a] - 1);
    }
    return placing;
}

bool coverage_cells_place(struct coverage_cells *cells, const struct coverage_rays *rays, const struct surface *surface,
                          const struct coverage_flat *flat, const double absorption[3],
                          const struct coverage_receiver *receiver, const struct coverage_kinds *kinds,
                          const struct dpl_log *log)
{
    if (!resize(cells, rays->columns - 1, rays->rows - 1, log))
        return false;
    const struct ray_window *window = &receiver->window;
    double scale = receiver->side / window->side, corner = -surface->size / 2;
    double x = (corner - window->x + flat->u * receiver->height) * scale;
    double z = (corner - window->z + flat->v * receiver->height) * scale;
    const struct placing placing = make_placing(flat, absorption, receiver, scale, kinds);
    cells->periodic = surface->periodic;
    cells->spacing = surface_spacing(surface) * scale;
    const double outside = 1e7; /* texels: whatever lies there is not seen */
    cells->origin[0] = surface->periodic ? fmod(x, receiver->side) : fmin(fmax(x, -outside), outside);
    cells->origin[1] = surface->periodic ? fmod(z, receiver->side) : fmin(fmax(z, -outside), outside);
#pragma omp parallel
    {
#pragma omp for
        for (int j = 0; j < rays->rows; j++)
            place_row(cells, rays, surface, &placing, j);
#pragma omp for
        for (int j = 0; j < rays->rows; j++) {
            balance_row(cells, 0, j);
            balance_row(cells, 1, j);
            bound_row(cells, receiver->side, j);
        }
#pragma omp for
        for (int j = 0; j < cells->rows; j++)
            fill_densities(cells, surface, receiver, j);
    }
    return true;
}
