/* base/param.h: tables of parameters: defaults, and values from text.
 *
 * A table entry is one line:
 *
 *     static const struct dpl_param sun_params[] = {
 *         PARAM_FLOAT(struct sun, elevation, 60, 0, 90, "degrees", "height of the sun above the horizon"),
 *         PARAM_END,
 *     };
 */
#ifndef BASE_PARAM_H
#define BASE_PARAM_H

#include "dapple/param.h"

#define PARAM_FLOAT(type_, member, initial_, minimum_, maximum_, unit_, help_)                                         \
    {                                                                                                                  \
        .name = #member, .type = DPL_PARAM_FLOAT, .count = 1, .offset = offsetof(type_, member), .minimum = minimum_,  \
        .maximum = maximum_, .initial = {initial_}, .unit = unit_, .help = help_                                       \
    }
#define PARAM_FLOATS(type_, member, count_, minimum_, maximum_, unit_, help_, ...)                                     \
    {                                                                                                                  \
        .name = #member, .type = DPL_PARAM_FLOAT, .count = count_, .offset = offsetof(type_, member),                  \
        .minimum = minimum_, .maximum = maximum_, .initial = {__VA_ARGS__}, .unit = unit_, .help = help_               \
    }
#define PARAM_COLOR(type_, member, maximum_, help_, ...)                                                               \
    {                                                                                                                  \
        .name = #member, .type = DPL_PARAM_COLOR, .count = 3, .offset = offsetof(type_, member), .minimum = 0,         \
        .maximum = maximum_, .initial = {__VA_ARGS__}, .unit = "", .help = help_                                       \
    }
#define PARAM_INT(type_, member, initial_, minimum_, maximum_, unit_, help_)                                           \
    {                                                                                                                  \
        .name = #member, .type = DPL_PARAM_INT, .count = 1, .offset = offsetof(type_, member), .minimum = minimum_,    \
        .maximum = maximum_, .initial = {initial_}, .unit = unit_, .help = help_                                       \
    }
#define PARAM_INTS(type_, member, count_, minimum_, maximum_, unit_, help_, ...)                                       \
    {                                                                                                                  \
        .name = #member, .type = DPL_PARAM_INT, .count = count_, .offset = offsetof(type_, member),                    \
        .minimum = minimum_, .maximum = maximum_, .initial = {__VA_ARGS__}, .unit = unit_, .help = help_               \
    }
#define PARAM_BOOL(type_, member, initial_, help_)                                                                     \
    {                                                                                                                  \
        .name = #member, .type = DPL_PARAM_BOOL, .count = 1, .offset = offsetof(type_, member), .maximum = 1,          \
        .initial = {initial_}, .unit = "", .help = help_                                                               \
    }
#define PARAM_CHOICE(type_, member, initial_, choice_, help_)                                                          \
    {                                                                                                                  \
        .name = #member, .type = DPL_PARAM_CHOICE, .count = 1, .offset = offsetof(type_, member),                      \
        .initial = {initial_}, .unit = "", .help = help_, .choice = choice_                                            \
    }
/* Text is the name of a file, and starts empty. */
#define PARAM_TEXT(type_, member, help_)                                                                               \
    {                                                                                                                  \
        .name = #member, .type = DPL_PARAM_TEXT, .count = 1, .offset = offsetof(type_, member), .unit = "",            \
        .help = help_                                                                                                  \
    }
#define PARAM_END                                                                                                      \
    {                                                                                                                  \
        .name = NULL                                                                                                   \
    }

/* Fills the struct that `table` describes with the defaults. */
void param_defaults(const struct dpl_param *table, void *values);

/* The entry of that name, or NULL. */
const struct dpl_param *param_find(const struct dpl_param *table, const char *name);

/* True where that can be a text value: scene text has no quotes, and what would end a line, start a comment or be
 * trimmed cannot stand in it. */
bool param_fits_scene_text(const char *text);

/* Reads `text` into the value. `where` opens the message: "pool.ini:12: sun.elevation". On failure the value stays. */
bool param_parse(const struct dpl_param *param, void *values, const char *text, const char *where,
                 const struct dpl_log *log);

#endif
