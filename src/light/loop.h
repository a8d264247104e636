/* light/loop.h: caustic maps made beforehand that repeat after a time, and how they are played. */
#ifndef LIGHT_LOOP_H
#define LIGHT_LOOP_H

#include "light/light.h"

#define LOOP_FRAMES_MAX 4096
#define LOOP_BYTES_MAX ((size_t)1 << 31) /* of all frames */

/* Frames at even times over the loop, each of one tile that joins itself at the edges. All zero: none. */
struct loop {
    int count, side, channels; /* 1 or 3 channels */
    float *texels;             /* count × side × side × channels, rows as in a map */
};

/* Makes room for that many frames, all zero; `name` is what an error names. */
bool loop_resize(struct loop *loop, int count, int side, int channels, const char *name, const struct dpl_log *log);

/* Values in one frame. */
size_t loop_frame_size(const struct loop *loop);

/* Reads numbered pictures, without a gap between the first number and the last: `place` is a pattern with one %d or
 * %0Nd in its last part, or a folder that holds them. The loop is as it was where that fails. */
bool loop_read(struct loop *loop, const char *place, const struct dpl_log *log);

void loop_finish(struct loop *loop);

/* Which frames a time shows: `part` of the way from the one to the next. */
struct loop_moment {
    int frame, next;
    float part;
};

/* `turns`: time in lengths of the loop. */
struct loop_moment loop_moment_at(const struct loop *loop, double turns);

/* Along one axis, the frame's texels that the map's show. Buffers only grow: slices differ in what they show. */
struct loop_axis {
    int side, map_side, count; /* texels of the frame; of the map; of the frame that one of the map may show */
    double start, step;        /* where the map starts, and the width of its texels, in texels of the frame */
    int *first;                /* for each of the map, the first that it shows, 0 to side - 1 */
    float *weights;            /* count × map_side: their shares, sum 1 */
    size_t first_room, weights_room;
};

/* What is kept between frames that are played. All zero: none yet. */
struct loop_player {
    struct loop_axis x, z;
    float *lines;   /* a frame with rows as wide as the map, each channel a row */
    float *scratch; /* for each thread a row of `thread_size` */
    int threads;
    size_t lines_room, scratch_room, thread_size;
};

/* Fills a slice of the map, three channels, with what its window shows of the loop, whose tiles are `tile` metres wide;
 * one starts at x = z = -size/2. */
bool loop_play(struct loop_player *player, const struct loop *loop, const struct loop_moment *moment,
               const struct ray_window *window, double size, double tile, struct light_map *map, int slice,
               const struct dpl_log *log);

void loop_player_finish(struct loop_player *player);

#endif
