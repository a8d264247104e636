/* cli/commands.h: every command, once: what `dapple help` says of it, the flags it takes, and what it does. */
#ifndef CLI_COMMANDS_H
#define CLI_COMMANDS_H

#include "cli/options.h"

#define DEFAULT_SCENE "lagoon"

struct command {
    const char *name;        /* NULL ends the table */
    const char *operand;     /* the word that may follow, for help; NULL: none */
    int words;               /* how many may follow, where that is not one */
    const char *help;        /* one line */
    const char *more;        /* what help says besides; lines end with a line feed */
    const char *examples[2]; /* what follows `dapple ` */
    const char *frames;      /* default of --frames, for help; NULL: does not take it */
    unsigned flags;          /* FLAG_BIT of those it takes */
    /* Returns false after the reason was logged. */
    bool (*run)(const struct options *options, struct program_log *log);
};
extern const struct command commands[];

/* The command of that name; NULL: none. */
const struct command *command_find(const char *name);
/* `did you mean "render"? `, or nothing: dpl_hint(). */
void command_hint(const char *word, char *text, size_t size);
/* "render, map, …" */
void command_names(char *text, size_t size);

bool command_render(const struct options *options, struct program_log *log);
bool command_map(const struct options *options, struct program_log *log);
bool command_surface(const struct options *options, struct program_log *log);
bool command_compare(const struct options *options, struct program_log *log);
bool command_bench(const struct options *options, struct program_log *log);
bool command_view(const struct options *options, struct program_log *log);
bool command_list(const struct options *options, struct program_log *log);
bool command_info(const struct options *options, struct program_log *log);
bool command_help(const struct options *options, struct program_log *log);

#endif
