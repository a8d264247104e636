/* The third part of coverage.c: the exact area of a texel that an image covers.
 *
 * The share of a texel that a polygon covers is a sum over its edges: each covers all that lies to its right, with a
 * sign by its direction (Green's theorem). An edge between two triangles therefore counts by the difference of their
 * densities, and where these are equal not at all. A row holds the changes of the light from texel to texel; their
 * running sum is the light. Images that are turned over have a negative area and a negative density, so that folds add
 * up without being looked for. */
#include "light/coverage.h"

#include "base/vector.h"

#include <math.h>
#include <string.h>

typedef double vector4 __attribute__((vector_size(32)));

/* The part of the fine map that is being filled. */
struct band {
    const struct coverage_cells *cells;
    int side;                          /* of the fine map */
    int first, count;                  /* rows; they may lie beyond the map */
    int first_column, columns, stride; /* likewise; the stride is of `sums` */
    bool all;                          /* there is only one kind */
    float kind[2];
    vector4 *sums; /* changes of the light from column to column; behind the last what is added to the whole row */
};

/* Changes the light of a row by share × change from `column` on, after the part `inside` of that column. What falls
 * behind the last column changes nothing that is seen. */
VECTOR_PART void put(const struct band *band, vector4 *row, int column, const vector4 *change, double share,
                     double inside)
{
    vector4 whole = *change * share, second = whole * inside, first = whole - second;
    column -= band->first_column;
    if ((unsigned)column >= (unsigned)band->columns) {
        int turns = column / band->columns - (column % band->columns < 0);
        if (!band->cells->periodic) {
            if (turns < 0)
                row[0] += whole;
            return;
        }
        column -= turns * band->columns;
        row[band->columns + 1] -= whole * (double)turns;
    }
    row[column] += first;
    row[column + 1] += second;
}

/* The part of an edge that lies in one row, from x = a to x = b, and is that high. */
VECTOR_PART void fill_piece(const struct band *band, vector4 *row, double a, double b, const vector4 *change,
                            double height)
{
    double left = a < b ? a : b, right = a < b ? b : a;
    int column = (int)floor(left), last = (int)floor(right);
    if (column == last) {
        put(band, row, column, change, height, (left + right) / 2 - column);
        return;
    }
    double per_length = height / (right - left);
    put(band, row, column, change, (column + 1 - left) * per_length, (left - column + 1) / 2);
    for (column++; column < last; column++)
        put(band, row, column, change, per_length, 0.5);
    put(band, row, last, change, (right - last) * per_length, (right - last) / 2);
}

/* An edge from (ax, az) to (bx, bz). `change` is the density on its right less that on its left, seen with x to the
 * right, z downwards and az < bz. The band is rows low … low + count - 1. */
VECTOR_PART void fill_edge(const struct band *band, int low, double ax, double az, double bx, double bz,
                           const vector4 *change)
{
    bool down = az < bz;
    double top_x = down ? ax : bx, top = down ? az : bz, bottom_x = down ? bx : ax, bottom = down ? bz : az;
    vector4 signed_change = down ? *change : -*change;
    int row = (int)floor(top), end = (int)ceil(bottom), high = low + band->count;
    row = row > low ? row : low;
    end = end < high ? end : high;
    if (row >= end)
        return;
    double slope = (bottom_x - top_x) / (bottom - top);
    double from = row > top ? top_x + (row - top) * slope : top_x, from_z = row > top ? row : top;
    for (; row < end; row++) {
        bool ends = row + 1 >= bottom;
        double to = ends ? bottom_x : top_x + (row + 1 - top) * slope, to_z = ends ? bottom : row + 1;
        fill_piece(band, band->sums + (size_t)(row - low) * (size_t)band->stride, from, to, &signed_change,
                   to_z - from_z);
        from = to;
        from_z = to_z;
    }
}

