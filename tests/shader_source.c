/* shader_source FILE gl33|es30|gl43|es31 vertex|fragment|compute|geometry [FOLDER]: writes the text of one stage as the
 * library compiles it, from the shaders built in or those in FOLDER. For shaders.py. */
#include "gpu/program.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void print_message(void *user, enum dpl_log_level level, enum dpl_reason reason, const char *text)
{
    (void)user, (void)level, (void)reason;
    fprintf(stderr, "%s\n", text);
}

static const char *const dialects[] = {
    [PROGRAM_GL33] = "gl33", [PROGRAM_ES30] = "es30", [PROGRAM_GL43] = "gl43", [PROGRAM_ES31] = "es31", NULL};
static const char *const stages[] = {[PROGRAM_VERTEX] = "vertex",
                                     [PROGRAM_FRAGMENT] = "fragment",
                                     [PROGRAM_COMPUTE] = "compute",
                                     [PROGRAM_GEOMETRY] = "geometry",
                                     NULL};

/* The place of a word in a list; the first where it is not there. */
static int find(const char *const *words, const char *word)
{
    for (int i = 0; words[i]; i++)
        if (!strcmp(words[i], word))
            return i;
    return 0;
}

int main(int count, char **arguments)
{
    if (count < 4) {
        fprintf(stderr, "usage: shader_source FILE gl33|es30|gl43|es31 vertex|fragment|compute|geometry [FOLDER]\n");
        return 2;
    }
    const struct dpl_log log = {.write = print_message};
    enum program_dialect dialect = (enum program_dialect)find(dialects, arguments[2]);
    enum program_stage stage = (enum program_stage)find(stages, arguments[3]);
    char *source = program_source(arguments[1], arguments[4], dialect, stage, "", &log);
    if (!source)
        return 1;
    fputs(source, stdout);
    free(source);
    return 0;
}
