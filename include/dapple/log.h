/* dapple/log.h: how dapple tells its caller what happened.
 *
 * The library prints nothing and never ends the program. Whatever a person should read goes, as one line without
 * a line feed, to the log that the caller hands over; a NULL log is valid and drops everything.
 *
 * An error is reported once, at the place that knows most about it, as
 *     where: what is wrong: the value found (what is accepted)
 * and the function then returns false or NULL. */
#ifndef DAPPLE_LOG_H
#define DAPPLE_LOG_H

#include "dapple/api.h"

#ifdef __cplusplus
extern "C" {
#endif

enum dpl_log_level {
    DPL_LOG_ERROR,   /* the call failed */
    DPL_LOG_WARNING, /* the call went on with something else than was asked for */
    DPL_LOG_INFO,    /* worth knowing */
};

/* What kind of thing went wrong: for programs; the text is for people. */
enum dpl_reason {
    DPL_REASON_NONE,
    DPL_REASON_FILE_READ,       /* a file that is missing, not a file, too large or unreadable */
    DPL_REASON_FILE_WRITE,      /* a file or folder that cannot be written */
    DPL_REASON_FILE_FORMAT,     /* a file whose contents or name ending is of no known format */
    DPL_REASON_SYNTAX,          /* a line of scene text that is neither section, key nor comment */
    DPL_REASON_UNKNOWN_SECTION, /* a section that no table names */
    DPL_REASON_UNKNOWN_KEY,     /* a key that its section's table does not name */
    DPL_REASON_VALUE,           /* a value of the wrong type, or too few or too many numbers */
    DPL_REASON_RANGE,           /* a number outside its range, or not finite */
    DPL_REASON_CHOICE,          /* a word that is not among the choices */
    DPL_REASON_NO_GL,           /* no OpenGL, or not what is needed of it */
    DPL_REASON_SHADER,          /* a shader that does not compile or link */
    DPL_REASON_LIMIT,           /* more than the device or the memory holds */
    DPL_REASON_UNSUPPORTED,     /* a combination that dapple does not do */
};

/* Lifetime: must outlive every object created with it. Threads: called on the thread that made the failing call. */
struct dpl_log {
    void (*write)(void *user, enum dpl_log_level level, enum dpl_reason reason, const char *text);
    void *user;
};

#ifdef __cplusplus
}
#endif

#endif
