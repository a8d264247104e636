/* The surface of `ocean` at any point: the sum of its cascades, each a bicubic B-spline. Its curvature is continuous,
 * and slopes are its derivatives in closed form; ocean_surface.glsl is the twin on the GPU.
 *
 * A choppy surface's point that rests at x is at X = x + D(x). Its slopes there are the solution p of
 * ∇h = (∂X/∂x)ᵀ p. Where the surface is about to fold over, the determinant in that solution is held at FOLD; `area` is
 * the determinant itself, negative where the surface has folded. */
#include "water/ocean.h"

#include "base/log.h"
#include "base/vector.h"

#include <math.h>
#include <stdlib.h>

#define FOLD 0.1

/* `u`: how far in the cell, 0 to 1. */
static struct ocean_place place_in(int cell, double u)
{
    double v = 1 - u;
    return (struct ocean_place){
        cell,
        {v * v * v / 6, (4 - 3 * u * u * (1 + v)) / 6, (4 - 3 * v * v * (1 + u)) / 6, u * u * u / 6},
        {-v * v / 2, u * (3 * u - 4) / 2, v * (4 - 3 * v) / 2, u * u / 2},
    };
}

static struct ocean_place place_of(double place)
{
    double cell = floor(place);
    return place_in((int)cell, place - cell);
}

/* That of a vertex of a grid with `vertices` along the tile, in a spline with `cells`. */
static struct ocean_place place_of_vertex(int vertex, int vertices, int cells)
{
    int place = vertex * cells, rest = place % vertices;
    return place_in(place / vertices, (double)rest / vertices);
}

bool ocean_surface_prepare(struct ocean_state *state, int vertices, const struct dpl_log *log)
{
    int cascades = state->cascades;
    if (state->columns && state->vertices == vertices && state->column_cascades == cascades &&
        state->column_side == state->side)
        return true;
    ocean_surface_finish(state);
    state->columns = base_allocate(log, (size_t)vertices * (size_t)cascades, sizeof *state->columns, "ocean");
    if (!state->columns)
        return false;
    for (int i = 0; i < vertices * cascades; i++)
        state->columns[i] = place_of_vertex(i / cascades, vertices, ocean_cells(state, i % cascades));
    state->vertices = vertices;
    state->column_cascades = cascades;
    state->column_side = state->side;
    return true;
}

void ocean_surface_finish(struct ocean_state *state)
{
    free(state->columns);
    state->columns = NULL;
}

/* Fields and their derivatives. */
struct sum {
    double value[OCEAN_FIELDS], along_x[OCEAN_FIELDS], along_z[OCEAN_FIELDS];
};

static int field_count(const struct ocean_state *state)
{
    return state->choppiness > 0 ? OCEAN_FIELDS : 1;
}

/* A row of a field's coefficients, two numbers from each other; `row` may lie outside the grid, which repeats. */
static const float *row_of(const struct ocean_state *state, int cascade, int field, int row)
{
    size_t side = (size_t)state->side, part = (size_t)(state->choppiness > 0 ? 4 * cascade + field : cascade);
    return state->grids[(part / 2 * side + (size_t)(row & (state->side - 1))) * side] + part % 2;
}

static void add_field(const struct ocean_state *state, int cascade, int field, const struct ocean_place *x,
                      const struct ocean_place *z, double scale, struct sum *sum)
{
    for (int j = 0; j < 4; j++) {
        const float *row = row_of(state, cascade, field, z->cell + j - 1);
        double value = 0, slope = 0;
        for (int i = 0; i < 4; i++) {
            double coefficient = (double)row[2 * ((x->cell + i - 1) & (state->side - 1))];
            value += x->weights[i] * coefficient;
            slope += x->slopes[i] * coefficient;
        }
        sum->value[field] += z->weights[j] * value;
        sum->along_x[field] += z->weights[j] * slope * scale;
        sum->along_z[field] += z->slopes[j] * value * scale;
    }
}

/* The surface where the point is now. */
struct point {
    double height, slope_x, slope_z, area;
};

static struct point point_from(const struct sum *sum)
{
    double xx = 1 + sum->along_x[1], xz = sum->along_z[1], zx = sum->along_x[2], zz = 1 + sum->along_z[2];
    double area = xx * zz - xz * zx, held = fmax(area, FOLD);
    return (struct point){
        .height = sum->value[0],
        .slope_x = (zz * sum->along_x[0] - zx * sum->along_z[0]) / held,
        .slope_z = (xx * sum->along_z[0] - xz * sum->along_x[0]) / held,
        .area = area,
    };
}

