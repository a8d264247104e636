#include "cli/progress.h"

#include "cli/clock.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

#define WIDTH 30     /* of the bar, characters */
#define INTERVAL 0.1 /* s, between parts of a step */

void progress_begin(struct progress *progress, const char *name, int count, bool quiet, struct program_log *log)
{
    *progress = (struct progress){log, name, count, clock_seconds(), 0, 0, !quiet && isatty(STDERR_FILENO)};
    progress_step(progress, 0);
}

void progress_step(struct progress *progress, double done)
{
    double now = clock_seconds();
    bool whole = done == floor(done);
    if (done == 1)
        progress->first = now;
    if (!progress->shown || (whole ? progress->count == 1 : now - progress->drawn < INTERVAL))
        return;
    int filled = (int)(WIDTH * done / progress->count);
    fprintf(stderr, "\r\033[K%s [%.*s%*s] ", progress->name, filled, "==============================", WIDTH - filled,
            "");
    if (progress->count > 1)
        fprintf(stderr, "%d/%d", (int)done, progress->count);
    else
        fprintf(stderr, "%.0f %%", done * 100);
    if (progress->count > 2 && done > 1) /* the first of many steps takes longer */
        fprintf(stderr, ", %.0f s left", (now - progress->first) / (done - 1) * (progress->count - done));
    else if (progress->count <= 2 && done > 0)
        fprintf(stderr, ", %.0f s left", (now - progress->started) / done * (progress->count - done));
    progress->drawn = now;
    progress->log->bar_shown = true;
}

void progress_end(const struct progress *progress)
{
    if (!progress->shown || !progress->log->bar_shown)
        return;
    fputs("\r\033[K", stderr);
    progress->log->bar_shown = false;
}
