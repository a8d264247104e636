/* gpu/timer.h: how long each pass of a frame takes, on the device or by the clock. */
#ifndef GPU_TIMER_H
#define GPU_TIMER_H

#include "dapple/renderer.h"
#include "gpu/gl.h"

#define TIMER_PASSES_MAX 256 /* more than that of a frame are not timed */
#define TIMER_FRAMES 4       /* frames under way before a query's answer is read */

struct gpu_timer {
    struct dpl_gl *gl; /* NULL: passes run on the CPU alone */
    enum dpl_timing timing;
    double (*now)(void);
    struct timer_frame {
        const char *names[TIMER_PASSES_MAX];
        GLuint queries[TIMER_PASSES_MAX];
        int count;
    } frames[TIMER_FRAMES];
    int current;
    bool running;   /* a pass */
    double started; /* seconds, of the pass under way, in DPL_TIMING_WAIT */
    struct dpl_pass_time times[TIMER_PASSES_MAX + 1];
};

/* Starts a frame. */
void timer_frame(struct gpu_timer *timer);

/* Ends the pass under way and starts the one of that name (kept by pointer); NULL only ends. */
void timer_pass(struct gpu_timer *timer, const char *name);

/* The index-th pass of the last frame that was timed; NULL-named past the last. */
struct dpl_pass_time timer_time(const struct gpu_timer *timer, int index);

void timer_finish(struct gpu_timer *timer);

#endif
