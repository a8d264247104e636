#include "base/log.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#define LINE_SIZE 1024 /* bytes of a message */

static void write_line(const struct dpl_log *log, enum dpl_log_level level, enum dpl_reason reason, const char *format,
                       va_list arguments)
{
    if (!log || !log->write)
        return;
    char text[LINE_SIZE];
    vsnprintf(text, sizeof text, format, arguments);
    for (char *c = text; *c; c++) /* a driver's words, or a value, may have more than one line */
        if ((unsigned char)*c < ' ')
            *c = ' ';
    log->write(log->user, level, reason, text);
}

bool base_fail(const struct dpl_log *log, enum dpl_reason reason, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    write_line(log, DPL_LOG_ERROR, reason, format, arguments);
    va_end(arguments);
    return false;
}

void base_inform(const struct dpl_log *log, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    write_line(log, DPL_LOG_INFO, DPL_REASON_NONE, format, arguments);
    va_end(arguments);
}

static void write_named(void *user, enum dpl_log_level level, enum dpl_reason reason, const char *text)
{
    const struct base_named_log *named = user;
    char line[LINE_SIZE];
    if (!named->outer || !named->outer->write)
        return;
    snprintf(line, sizeof line, "%s: %s", named->name, text);
    named->outer->write(named->outer->user, level, reason, line);
}

const struct dpl_log *base_name_log(struct base_named_log *named)
{
    named->log = (struct dpl_log){write_named, named};
    return &named->log;
}

void *base_allocate(const struct dpl_log *log, size_t count, size_t size, const char *what)
{
    void *memory = calloc(count, size);
    if (!memory)
        base_fail(log, DPL_REASON_LIMIT, "out of memory for %s: %zu bytes", what, count * size);
    return memory;
}
