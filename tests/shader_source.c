/* shader_source FILE gl33|es30 vertex|fragment [FOLDER]: writes the text of one stage as the library compiles it, from
 * the shaders built in or those in FOLDER. For shaders.py. */
#include "gpu/program.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void print_message(void *user, enum dpl_log_level level, enum dpl_reason reason, const char *text)
{
    (void)user, (void)level, (void)reason;
    fprintf(stderr, "%s\n", text);
}

int main(int count, char **arguments)
{
    if (count < 4) {
        fprintf(stderr, "usage: shader_source FILE gl33|es30 vertex|fragment [FOLDER]\n");
        return 2;
    }
    const struct dpl_log log = {.write = print_message};
    enum program_dialect dialect = !strcmp(arguments[2], "es30") ? PROGRAM_ES30 : PROGRAM_GL33;
    char *source = program_source(arguments[1], arguments[4], dialect, !strcmp(arguments[3], "fragment"), "", &log);
    if (!source)
        return 1;
    fputs(source, stdout);
    free(source);
    return 0;
}
