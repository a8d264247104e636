/* Playing a loop:
 *
 *   1. The two frames around the time are blended.
 *   2. A texel of the map shows the mean, over its square, of the frame between texel centres: straight lines where the
 *      map is finer than the frame, flat texels where it is not, so that a frame of the map's own size stays as it is.
 *      Either way every texel of the frame counts as much as any other: a mean of 1 stays 1. First along x, then along
 *      z. */
#include "light/loop.h"

#include "base/log.h"
#include "base/threads.h"
#include "base/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

size_t loop_frame_size(const struct loop *loop)
{
    return (size_t)loop->side * (size_t)loop->side * (size_t)loop->channels;
}

bool loop_resize(struct loop *loop, int count, int side, int channels, const char *name, const struct dpl_log *log)
{
    struct loop new = {.count = count, .side = side, .channels = channels};
    if (loop_frame_size(&new) * sizeof(float) > LOOP_BYTES_MAX / (size_t)count)
        return base_fail(log, DPL_REASON_LIMIT,
                         "%s: too large: %d frames of %d × %d (accepted: up to %zu MB as floats)", name, count, side,
                         side, LOOP_BYTES_MAX >> 20);
    new.texels = base_allocate(log, loop_frame_size(&new) * (size_t)count, sizeof(float), "frames of a loop");
    if (!new.texels)
        return false;
    loop_finish(loop);
    *loop = new;
    return true;
}

void loop_finish(struct loop *loop)
{
    free(loop->texels);
    *loop = (struct loop){0};
}

struct loop_moment loop_moment_at(const struct loop *loop, double turns)
{
    /* In whole parts of a frame: the end of a loop, found by a division that rounds, is its start. */
    const double parts = 1 << 20;
    double place = round((turns - floor(turns)) * loop->count * parts) / parts, frame = floor(place);
    return (struct loop_moment){(int)frame % loop->count, ((int)frame + 1) % loop->count, (float)(place - frame)};
}

/* The share of what a texel of the frame shows that lies below x, which is counted from its middle. */
static double share_below(double x, bool smooth)
{
    if (!smooth)
        return fmin(fmax(x + 0.5, 0), 1);
    x = fmin(fmax(x, -1), 1);
    return x < 0 ? (1 + x) * (1 + x) / 2 : 1 - (1 - x) * (1 - x) / 2;
}

/* Step 2, what does not change from frame to frame. Texel i of the map shows `count` texels of the frame. */
static void weigh(struct loop_axis *axis)
{
    double step = axis->step;
    bool smooth = step < 1 - 1e-6;
    for (int i = 0; i < axis->map_side; i++) {
        double from = axis->start + i * step, first = floor(from - 0.5);
        axis->first[i] = (int)(first - floor(first / axis->side) * axis->side);
        for (int k = 0; k < axis->count; k++) {
            double start = from - (first + k + 0.5);
            axis->weights[k * axis->map_side + i] =
                (float)((share_below(start + step, smooth) - share_below(start, smooth)) / step);
        }
    }
}

/* Room for `count` values of `size` bytes: what is there, if that is `room` values or more. */
static void *grow(void *buffer, size_t *room, size_t count, size_t size, const struct dpl_log *log)
{
    if (*room >= count)
        return buffer;
    free(buffer);
    buffer = base_allocate(log, count, size, "frames of a loop");
    *room = buffer ? count : 0;
    return buffer;
}

/* Readies an axis of the map that starts at `start`, counted in texels of the frame, as are its texels' width. */
static bool ready_axis(struct loop_axis *axis, int side, int map_side, double start, double step,
                       const struct dpl_log *log)
{
    if (axis->side == side && axis->map_side == map_side && axis->start == start && axis->step == step)
        return true;
    size_t texels = (size_t)map_side;
    axis->side = 0; /* not ready, if there is no room */
    axis->map_side = map_side;
    axis->count = (int)ceil(step) + 2;
    axis->start = start;
    axis->step = step;
    axis->first = grow(axis->first, &axis->first_room, texels, sizeof *axis->first, log);
    axis->weights = grow(axis->weights, &axis->weights_room, texels * (size_t)axis->count, sizeof *axis->weights, log);
    if (!axis->first || !axis->weights)
        return false;
    axis->side = side;
    weigh(axis);
    return true;
}

