/* cli/flags.h: every flag of every command, once: its name, what it accepts, its default, and where its value goes. */
#ifndef CLI_FLAGS_H
#define CLI_FLAGS_H

#include <stddef.h>

enum flag_id {
    FLAG_OUTPUT,
    FLAG_SET,
    FLAG_TIME,
    FLAG_FRAMES,
    FLAG_FPS,
    FLAG_SIZE,
    FLAG_MAP,
    FLAG_TECHNIQUE,
    FLAG_AGAINST,
    FLAG_LOOK,
    FLAG_SEED,
    FLAG_DEVICE,
    FLAG_BITS,
    FLAG_WHITE,
    FLAG_SECONDS,
    FLAG_SLICE,
    FLAG_SHADERS,
    FLAG_MARKDOWN,
    FLAG_JSON,
    FLAG_QUIET,
    FLAG_HELP,
    FLAG_COUNT,
};

/* A set of flags is the sum of these. */
#define FLAG_BIT(id) (1u << (id))

enum flag_type {
    VALUE_NONE,    /* bool: given or not */
    VALUE_TEXT,    /* const char * */
    VALUE_NUMBER,  /* double */
    VALUE_WHOLE,   /* int */
    VALUE_CHOICE,  /* int, an index into the choices */
    VALUE_SIZE,    /* int[2], width and height */
    VALUE_SETTING, /* one more entry of options.settings */
};

struct flag {
    const char *name;  /* "--time" */
    const char *brief; /* "-o"; NULL: none */
    const char *value; /* what stands for the value in help; NULL: takes none */
    const char *help;
    enum flag_type type;
    size_t offset;            /* of the value in struct options */
    double minimum, maximum;  /* NUMBER, WHOLE, SIZE: accepted, both ends included */
    double initial;           /* NUMBER, WHOLE: default */
    const char *unit;         /* NULL: a plain number */
    const char *choices[4];   /* CHOICE: ends with NULL; the first is the default */
    const char *key;          /* SETTING: the scene's value it sets; NULL: it stands before a "=" in the text */
    const char *default_text; /* for help where the default is not simply `initial`; NULL: none */
};
extern const struct flag flags[FLAG_COUNT];

/* Writes what the flag accepts, for people. Cut off at `size`. */
void flag_describe(const struct flag *flag, char *text, size_t size);

#endif
