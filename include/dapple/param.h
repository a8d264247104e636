/* dapple/param.h: one description for every value that a user can set.
 *
 * A section of a scene (`[sun]`, `[multi-sample]`, …) is a C struct and a table of these descriptions, one for each
 * member. Checks of range, scene text, `--set`, the window's controls and the reference in the documentation all
 * read the same table. */
#ifndef DAPPLE_PARAM_H
#define DAPPLE_PARAM_H

#include "dapple/log.h"

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define DPL_PARAM_TEXT_SIZE 160 /* bytes of a text value, its ending zero included; a line of scene text holds it */

enum dpl_param_type {
    DPL_PARAM_FLOAT,  /* double[count] */
    DPL_PARAM_INT,    /* int[count] */
    DPL_PARAM_BOOL,   /* bool; text: true false yes no on off 1 0 */
    DPL_PARAM_CHOICE, /* int, an index into the choices; text: the choice's name */
    DPL_PARAM_COLOR,  /* double[3], linear red green blue */
    DPL_PARAM_TEXT, /* char[DPL_PARAM_TEXT_SIZE]: the name of a file or folder, in a scene's file as from its folder */
};

struct dpl_param {
    const char *name; /* NULL ends a table */
    enum dpl_param_type type;
    int count;               /* numbers in the value: 1 to 3 */
    size_t offset;           /* of the value in the section's struct, bytes */
    double minimum, maximum; /* accepted range of each number, both ends included */
    double initial[3];       /* default value */
    const char *unit;        /* "m", "degrees", …; "" for a plain number */
    const char *help;        /* one line */
    /* CHOICE: the i-th name, NULL past the last. Other types: NULL. */
    const char *(*choice)(int i);
};

/* Writes the value as text that dpl_scene_set() reads back to the same value. `values` is the section's struct.
 * Returns false where `size` is too small. */
DPL_API bool dpl_param_format(const struct dpl_param *param, const void *values, char *text, size_t size);

/* Writes what the parameter accepts, for people: "number from 0 to 90 degrees", "one of sines, collard". Cut off at
 * `size`. */
DPL_API void dpl_param_describe(const struct dpl_param *param, char *text, size_t size);

/* Writes `did you mean "render"? ` where one of the names is what a mistyped word is likely to stand for, else nothing.
 * `name`: the i-th, NULL past the last. */
DPL_API void dpl_hint(const char *word, const char *(*name)(const void *user, int i), const void *user, char *text,
                      size_t size);

#ifdef __cplusplus
}
#endif

#endif