/* Step 1, of a row, with what follows where it repeats. */
VECTOR_CLONES static void blend_row(const float *restrict first, const float *restrict second, float part, int side,
                                    int count, float *restrict out)
{
    for (int i = 0; i < side; i++)
        out[i] = first[i] + part * (second[i] - first[i]);
    for (int i = 0; i < count; i++)
        out[side + i] = out[i];
}

/* Step 2 along x, of one channel. */
VECTOR_CLONES static void widen_row(const struct loop_axis *restrict axis, const float *restrict row, int channels,
                                    float *restrict out)
{
    const int *restrict first = axis->first;
    for (int i = 0; i < axis->map_side; i++)
        out[i] = 0;
    for (int k = 0; k < axis->count; k++)
        for (int i = 0; i < axis->map_side; i++)
            out[i] += axis->weights[k * axis->map_side + i] * row[(first[i] + k) * channels];
}

VECTOR_CLONES static void add_row(const float *restrict row, float weight, int count, float *restrict sum)
{
    for (int i = 0; i < count; i++)
        sum[i] += weight * row[i];
}

/* Step 2 along z, of a row of the map; `sum` is room for a row of one channel. */
static void show_row(const struct loop_player *player, const struct loop *loop, int j, float *sum, float *out)
{
    const struct loop_axis *z = &player->z;
    int map_side = player->x.map_side;
    for (int c = 0; c < loop->channels; c++) {
        memset(sum, 0, (size_t)map_side * sizeof *sum);
        for (int k = 0; k < z->count; k++) {
            int row = (z->first[j] + k) % loop->side * loop->channels + c;
            add_row(player->lines + (size_t)row * (size_t)map_side, z->weights[k * z->map_side + j], map_side, sum);
        }
        for (int i = 0; i < map_side; i++)
            for (int to = c; to < 3; to += loop->channels)
                out[i * 3 + to] = sum[i];
    }
}

static bool resize_buffers(struct loop_player *player, const struct loop *loop, int map_side, const struct dpl_log *log)
{
    size_t blended = (size_t)(loop->side + player->x.count) * (size_t)loop->channels;
    size_t lines = (size_t)loop->side * (size_t)loop->channels * (size_t)map_side;
    size_t thread = blended > (size_t)map_side ? blended : (size_t)map_side;
    player->threads = threads_most();
    player->thread_size = thread;
    player->lines = grow(player->lines, &player->lines_room, lines, sizeof(float), log);
    player->scratch =
        grow(player->scratch, &player->scratch_room, thread * (size_t)player->threads, sizeof(float), log);
    return player->lines && player->scratch;
}

bool loop_play(struct loop_player *player, const struct loop *loop, const struct loop_moment *moment,
               const struct ray_window *window, double size, double tile, struct light_map *map, int slice,
               const struct dpl_log *log)
{
    double scale = loop->side / tile, step = window->side * scale / map->side; /* texels of the frame */
    if (!ready_axis(&player->x, loop->side, map->side, (window->x + size / 2) * scale, step, log) ||
        !ready_axis(&player->z, loop->side, map->side, (window->z + size / 2) * scale, step, log) ||
        !resize_buffers(player, loop, map->side, log))
        return false;
    int channels = loop->channels, row = loop->side * channels, margin = player->x.count * channels;
    const float *first = loop->texels + (size_t)moment->frame * loop_frame_size(loop);
    const float *second = loop->texels + (size_t)moment->next * loop_frame_size(loop);
    float *texels = light_map_slice(map, slice);
#pragma omp parallel num_threads(player->threads)
    {
        float *scratch = player->scratch + (size_t)threads_index() * player->thread_size;
#pragma omp for
        for (int j = 0; j < loop->side; j++) {
            size_t start = (size_t)j * (size_t)row;
            blend_row(first + start, second + start, moment->part, row, margin, scratch);
            for (int c = 0; c < channels; c++)
                widen_row(&player->x, scratch + c, channels,
                          player->lines + ((size_t)j * (size_t)channels + (size_t)c) * (size_t)map->side);
        }
#pragma omp for
        for (int j = 0; j < map->side; j++)
            show_row(player, loop, j, scratch, texels + (size_t)j * (size_t)map->side * 3);
    }
    return true;
}

void loop_player_finish(struct loop_player *player)
{
    free(player->x.first);
    free(player->x.weights);
    free(player->z.first);
    free(player->z.weights);
    free(player->lines);
    free(player->scratch);
    *player = (struct loop_player){0};
}
