#include "base/param.h"

#include "base/log.h"

#include <assert.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#define NUMBERS_MAX 3

static const char *const words_true[] = {"true", "yes", "on", "1"};
static const char *const words_false[] = {"false", "no", "off", "0"};

static void *value_of(const struct dpl_param *param, void *values)
{
    return (char *)values + param->offset;
}

static bool is_float(const struct dpl_param *param)
{
    return param->type == DPL_PARAM_FLOAT || param->type == DPL_PARAM_COLOR;
}

static void set_default(const struct dpl_param *param, void *value)
{
    if (param->type == DPL_PARAM_TEXT)
        memset(value, 0, DPL_PARAM_TEXT_SIZE);
    else if (param->type == DPL_PARAM_BOOL)
        *(bool *)value = param->initial[0] != 0;
    else if (param->type == DPL_PARAM_CHOICE)
        *(int *)value = (int)param->initial[0];
    else if (is_float(param))
        memcpy(value, param->initial, (size_t)param->count * sizeof(double));
    else
        for (int i = 0; i < param->count; i++)
            ((int *)value)[i] = (int)param->initial[i];
}

void param_defaults(const struct dpl_param *table, void *values)
{
    for (const struct dpl_param *param = table; param->name; param++)
        set_default(param, value_of(param, values));
}

const struct dpl_param *param_find(const struct dpl_param *table, const char *name)
{
    for (const struct dpl_param *param = table; param->name; param++)
        if (!strcmp(param->name, name))
            return param;
    return NULL;
}

static const char *choice_name(const void *param, int i)
{
    return ((const struct dpl_param *)param)->choice(i);
}

/* Reports "where: what: "text" (accepted: …)", with a hint where it is a choice. */
static bool reject(const struct dpl_param *param, enum dpl_reason reason, const char *where, const char *what,
                   const char *text, const struct dpl_log *log)
{
    char accepted[512], hint[64] = "";
    dpl_param_describe(param, accepted, sizeof accepted);
    if (param->type == DPL_PARAM_CHOICE)
        dpl_hint(text, choice_name, param, hint, sizeof hint);
    return base_fail(log, reason, "%s: %s: \"%.80s\" (%saccepted: %s)", where, what, text, hint, accepted);
}

static bool parse_numbers(const struct dpl_param *param, void *value, const char *text, const char *where,
                          const struct dpl_log *log)
{
    double numbers[NUMBERS_MAX];
    const char *rest = text;
    for (int i = 0; i < param->count; i++) {
        char *end;
        errno = 0;
        numbers[i] = strtod(rest, &end);
        if (end == rest)
            return reject(param, DPL_REASON_VALUE, where,
                          i       ? "too few numbers"
                          : *text ? "not a number"
                                  : "no value (# and ; start a comment)",
                          text, log);
        if (param->type == DPL_PARAM_INT && isfinite(numbers[i]) && numbers[i] != floor(numbers[i]))
            return reject(param, DPL_REASON_VALUE, where, "not a whole number", text, log);
        if (!isfinite(numbers[i]) || numbers[i] < param->minimum || numbers[i] > param->maximum)
            return reject(param, DPL_REASON_RANGE, where, "out of range", text, log);
        rest = end + strspn(end, " \t,");
    }
    if (*rest)
        return reject(param, DPL_REASON_VALUE, where,
                      strchr("+-.0123456789", *rest) ? "too many numbers"
                                                     : "more than a number, which stands without its unit",
                      text, log);
    for (int i = 0; i < param->count; i++) {
        if (param->type == DPL_PARAM_INT)
            ((int *)value)[i] = (int)numbers[i];
        else
            ((double *)value)[i] = numbers[i];
    }
    return true;
}

static bool parse_bool(const struct dpl_param *param, bool *value, const char *text, const char *where,
                       const struct dpl_log *log)
{
    for (int i = 0; i < 4; i++) {
        bool is_true = !strcasecmp(text, words_true[i]);
        if (is_true || !strcasecmp(text, words_false[i])) {
            *value = is_true;
            return true;
        }
    }
    return reject(param, DPL_REASON_VALUE, where, "neither true nor false", text, log);
}

static bool parse_choice(const struct dpl_param *param, int *value, const char *text, const char *where,
                         const struct dpl_log *log)
{
    for (int i = 0; param->choice(i); i++) {
        if (!strcmp(text, param->choice(i))) {
            *value = i;
            return true;
        }
    }
    return reject(param, DPL_REASON_CHOICE, where, "no such choice", text, log);
}

