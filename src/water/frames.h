/* water/frames.h: heights from pictures on disk: one, or numbered ones. The first channel counts. */
#ifndef WATER_FRAMES_H
#define WATER_FRAMES_H

#include "dapple/log.h"
#include "dapple/param.h"

#define FRAME_SLOTS_MAX 256

/* All zero: nothing open. */
struct frames {
    char name[DPL_PARAM_TEXT_SIZE]; /* of the picture, or with %04d in it; empty: nothing is open */
    int first;                      /* number of the first picture */
    int count, side;                /* pictures; their vertices a side */
    int slots;                      /* how many pictures memory may hold */
    struct {
        int frame;
        float *values;       /* side × side; NULL: empty */
    } slot[FRAME_SLOTS_MAX]; /* frame k is kept in slot k % slots, and in no other */
};

/* Finds the pictures and reads the first; does nothing where they are open already. Pictures are square and of one
 * size, their values finite. */
bool frames_open(struct frames *frames, const char *name, int first, const struct dpl_log *log);

/* True where they are open already. */
bool frames_are_open(const struct frames *frames, const char *name, int first);

/* The values of a frame, 0 to count - 1, row 0 the top row, valid until the next call. NULL where it cannot be read,
 * with the reason logged. */
const float *frames_get(struct frames *frames, int frame, const struct dpl_log *log);

/* Leaves it zeroed. */
void frames_close(struct frames *frames);

#endif
