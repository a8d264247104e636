#include "cli/progress.h"

#include "cli/clock.h"

#include <stdio.h>
#include <unistd.h>

#define WIDTH 30 /* of the bar, characters */

void progress_begin(struct progress *progress, const char *name, int count, bool quiet, struct program_log *log)
{
    *progress = (struct progress){log, name, count, clock_seconds(), !quiet && count > 1 && isatty(STDERR_FILENO)};
    progress_step(progress, 0);
}

void progress_step(const struct progress *progress, int done)
{
    if (!progress->shown)
        return;
    int filled = (int)((long long)WIDTH * done / progress->count);
    double left = done ? (clock_seconds() - progress->started) / done * (progress->count - done) : 0;
    fprintf(stderr, "\r\033[K%s [%.*s%*s] %d/%d", progress->name, filled,
            "==============================", WIDTH - filled, "", done, progress->count);
    if (done)
        fprintf(stderr, ", %.0f s left", left);
    progress->log->bar_shown = true;
}

void progress_end(const struct progress *progress)
{
    if (!progress->shown || !progress->log->bar_shown)
        return;
    fputs("\r\033[K", stderr);
    progress->log->bar_shown = false;
}