/* Flux without an area, into the texel that it lies in. */
VECTOR_PART void fill_point(const struct band *band, int low, double x, double z, coverage_light flux)
{
    int row = (int)floor(z), column = (int)floor(x);
    if (row < low || row >= low + band->count)
        return;
    vector4 *sums = band->sums + (size_t)(row - low) * (size_t)band->stride;
    const vector4 light = {(double)flux[0], (double)flux[1], (double)flux[2], 0};
    put(band, sums, column, &light, 1, 0);
    put(band, sums, column + 1, &light, -1, 0);
}

/* The share of a triangle's light that is of the kind being filled. */
VECTOR_PART float share_of(const struct band *band, float kind)
{
    if (kind < 0)
        return 0;
    if (band->all)
        return 1;
    float row = floorf(kind * (1 / COVERAGE_KIND_ROW));
    float first = 1 - fabsf((kind - row * COVERAGE_KIND_ROW) * (1 / COVERAGE_KIND_STEPS) - band->kind[0]);
    float second = 1 - fabsf(row * (1 / COVERAGE_KIND_STEPS) - band->kind[1]);
    return vector_positive(first) * vector_positive(second);
}

/* In double precision, so that what one edge of a triangle adds the others take away, however bright it is. */
VECTOR_PART void density_of(const struct band *band, coverage_light light, vector4 *out)
{
    coverage_light part = light * share_of(band, light[3]);
    *out = (vector4){(double)part[0], (double)part[1], (double)part[2], 0};
}

VECTOR_PART bool differs(const vector4 *change)
{
    return (*change)[0] != 0 || (*change)[1] != 0 || (*change)[2] != 0;
}

/* The edges of cell (i, j) that it does not share with the cells after it; those beyond the last have some of them. */
VECTOR_PART void fill_cell(const struct band *band, int low, int i, int j)
{
    const struct coverage_cells *cells = band->cells;
    size_t columns = (size_t)cells->columns + 1, at = (size_t)j * columns + (size_t)i;
    const coverage_light *here = cells->density + ((size_t)(j + 1) * (columns + 1) + (size_t)i + 1) * 2;
    const float *moved_x = cells->moved[0] + at, *moved_z = cells->moved[1] + at;
    vector4 first, second, above, before;
    density_of(band, here[0], &first);
    density_of(band, here[1], &second);
    density_of(band, here[1 - 2 * (ptrdiff_t)(columns + 1)], &above);
    density_of(band, here[-1], &before);
    vector4 top = above - first, left = first - before, diagonal = second - first;
    double x = cells->origin[0] + i * cells->spacing, z = cells->origin[1] + j * cells->spacing, s = cells->spacing;
    double corner_x = x + (double)moved_x[0], corner_z = z + (double)moved_z[0];
    double right_x = x + s + (double)moved_x[1], right_z = z + (double)moved_z[1];
    if (i < cells->columns && differs(&top))
        fill_edge(band, low, corner_x, corner_z, right_x, right_z, &top);
    if (j == cells->rows)
        return;
    double below_x = x + (double)moved_x[columns], below_z = z + s + (double)moved_z[columns];
    if (differs(&left))
        fill_edge(band, low, corner_x, corner_z, below_x, below_z, &left);
    if (i < cells->columns && differs(&diagonal))
        fill_edge(band, low, right_x, right_z, below_x, below_z, &diagonal);
    for (int k = 0; k < 2; k++)
        if (here[k][3] <= COVERAGE_POINT)
            fill_point(band, low, right_x, right_z, here[k] * share_of(band, COVERAGE_POINT - here[k][3]));
}

static float lesser(float a, float b)
{
    return a < b ? a : b;
}

static float greater(float a, float b)
{
    return a > b ? a : b;
}

