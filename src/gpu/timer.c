#include "gpu/timer.h"

/* Reads the answers of the slot's last use, if all of them have arrived. */
static void collect_queries(struct gpu_timer *timer, const struct timer_frame *frame)
{
    GLuint ready = 0;
    if (frame->count)
        timer->gl->GetQueryObjectuiv(frame->queries[frame->count - 1], GL_QUERY_RESULT_AVAILABLE, &ready);
    if (!ready)
        return;
    for (int i = 0; i < frame->count; i++) {
        GLuint nanoseconds = 0;
        timer->gl->GetQueryObjectuiv(frame->queries[i], GL_QUERY_RESULT, &nanoseconds);
        timer->times[i] = (struct dpl_pass_time){frame->names[i], nanoseconds * 1e-6};
    }
    timer->times[frame->count].name = NULL;
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
}

static double finished_now(struct gpu_timer *timer)
{
    if (timer->gl)
        timer->gl->Finish();
    return timer->now();
}

static void end_pass(struct gpu_timer *timer, struct timer_frame *frame)
{
    int index = frame->count - 1;
    if (timer->timing == DPL_TIMING_QUERIES) {
        timer->gl->EndQuery(GL_TIME_ELAPSED);
        return;
    }
    timer->times[index] = (struct dpl_pass_time){frame->names[index], (finished_now(timer) - timer->started) * 1e3};
    timer->times[index + 1].name = NULL;
}

void timer_pass(struct gpu_timer *timer, const char *name)
{
    struct timer_frame *frame = timer->frames + timer->current;
    if (timer->timing == DPL_TIMING_OFF)
        return;
    if (frame->count)
        end_pass(timer, frame);
    if (!name || frame->count == TIMER_PASSES_MAX)
        return;
    frame->names[frame->count] = name;
    if (timer->timing == DPL_TIMING_QUERIES)
        timer->gl->BeginQuery(GL_TIME_ELAPSED, frame->queries[frame->count]);
    else
        timer->started = finished_now(timer);
    frame->count++;
}

struct dpl_pass_time timer_time(const struct gpu_timer *timer, int index)
{
    const struct dpl_pass_time *times = timer->times;
    for (int i = 0; i < index && times[i].name; i++)
        if (!times[i + 1].name)
            return (struct dpl_pass_time){0};
    return times[index];
}

void timer_finish(struct gpu_timer *timer)
{
    for (int i = 0; timer->gl && i < TIMER_FRAMES; i++)
        if (timer->frames[i].queries[0])
            timer->gl->DeleteQueries(TIMER_PASSES_MAX, timer->frames[i].queries);
}
