/* base/log.h: reporting, for the code inside. */
#ifndef BASE_LOG_H
#define BASE_LOG_H

#include "dapple/log.h"

#include <stdbool.h>
#include <stddef.h>

/* Reports an error and returns false, so that a doer can `return base_fail(…)`. */
bool base_fail(const struct dpl_log *log, enum dpl_reason reason, const char *format, ...) DPL_PRINTF(3, 4);

/* Tells what is worth knowing and no error. */
void base_inform(const struct dpl_log *log, const char *format, ...) DPL_PRINTF(2, 3);

/* A log whose messages all open with "name: ", as those about a file that a value names: what is wrong is then told
 * with the value's name. Lives as long as both that it stands on. */
struct base_named_log {
    const char *name;
    const struct dpl_log *outer;
    struct dpl_log log; /* to hand on, once base_name_log() has made it */
};

const struct dpl_log *base_name_log(struct base_named_log *named);

/* calloc() that reports; `what` names what the memory was for. */
void *base_allocate(const struct dpl_log *log, size_t count, size_t size, const char *what);

#endif