/* Whether a stretch of the row's cells may hold light of the band's kind; if so, the heights that it reaches over. */
static bool block_of(const struct band *band, int j, int b, float *least, float *most)
{
    const struct coverage_cells *cells = band->cells;
    float kinds[2][2] = {{INFINITY, -INFINITY}, {INFINITY, -INFINITY}};
    *least = INFINITY;
    *most = -INFINITY;
    for (int k = j > 0 ? j - 1 : 0; k <= j + 1 && k <= cells->rows; k++) {
        const struct coverage_block *block = cells->blocks + (size_t)k * (size_t)cells->blocks_across + (size_t)b;
        for (int a = 0; a < 2; a++) {
            kinds[a][0] = lesser(kinds[a][0], block->least_kind[a]);
            kinds[a][1] = greater(kinds[a][1], block->most_kind[a]);
        }
        *least = k < j ? *least : lesser(*least, block->least_z);
        *most = k < j ? *most : greater(*most, block->most_z);
    }
    const float rounding = 1 / COVERAGE_KIND_STEPS;
    for (int a = 0; a < 2; a++)
        if (kinds[a][0] - rounding >= band->kind[a] + 1 || kinds[a][1] + rounding <= band->kind[a] - 1)
            return false;
    return true;
}

VECTOR_CLONES static void fill_block(const struct band *band, int low, int j, int b)
{
    int end = (b + 1) * COVERAGE_BLOCK, last = band->cells->columns + 1;
    for (int i = b * COVERAGE_BLOCK; i < end && i < last; i++)
        fill_cell(band, low, i, j);
}

/* The blocks that reach into the band, as often as they do. */
static void fill_blocks(const struct band *band)
{
    const struct coverage_cells *cells = band->cells;
    for (int j = 0; j <= cells->rows; j++) {
        for (int b = 0; b < cells->blocks_across; b++) {
            float least, most;
            if (!block_of(band, j, b, &least, &most))
                continue;
            int low = band->first;
            if (cells->periodic)
                low += band->side * (int)ceil(((double)least - band->first - band->count) / band->side);
            for (; (float)low <= most; low += band->side) {
                if ((float)(low + band->count) >= least)
                    fill_block(band, low, j, b);
                if (!cells->periodic)
                    break;
            }
        }
    }
}

/* From changes to light: red, green and blue each in a line of `width`. */
VECTOR_CLONES static void sum_row(const struct band *band, const vector4 *sums, const vector4 *spread, int margin,
                                  float *restrict out)
{
    size_t width = (size_t)(band->side + 2 * margin);
    float *line = out + band->first_column + margin;
    vector4 light = *spread + sums[band->columns + 1];
    for (int i = 0; i < band->columns; i++) {
        light += sums[i];
        line[i] = (float)light[0];
        line[(size_t)i + width] = (float)light[1];
        line[(size_t)i + 2 * width] = (float)light[2];
    }
    for (int i = 0; band->cells->periodic && i < margin; i++) {
        for (size_t c = 0; c < 3; c++) {
            float *inner = out + c * width + margin;
            inner[-1 - i] = inner[band->side - 1 - i % band->side];
            inner[band->side + i] = inner[i % band->side];
        }
    }
}

size_t coverage_fill_room(int side, int margin, int count)
{
    return (size_t)(side + 2 * margin + 2) * (size_t)count * sizeof(vector4);
}

void coverage_fill(const struct coverage_cells *cells, int side, int margin, const int kind[2], int first, int count,
                   void *room, float *out)
{
    int outside = cells->periodic ? 0 : margin;
    struct band band = {
        .cells = cells,
        .side = side,
        .first = first,
        .count = count,
        .first_column = -outside,
        .columns = side + 2 * outside,
        .stride = side + 2 * outside + 2,
        .all = kind == NULL,
        .kind = {kind ? (float)kind[0] : 0, kind ? (float)kind[1] : 0},
        .sums = room,
    };
    memset(room, 0, (size_t)band.stride * (size_t)count * sizeof(vector4));
    fill_blocks(&band);
    vector4 spread = {0};
    for (int j = 0; band.kind[0] == 0 && band.kind[1] == 0 && j < cells->rows; j++)
        for (int c = 0; c < 3; c++)
            spread[c] += cells->spread[3 * j + c] / side / side;
    for (int j = 0; j < count; j++)
        sum_row(&band, band.sums + (size_t)j * (size_t)band.stride, &spread, margin,
                out + (size_t)j * 3 * (size_t)(side + 2 * margin));
}
