/* The CPU's half of multi_sample.c.
 *
 * The samples of neighbouring texels are neighbours too, so nothing is gathered: a row of normals is blended once for
 * each line of samples, and each sample of a whole row of texels reads a run of it. Rows carry their mirror image on
 * both sides, so that a run never leaves its row. Threads share rows; the result does not depend on their number. */
#include "light/multi_sample.h"

#include "base/log.h"
#include "base/threads.h"
#include "base/vector.h"

#include <math.h>
#include <stdlib.h>

/* Texels of a row with its margins: half a width on either side, and one more for the last blend. */
static size_t stride_of(int side)
{
    return (size_t)(2 * side + 2);
}

/* Index of a texel of the mirrored, endlessly repeated row. */
static int mirrored(int i, int side)
{
    int place = i % (2 * side);
    if (place < 0)
        place += 2 * side;
    return place < side ? place : 2 * side - 1 - place;
}

static bool resize_buffers(struct multi_sample_state *state, int side, const struct dpl_log *log)
{
    if (state->rows && state->blended && state->side == side && state->threads == threads_most())
        return true;
    multi_sample_free_buffers(state);
    size_t stride = stride_of(side);
    state->rows = base_allocate(log, stride * 3 * (size_t)side, sizeof(float), "normals");
    state->blended = base_allocate(log, stride * 3 * (size_t)threads_most(), sizeof(float), "normals");
    state->side = side;
    state->threads = threads_most();
    return state->rows && state->blended;
}

void multi_sample_free_buffers(struct multi_sample_state *state)
{
    free(state->rows);
    free(state->blended);
    normal_map_finish(&state->normal_map);
    state->rows = state->blended = NULL;
}

static void fill_normals(struct multi_sample_state *state)
{
    int side = state->side, margin = side / 2 + 1;
    size_t stride = stride_of(side);
#pragma omp parallel for
    for (int j = 0; j < side; j++) {
        float *x = state->rows + (size_t)j * 3 * stride, *y = x + stride, *z = y + stride;
        normal_map_row(&state->normal_map, j, x + margin, y + margin, z + margin);
        for (int i = 0; i < (int)stride; i++) {
            int from = margin + mirrored(i - margin, side);
            x[i] = x[from];
            y[i] = y[from];
            z[i] = z[from];
        }
    }
}

/* Blends two rows. */
VECTOR_CLONES static void blend_rows(const float *restrict first, const float *restrict second, float part, int count,
                                     float *restrict out)
{
    for (int i = 0; i < count; i++)
        out[i] = first[i] + part * (second[i] - first[i]);
}

/* Adds one sample, steps 2 to 5, to a row of texels. `x` starts a run of the blended row, y and z follow a stride on.
 * What is blended of unit vectors is shorter than one: only its direction counts. */
VECTOR_CLONES static void add_sample(const float *restrict x, size_t stride, float part, int count,
                                     const struct multi_sample_plan *restrict plan,
                                     const struct multi_sample_ray *restrict ray, float *restrict sum)
{
    const float *direction = ray->direction, keep = plan->normal_keep, start = plan->table_start;
    const float scale = (float)(MULTI_SAMPLE_TABLE - 1) / (1.0f - start), weight = ray->weight;
    const float dx = direction[0], dy = direction[1], dz = direction[2];
    const float still = 1e-30f; /* flat water seen from straight below: 0 / 0 is to be 1 */
    const float *restrict y = x + stride, *restrict z = y + stride, *restrict table = plan->table;
    for (int i = 0; i < count; i++) {
        float nx = x[i] + part * (x[i + 1] - x[i]), ny = y[i] + part * (y[i + 1] - y[i]);
        float nz = z[i] + part * (z[i + 1] - z[i]);
        float across = nx * nx + nz * nz;
        float along = dx * nx + dy * ny + dz * nz;
        float square = along * along / (across + ny * ny);
        square *= square;
        square *= square;
        square *= square; /* τ¹⁶ */
        float height = (1.0f - keep * square * square) * ny;
        float total = height * height + across;
        float cosine = (height * height + still) / (total + still);
        int entry = (int)((cosine - start) * scale + 0.5f);
        entry &= ~(entry >> 31); /* below the table: its first entry; a condition here would not become vectors */
        sum[i] += weight * table[entry];
    }
}

/* Splits an offset in texels into whole texels and a part. */
static int whole_texels(double texels, float *part)
{
    double whole = floor(texels + 1e-6);
    *part = (float)fmax(texels - whole, 0);
    return (int)whole;
}

/* One row of texels. */
static void trace_row(const struct multi_sample_state *state, int j, float *restrict out)
{
    const struct multi_sample_plan *plan = &state->plan;
    int side = state->side;
    size_t stride = stride_of(side);
    float *blended = state->blended + (size_t)threads_index() * 3 * stride;
    for (int i = 0; i < side; i++)
        out[i] = 0.0f;
    for (int l = 0; l < plan->lines; l++) {
        float part;
        int row = j + whole_texels((double)plan->offsets[l] * side, &part);
        const float *first = state->rows + (size_t)mirrored(row, side) * 3 * stride;
        const float *second = state->rows + (size_t)mirrored(row + 1, side) * 3 * stride;
        blend_rows(first, second, part, (int)stride * 3, blended);
        for (int k = 0; k < plan->lines; k++) {
            int run = side / 2 + 1 + whole_texels((double)plan->offsets[k] * side, &part);
            add_sample(blended + run, stride, part, side, plan, plan->rays + l * plan->lines + k, out);
        }
    }
}

/* Step 6. */
VECTOR_CLONES static void finish_row(const struct multi_sample_plan *restrict plan, int count, float *restrict row)
{
    const float *restrict powers = plan->powers;
    for (int i = 0; i < count; i++) {
        float entry = row[i] * MULTI_SAMPLE_TABLE;
        int whole = (int)entry < MULTI_SAMPLE_TABLE ? (int)entry : MULTI_SAMPLE_TABLE;
        row[i] = powers[whole] + (entry - (float)whole) * (powers[whole + 1] - powers[whole]);
    }
}

static void trace_slice(const struct multi_sample_state *state, int side, float *texels)
{
#pragma omp parallel for
    for (int j = 0; j < side; j++) {
        float *row = texels + (size_t)j * (size_t)side;
        trace_row(state, j, row);
        finish_row(&state->plan, side, row);
    }
}

bool multi_sample_trace(void *state_, const struct light_input *input, struct light_map *map)
{
    struct multi_sample_state *state = state_;
    if (!resize_buffers(state, map->side, input->log) ||
        !normal_map_begin(&state->normal_map, input->surface, map->side, input->log))
        return false;
    fill_normals(state);
    for (int slice = 0; slice < map->slices; slice++) {
        if (!multi_sample_prepare(state, input, slice))
            return false;
        trace_slice(state, map->side, light_map_slice(map, slice));
    }
    return true;
}
