/* The program `dapple`: finds the command, reads its flags, runs it. */
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "dapple/api.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

/* Standard files that the caller left closed must not become files that are opened later: printing would end up in
 * them. They are opened the wrong way round, so that using them still fails. */
static void occupy_standard_files(void)
{
    for (int file = 0; file <= 2; file++)
        if (fcntl(file, F_GETFD) < 0)
            open("/dev/null", file == 0 ? O_WRONLY : O_RDONLY);
}

static bool run_command(const struct command *command, char **words, struct program_log *log)
{
    struct options options;
    bool ok = options_read(&options, command, words, log);
    if (ok && options.help)
        ok = command_help(&(struct options){.operand = command->name}, log);
    else if (ok)
        ok = command->run(&options, log);
    options_finish(&options);
    return ok;
}

static bool run(char **words, struct program_log *log)
{
    if (!*words || !strcmp(*words, "--help") || !strcmp(*words, "-h"))
        return command_help(&(struct options){0}, log);
    if (!strcmp(*words, "--version")) {
        printf("dapple %s\n", DPL_VERSION);
        return true;
    }
    const struct command *command = command_find(*words);
    if (command)
        return run_command(command, words + 1, log);
    char names[128], hint[64];
    command_names(names, sizeof names);
    command_hint(*words, hint, sizeof hint);
    return fail_input(log, "unknown command: \"%.80s\" (%saccepted: %s, --version)", *words, hint, names);
}

int main(int argc, char **argv)
{
    struct program_log log;
    occupy_standard_files();
    signal(SIGPIPE, SIG_IGN); /* a reader that went away is an error of write(), not the end */
    interrupt_install();
    log_begin(&log);
    bool ok = run(argc > 0 ? argv + 1 : argv, &log);
    bool printed = !ferror(stdout);
    if (fclose(stdout) != 0 || !printed)
        ok = fail_work(&log, "the result cannot be written to standard output: %s", strerror(errno));
    if (ok)
        return EXIT_DONE;
    return log.exit_code == EXIT_DONE ? EXIT_COULD_NOT : (int)log.exit_code;
}
