#include "base/log.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

static void write_line(const struct dpl_log *log, enum dpl_log_level level, enum dpl_reason reason, const char *format,
                       va_list arguments)
{
    if (!log || !log->write)
        return;
    char text[1024];
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

void *base_allocate(const struct dpl_log *log, size_t count, size_t size, const char *what)
{
    void *memory = calloc(count, size);
    if (!memory)
        base_fail(log, DPL_REASON_LIMIT, "out of memory for %s: %zu bytes", what, count * size);
    return memory;
}
