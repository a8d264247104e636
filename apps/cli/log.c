#include "cli/log.h"

#include <stdarg.h>
#include <stdio.h>

static enum exit_code code_of(enum dpl_reason reason)
{
    switch (reason) {
    case DPL_REASON_FILE_READ:
    case DPL_REASON_FILE_FORMAT:
    case DPL_REASON_SYNTAX:
    case DPL_REASON_UNKNOWN_SECTION:
    case DPL_REASON_UNKNOWN_KEY:
    case DPL_REASON_VALUE:
    case DPL_REASON_RANGE:
    case DPL_REASON_CHOICE:
        return EXIT_WRONG_INPUT;
    default:
        return EXIT_COULD_NOT;
    }
}

static void write_message(void *user, enum dpl_log_level level, enum dpl_reason reason, const char *text)
{
    struct program_log *log = user;
    static const char *const names[] = {"error", "warning", "note"};
    if (level == DPL_LOG_ERROR && log->caught) {
        snprintf(log->caught, LOG_TEXT_SIZE, "%s", text);
        return;
    }
    const char *instead = level == DPL_LOG_ERROR ? log->instead : NULL;
    if (level == DPL_LOG_ERROR && !instead && log->exit_code == EXIT_DONE)
        log->exit_code = code_of(reason);
    fprintf(stderr, "%sdapple: %s: %s%s%s\n", log->bar_shown ? "\r\033[K" : "",
            names[instead ? DPL_LOG_WARNING : level], text, instead ? "; " : "", instead ? instead : "");
    log->bar_shown = false;
}

void log_begin(struct program_log *log)
{
    *log = (struct program_log){.log = {write_message, log}};
}

static void fail(struct program_log *log, enum dpl_reason reason, const char *format, va_list arguments)
{
    char text[LOG_TEXT_SIZE];
    vsnprintf(text, sizeof text, format, arguments);
    write_message(log, DPL_LOG_ERROR, reason, text);
}

bool fail_input(struct program_log *log, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fail(log, DPL_REASON_VALUE, format, arguments);
    va_end(arguments);
    return false;
}

bool fail_work(struct program_log *log, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fail(log, DPL_REASON_NONE, format, arguments);
    va_end(arguments);
    return false;
}
