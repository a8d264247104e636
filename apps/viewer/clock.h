/* clock.h: the scene's time, made from real time: paused, step by step, slower or faster. */
#ifndef VIEWER_CLOCK_H
#define VIEWER_CLOCK_H

#include <stdbool.h>

#define CLOCK_STEP (1.0 / 60.0) /* s, of the scene's time */

struct viewer_clock {
    double time;  /* s, of the scene */
    double scale; /* seconds of the scene in a real second */
    bool paused;
    double last; /* s, real time of the last tick */
};

/* Runs at real speed from `time` on; `now` is a steady real time in seconds. */
void clock_start(struct viewer_clock *clock, double time, double now);

/* Moves on to `now`; returns the real seconds since the last tick. */
double clock_tick(struct viewer_clock *clock, double now);

/* Pauses, and moves on by CLOCK_STEP. */
void clock_step(struct viewer_clock *clock);

#endif