bool param_fits_scene_text(const char *text)
{
    for (const char *c = text; *c; c++)
        if ((unsigned char)*c < ' ' || ((c == text || c[-1] == ' ') && (*c == '#' || *c == ';')))
            return false;
    return *text != ' ' && (!*text || text[strlen(text) - 1] != ' ');
}

static bool parse_text(const struct dpl_param *param, char *value, const char *text, const char *where,
                       const struct dpl_log *log)
{
    if (strlen(text) >= DPL_PARAM_TEXT_SIZE)
        return reject(param, DPL_REASON_RANGE, where, "too long", text, log);
    if (!param_fits_scene_text(text))
        return reject(param, DPL_REASON_VALUE, where, "cannot stand in scene text", text, log);
    memset(value, 0, DPL_PARAM_TEXT_SIZE);
    memcpy(value, text, strlen(text));
    return true;
}

bool param_parse(const struct dpl_param *param, void *values, const char *text, const char *where,
                 const struct dpl_log *log)
{
    void *value = value_of(param, values);
    switch (param->type) {
    case DPL_PARAM_BOOL:
        return parse_bool(param, value, text, where, log);
    case DPL_PARAM_CHOICE:
        return parse_choice(param, value, text, where, log);
    case DPL_PARAM_TEXT:
        return parse_text(param, value, text, where, log);
    default:
        return parse_numbers(param, value, text, where, log);
    }
}

/* The shortest decimal text that reads back to the same number; whole numbers without an exponent. */
static int format_number(double number, char *text, size_t size)
{
    if (number == floor(number) && fabs(number) < 1e9)
        return snprintf(text, size, "%.0f", number);
    for (int digits = 6; digits < 17; digits++) {
        int length = snprintf(text, size, "%.*g", digits, number);
        if (strtod(text, NULL) == number)
            return length;
    }
    return snprintf(text, size, "%.17g", number);
}

bool dpl_param_format(const struct dpl_param *param, const void *values, char *text, size_t size)
{
    const void *value = (const char *)values + param->offset;
    if (param->type == DPL_PARAM_TEXT)
        return snprintf(text, size, "%s", (const char *)value) < (int)size;
    if (param->type == DPL_PARAM_BOOL)
        return snprintf(text, size, "%s", *(const bool *)value ? "true" : "false") < (int)size;
    if (param->type == DPL_PARAM_CHOICE)
        return snprintf(text, size, "%s", param->choice(*(const int *)value)) < (int)size;
    size_t used = 0;
    for (int i = 0; i < param->count; i++) {
        char number[32];
        format_number(is_float(param) ? ((const double *)value)[i] : ((const int *)value)[i], number, sizeof number);
        used += (size_t)snprintf(text + used, size - used, "%s%s", i ? " " : "", number);
        if (used >= size)
            return false;
    }
    return true;
}

static void describe_choices(const struct dpl_param *param, char *text, size_t size)
{
    size_t used = (size_t)snprintf(text, size, "one of ");
    for (int i = 0; param->choice(i) && used < size; i++)
        used += (size_t)snprintf(text + used, size - used, "%s%s", i ? ", " : "", param->choice(i));
}

static void describe_numbers(const struct dpl_param *param, char *text, size_t size)
{
    char low[32], high[32];
    format_number(param->minimum, low, sizeof low);
    format_number(param->maximum, high, sizeof high);
    static const char *const many[] = {"", "two ", "three "};
    const char *kind = param->type == DPL_PARAM_INT ? "whole number" : "number";
    snprintf(text, size, "%s%s%s from %s to %s%s%s", many[param->count - 1], kind, param->count > 1 ? "s" : "", low,
             high, *param->unit ? " " : "", param->unit);
}

void dpl_param_describe(const struct dpl_param *param, char *text, size_t size)
{
    assert(size > 0);
    switch (param->type) {
    case DPL_PARAM_BOOL:
        snprintf(text, size, "true or false");
        break;
    case DPL_PARAM_CHOICE:
        describe_choices(param, text, size);
        break;
    case DPL_PARAM_TEXT:
        snprintf(text, size, "text of at most %d bytes, neither # nor ; at its start or after a blank",
                 DPL_PARAM_TEXT_SIZE - 1);
        break;
    default:
        describe_numbers(param, text, size);
    }
}
