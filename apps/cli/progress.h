/* cli/progress.h: a bar on stderr, where that is a terminal. */
#ifndef CLI_PROGRESS_H
#define CLI_PROGRESS_H

#include "cli/log.h"

struct progress {
    struct program_log *log;
    const char *name;
    int count;
    double started, first, drawn; /* seconds; `first`: when the first whole step was done */
    bool shown;
};

/* `count` steps are to come. --quiet or a stderr that is not a terminal shows nothing, nor does a single step that
 * tells of no part of it. */
void progress_begin(struct progress *progress, const char *name, int count, bool quiet, struct program_log *log);
/* So many steps and parts of a step are done. */
void progress_step(struct progress *progress, double done);
/* Takes the bar away. */
void progress_end(const struct progress *progress);

#endif
