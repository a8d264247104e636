/* The last part of coverage.c: bands of rows of the map, each filled and smeared by one thread. */
#include "light/coverage.h"

#include "base/log.h"
#include "base/threads.h"
#include "base/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define ROWS 64 /* fine rows of a band, at least */

/* What the threads share. */
struct task {
    const struct coverage_cells *cells;
    const struct coverage_plan *plan;
    int side;   /* of the map */
    int width;  /* columns of a line of light: the fine map and what the footprints reach over beside it */
    int stride; /* columns of the map in a sorted line */
    int rows;   /* of the map in a band */
};

/* One thread's room. */
struct room {
    void *sums;
    float *light, *sorted, *out;
};

static struct room room_of(const struct coverage_bands *bands, int thread)
{
    size_t t = (size_t)thread;
    return (struct room){(char *)bands->sums + t * bands->sums_size, bands->light + t * bands->light_size,
                         bands->sorted + t * bands->sorted_size, bands->out + t * bands->out_size};
}

static bool resize(struct coverage_bands *bands, const struct task *task, const struct dpl_log *log)
{
    int fineness = task->plan->fineness, reach = task->plan->reach, lines = task->rows * fineness + 2 * reach;
    struct coverage_bands wanted = {
        .threads = threads_most(),
        .sums_size = coverage_fill_room(task->side * fineness, reach, lines),
        .light_size = (size_t)task->width * 3 * (size_t)lines,
        .sorted_size = (size_t)task->stride * (size_t)fineness * 3 * (size_t)lines,
        .out_size = (size_t)task->side * 3 * (size_t)task->rows,
    };
    bool fits = bands->sums && wanted.threads <= bands->threads && wanted.sums_size <= bands->sums_size &&
                wanted.light_size <= bands->light_size && wanted.sorted_size <= bands->sorted_size &&
                wanted.out_size <= bands->out_size;
    if (fits)
        return true;
    size_t *const sizes[] = {&wanted.sums_size, &wanted.light_size, &wanted.sorted_size, &wanted.out_size};
    const size_t had[] = {bands->sums_size, bands->light_size, bands->sorted_size, bands->out_size};
    for (int i = 0; i < 4; i++) /* slices take turns: room for the largest of each */
        *sizes[i] = *sizes[i] > had[i] ? *sizes[i] : had[i];
    size_t threads = (size_t)wanted.threads;
    coverage_bands_finish(bands);
    *bands = wanted;
    bands->sums = aligned_alloc(32, threads * wanted.sums_size);
    bands->light = base_allocate(log, threads * wanted.light_size, sizeof(float), "light");
    bands->sorted = base_allocate(log, threads * wanted.sorted_size, sizeof(float), "light");
    bands->out = base_allocate(log, threads * wanted.out_size, sizeof(float), "light");
    if (bands->sums && bands->light && bands->sorted && bands->out)
        return true;
    if (!bands->sums)
        base_fail(log, DPL_REASON_LIMIT, "light: out of memory: %zu bytes", threads * wanted.sums_size);
    coverage_bands_finish(bands);
    return false;
}

void coverage_bands_finish(struct coverage_bands *bands)
{
    free(bands->sums);
    free(bands->light);
    free(bands->sorted);
    free(bands->out);
    *bands = (struct coverage_bands){0};
}

/* Running sums of a line of light less its mean, which keeps them small. Columns are sorted by their remainder by the
 * fineness, so that neighbouring texels of the map find their own beside each other. */
static void sum_line(const struct task *task, const float *line, double level, float *sorted)
{
    int fineness = task->plan->fineness;
    double sum = 0;
    for (int i = 0, place = 0; i < task->width; place++) {
        for (int phase = 0; phase < fineness && i < task->width; phase++, i++) {
            sum += (double)line[i] - level;
            sorted[phase * task->stride + place] = (float)sum;
        }
    }
}

VECTOR_CLONES static void add_scaled(const float *restrict from, float value, int count, float *restrict to)
{
    for (int i = 0; i < count; i++)
        to[i] += value * from[i];
}

/* Adds the light of one kind, smeared over its footprint, to a row of the map. */
static void smear_row(const struct task *task, const struct room *room, const struct coverage_footprint *footprint,
                      int row, float *out)
{
    int fineness = task->plan->fineness, reach = task->plan->reach, side = task->side;
    size_t line = (size_t)(task->stride * fineness);
    const float level = (float)footprint->level;
    for (int c = 0; c < 3; c++) {
        float *to = out + (size_t)c * (size_t)side;
        for (int i = 0; i < side; i++)
            to[i] += level;
        for (int t = 0; t < footprint->count; t++) {
            const struct coverage_tap *tap = footprint->taps + t;
            int z = row * fineness + tap->z + reach, x = tap->x + reach;
            const float *from = room->sorted + ((size_t)z * 3 + (size_t)c) * line;
            if (x >= 0)
                add_scaled(from + x % fineness * task->stride + x / fineness, tap->value, side, to);
        }
    }
}

