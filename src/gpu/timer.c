#include "gpu/timer.h"

#include <string.h>

/* Passes of one name are one pass: a picture of several samples goes through them again. */
static void add_time(struct gpu_timer *timer, const char *name, double milliseconds)
{
    int i = 0;
    while (timer->times[i].name && strcmp(timer->times[i].name, name))
        i++;
    if (!timer->times[i].name) {
        timer->times[i] = (struct dpl_pass_time){name, 0};
        timer->times[i + 1].name = NULL;
    }
    timer->times[i].milliseconds += milliseconds;
}

/* Reads the answers of the slot's last use, if all of them have arrived. */
static void collect_queries(struct gpu_timer *timer, const struct timer_frame *frame)
{
    GLuint ready = 0;
    if (frame->count)
        timer->gl->GetQueryObjectuiv(frame->queries[frame->count - 1], GL_QUERY_RESULT_AVAILABLE, &ready);
    if (!ready)
        return;
    timer->times[0].name = NULL;
    for (int i = 0; i < frame->count; i++) {
        GLuint nanoseconds = 0;
        timer->gl->GetQueryObjectuiv(frame->queries[i], GL_QUERY_RESULT, &nanoseconds);
        add_time(timer, frame->names[i], nanoseconds * 1e-6);
    }
}

void timer_frame(struct gpu_timer *timer)
{
    if (timer->timing == DPL_TIMING_OFF)
        return;
    timer->current = (timer->current + 1) % TIMER_FRAMES;
    struct timer_frame *frame = timer->frames + timer->current;
    if (timer->timing == DPL_TIMING_QUERIES) {
        collect_queries(timer, frame);
        if (!frame->queries[0])
            timer->gl->GenQueries(TIMER_PASSES_MAX, frame->queries);
    }
    frame->count = 0;
    if (timer->timing == DPL_TIMING_WAIT)
        timer->times[0].name = NULL;
}

static double finished_now(struct gpu_timer *timer)
{
    if (timer->gl)
        timer->gl->Finish();
    return timer->now();
}

static void end_pass(struct gpu_timer *timer, struct timer_frame *frame)
{
    timer->running = false;
    if (timer->timing == DPL_TIMING_QUERIES)
        timer->gl->EndQuery(GL_TIME_ELAPSED);
    else
        add_time(timer, frame->names[frame->count - 1], (finished_now(timer) - timer->started) * 1e3);
}

void timer_pass(struct gpu_timer *timer, const char *name)
{
    struct timer_frame *frame = timer->frames + timer->current;
    if (timer->timing == DPL_TIMING_OFF)
        return;
    if (timer->running)
        end_pass(timer, frame);
    if (!name || frame->count == TIMER_PASSES_MAX)
        return;
    frame->names[frame->count] = name;
    if (timer->timing == DPL_TIMING_QUERIES)
        timer->gl->BeginQuery(GL_TIME_ELAPSED, frame->queries[frame->count]);
    else
        timer->started = finished_now(timer);
    frame->count++;
    timer->running = true;
}

struct dpl_pass_time timer_time(const struct gpu_timer *timer, int index)
{
    const struct dpl_pass_time *times = timer->times;
    for (int i = 0; i <= index; i++)
        if (!times[i].name)
            return (struct dpl_pass_time){0};
    return index < 0 ? (struct dpl_pass_time){0} : times[index];
}

void timer_finish(struct gpu_timer *timer)
{
    for (int i = 0; timer->gl && i < TIMER_FRAMES; i++)
        if (timer->frames[i].queries[0])
            timer->gl->DeleteQueries(TIMER_PASSES_MAX, timer->frames[i].queries);
}