void ocean_surface_sample(const struct ocean_state *state, struct water_points *points)
{
    int fields = field_count(state);
    for (int i = 0; i < points->count; i++) {
        double u = points->x[i] / state->size + 0.5, v = points->z[i] / state->size + 0.5;
        struct sum sum = {0};
        u -= floor(u);
        v -= floor(v);
        for (int cascade = 0; cascade < state->cascades; cascade++) {
            int cells = ocean_cells(state, cascade);
            struct ocean_place x = place_of(u * cells), z = place_of(v * cells);
            for (int field = 0; field < fields; field++)
                add_field(state, cascade, field, &x, &z, cells / state->size, &sum);
        }
        struct point point = point_from(&sum);
        points->height[i] = point.height;
        points->slope_x[i] = point.slope_x;
        points->slope_z[i] = point.slope_z;
        points->shift_x[i] = sum.value[1];
        points->shift_z[i] = sum.value[2];
        points->area[i] = point.area;
    }
}

/* A field along a line of constant z, as spline coefficients along x: entry i is coefficient i - 1. */
struct line {
    double value[OCEAN_SIDE_MAX + 3], along_z[OCEAN_SIDE_MAX + 3];
};

VECTOR_CLONES static void blend_rows(const float *const rows[4], const struct ocean_place *z, int side, double scale,
                                     struct line *line)
{
    const float *restrict r0 = rows[0], *restrict r1 = rows[1], *restrict r2 = rows[2], *restrict r3 = rows[3];
    const double *w = z->weights, *s = z->slopes;
    for (int i = 0; i < side; i++) {
        double c0 = (double)r0[2 * i], c1 = (double)r1[2 * i], c2 = (double)r2[2 * i], c3 = (double)r3[2 * i];
        line->value[i + 1] = w[0] * c0 + w[1] * c1 + w[2] * c2 + w[3] * c3;
        line->along_z[i + 1] = scale * (s[0] * c0 + s[1] * c1 + s[2] * c2 + s[3] * c3);
    }
}

static void make_line(const struct ocean_state *state, int cascade, int field, const struct ocean_place *z,
                      struct line *line)
{
    const float *rows[4];
    int side = state->side;
    for (int j = 0; j < 4; j++)
        rows[j] = row_of(state, cascade, field, z->cell + j - 1);
    blend_rows(rows, z, side, ocean_cells(state, cascade) / state->size, line);
    for (int i = 0; i < 3; i++) { /* the repeated edges */
        int to = i == 0 ? 0 : side + i, from = i == 0 ? side : i;
        line->value[to] = line->value[from];
        line->along_z[to] = line->along_z[from];
    }
}

static void add_line(const struct line *line, const struct ocean_place *x, int side, double scale, int field,
                     struct sum *sum)
{
    const double *value = line->value + (x->cell & (side - 1)), *along_z = line->along_z + (x->cell & (side - 1));
    double slope = 0;
    for (int i = 0; i < 4; i++) {
        sum->value[field] += x->weights[i] * value[i];
        sum->along_z[field] += x->weights[i] * along_z[i];
        slope += x->slopes[i] * value[i];
    }
    sum->along_x[field] += scale * slope;
}

static void evaluate_row(const struct ocean_state *state, struct surface *surface, int row)
{
    struct line lines[OCEAN_CASCADES_MAX][OCEAN_FIELDS];
    int fields = field_count(state), vertices = surface->columns;
    float *texel = surface->texels + (size_t)row * (size_t)vertices * 3;
    float *shift = surface->shifts ? surface->shifts + (size_t)row * (size_t)vertices * 2 : NULL;
    for (int cascade = 0; cascade < state->cascades; cascade++) {
        struct ocean_place z = place_of_vertex(row, vertices, ocean_cells(state, cascade));
        for (int field = 0; field < fields; field++)
            make_line(state, cascade, field, &z, &lines[cascade][field]);
    }
    for (int i = 0; i < vertices; i++) {
        struct sum sum = {0};
        for (int cascade = 0; cascade < state->cascades; cascade++) {
            int cells = ocean_cells(state, cascade);
            const struct ocean_place *x = state->columns + i * state->cascades + cascade;
            for (int field = 0; field < fields; field++)
                add_line(&lines[cascade][field], x, state->side, cells / state->size, field, &sum);
        }
        struct point point = point_from(&sum);
        texel[3 * i] = (float)point.height;
        texel[3 * i + 1] = (float)point.slope_x;
        texel[3 * i + 2] = (float)point.slope_z;
        for (int a = 0; shift && a < 2; a++)
            shift[2 * i + a] = (float)sum.value[1 + a];
    }
}

void ocean_surface_evaluate(const struct ocean_state *state, struct surface *surface)
{
#pragma omp parallel for
    for (int row = 0; row < surface->rows; row++)
        evaluate_row(state, surface, row);
}
