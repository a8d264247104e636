/* cli/options.h: what the user asked for. */
#ifndef CLI_OPTIONS_H
#define CLI_OPTIONS_H

#include "cli/flags.h"
#include "cli/log.h"

#include <stdbool.h>

#define FRAMES_MAX 100000
#define DEFAULT_AGAINST "reference"

struct command;

/* A value of the scene that the command line changes. */
struct setting {
    const char *key, *value;
};

struct options {
    const char *operand; /* the scene, or what to list or explain; NULL: none */
    const char *prefix;  /* of what is listed; NULL: all */
    struct setting *settings;
    int setting_count;
    const char *output, *shaders; /* NULL: not given */
    const char *against;          /* name of a technique */
    const char *look;             /* to compare with; NULL: not given */
    double time, fps, white, seconds;
    int frames; /* 0: not given */
    int slice;
    int size[2]; /* width and height, pixels */
    int device;  /* enum dpl_device */
    int bits;    /* 0: 8, 1: 16 */
    bool markdown, json, quiet, help;
    unsigned given; /* FLAG_BIT of each flag that was given */
};

/* Reads the words after the command's name. On failure too, options_finish() frees what was made. Text points into the
 * words, whose "=" of a flag are replaced by zeros. */
bool options_read(struct options *options, const struct command *command, char **words, struct program_log *log);
void options_finish(struct options *options);

#endif
