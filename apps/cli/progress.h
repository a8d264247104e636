/* cli/progress.h: a bar on stderr, where that is a terminal. */
#ifndef CLI_PROGRESS_H
#define CLI_PROGRESS_H

#include "cli/log.h"

struct progress {
    struct program_log *log;
    const char *name;
    int count;
    double started; /* seconds */
    bool shown;
};

/* `count` steps are to come. A single step, --quiet or a stderr that is not a terminal shows nothing. */
void progress_begin(struct progress *progress, const char *name, int count, bool quiet, struct program_log *log);
/* `done` steps are done. */
void progress_step(const struct progress *progress, int done);
/* Takes the bar away. */
void progress_end(const struct progress *progress);

#endif