/* A point sun's light needs no footprint: the mean of its fine texels. */
static void gather_row(const struct task *task, const struct room *room, int row, float *out)
{
    int fineness = task->plan->fineness, side = task->side;
    float share = 1.0f / (float)(fineness * fineness);
    for (int z = row * fineness; z < (row + 1) * fineness; z++)
        for (int c = 0; c < 3; c++)
            for (int i = 0; i < side * fineness; i++)
                out[c * side + i / fineness] +=
                    share * room->light[((size_t)z * 3 + (size_t)c) * (size_t)task->width + (size_t)i];
}

static void trace_band(const struct task *task, const struct room *room, int first, int count)
{
    const struct coverage_plan *plan = task->plan;
    int lines = count * plan->fineness + 2 * plan->reach, start = first * plan->fineness - plan->reach;
    size_t sorted = (size_t)(task->stride * plan->fineness), row = 3 * (size_t)task->side;
    memset(room->out, 0, row * (size_t)count * sizeof(float));
    for (int k = 0; k < plan->count; k++) {
        const struct coverage_footprint *footprint = plan->footprints + k;
        coverage_fill(task->cells, task->side * plan->fineness, plan->reach, plan->count > 1 ? footprint->kind : NULL,
                      start, lines, room->sums, room->light);
        for (int l = 0; footprint->count > 0 && l < lines * 3; l++)
            sum_line(task, room->light + (size_t)l * (size_t)task->width, footprint->level,
                     room->sorted + (size_t)l * sorted);
        for (int r = 0; r < count; r++) {
            if (footprint->count > 0)
                smear_row(task, room, footprint, r, room->out + (size_t)r * row);
            else
                gather_row(task, room, r, room->out + (size_t)r * row);
        }
    }
}

/* From lines of one colour to texels of three, without what rounding leaves below 0. */
static void write_band(const struct task *task, const struct room *room, int first, int count, int color, float *texels)
{
    size_t side = (size_t)task->side;
    for (size_t r = 0; r < (size_t)count; r++)
        for (size_t c = 0; c < 3; c++)
            for (size_t i = 0; (color < 0 || (size_t)color == c) && i < side; i++)
                texels[(((size_t)first + r) * side + i) * 3 + c] = vector_positive(room->out[(r * 3 + c) * side + i]);
}

bool coverage_bands_trace(struct coverage_bands *bands, const struct coverage_cells *cells,
                          const struct coverage_plan *plan, int color, struct light_map *map, int slice,
                          const struct dpl_log *log)
{
    struct task task = {.cells = cells, .plan = plan, .side = map->side};
    int least = 2 * plan->reach > ROWS ? 2 * plan->reach : ROWS; /* so that what bands share stays small */
    task.width = map->side * plan->fineness + 2 * plan->reach;
    task.stride = task.width / plan->fineness + 1;
    task.rows = (least + plan->fineness - 1) / plan->fineness;
    task.rows = task.rows < map->side ? task.rows : map->side;
    if (!resize(bands, &task, log))
        return false;
    float *texels = light_map_slice(map, slice);
#pragma omp parallel for schedule(dynamic)
    for (int first = 0; first < map->side; first += task.rows) {
        const struct room room = room_of(bands, threads_index());
        int count = map->side - first < task.rows ? map->side - first : task.rows;
        trace_band(&task, &room, first, count);
        write_band(&task, &room, first, count, color, texels);
    }
    return true;
}

/* The texels before and after the i-th of a map's along one axis, and how far it is from the first to the second. */
static double locate(int i, int side, int small, bool periodic, int texels[2])
{
    double place = (i + 0.5) / side * small - 0.5, whole = floor(place);
    for (int k = 0; k < 2; k++) {
        int texel = (int)whole + k;
        texels[k] = periodic ? (texel + small) % small : texel < 0 ? 0 : texel < small ? texel : small - 1;
    }
    return place - whole;
}

void coverage_enlarge(const struct light_map *small, int color, bool periodic, struct light_map *map, int slice)
{
    float *out = light_map_slice(map, slice);
    size_t side = (size_t)map->side, few = (size_t)small->side;
#pragma omp parallel for
    for (int j = 0; j < map->side; j++) {
        int rows[2], columns[2];
        double z = locate(j, map->side, small->side, periodic, rows);
        for (int i = 0; i < map->side; i++) {
            double x = locate(i, map->side, small->side, periodic, columns);
            for (size_t c = 0; c < 3; c++) {
                double sum = 0;
                for (int k = 0; k < 4; k++) {
                    size_t at = ((size_t)rows[k / 2] * few + (size_t)columns[k % 2]) * 3 + c;
                    sum += (k / 2 ? z : 1 - z) * (k % 2 ? x : 1 - x) * (double)small->texels[at];
                }
                if (color < 0 || (size_t)color == c)
                    out[((size_t)j * side + (size_t)i) * 3 + c] = (float)sum;
            }
        }
    }
}
