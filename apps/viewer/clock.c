#include "viewer/clock.h"

void clock_start(struct viewer_clock *clock, double time, double now)
{
    *clock = (struct viewer_clock){.time = time, .scale = 1, .last = now};
}

double clock_tick(struct viewer_clock *clock, double now)
{
    double passed = now - clock->last;
    clock->last = now;
    if (!clock->paused)
        clock->time += passed * clock->scale;
    return passed;
}

void clock_step(struct viewer_clock *clock)
{
    clock->paused = true;
    clock->time += CLOCK_STEP;
}
