/* cli/log.h: messages on stderr, and the exit code that an error means. */
#ifndef CLI_LOG_H
#define CLI_LOG_H

#include "dapple/log.h"

#include <stdbool.h>

#define LOG_TEXT_SIZE 1024 /* bytes of a message, its ending zero included */

enum exit_code { EXIT_DONE = 0, EXIT_COULD_NOT = 1, EXIT_WRONG_INPUT = 2 };

struct program_log {
    struct dpl_log log;       /* for the library */
    enum exit_code exit_code; /* of the first error */
    const char *instead;      /* not NULL: an error is only a warning, and this is done in place of what failed */
    char *caught;             /* not NULL: an error is only kept here, in LOG_TEXT_SIZE bytes */
    bool bar_shown;           /* the cursor stands behind a progress bar */
};

/* Fills a log that must stay where it is: the library keeps its address. */
void log_begin(struct program_log *log);

/* Report an error and return false: what the user gave is wrong (exit 2), or something could not be done (exit 1). */
bool fail_input(struct program_log *log, const char *format, ...) DPL_PRINTF(2, 3);
bool fail_work(struct program_log *log, const char *format, ...) DPL_PRINTF(2, 3);

#endif
