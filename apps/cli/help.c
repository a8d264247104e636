#include "cli/commands.h"
#include "dapple/api.h"

#include <stdio.h>

static void print_overview(void)
{
    printf("dapple %s: sunlight through moving water\n\n"
           "usage: dapple COMMAND [SCENE] [flags]\n\ncommands:\n",
           DPL_VERSION);
    for (const struct command *command = commands; command->name; command++)
        printf("  %-9s %s\n", command->name, command->help);
    printf("\nSCENE is a scene file or the name of a built-in scene (`dapple list scenes`); without it: %s.\n"
           "`dapple help COMMAND` shows the flags of a command, `dapple --version` the version.\n\n"
           "examples:\n"
           "  dapple render -o water.png\n"
           "  dapple render collard-3 --frames 120 -o water.mp4\n"
           "  dapple map --set scene.depth=0.4 --time 2 -o caustics.exr\n\n"
           "Exit codes: 0 done, 1 could not, 2 wrong usage or input.\n",
           DEFAULT_SCENE);
}

/* ": a number from 0.01 to 1000 1/s (default 30)" and the like. */
static void print_accepted(const struct flag *flag, const struct command *command)
{
    char accepted[128];
    flag_describe(flag, accepted, sizeof accepted);
    if (flag->key)
        printf(": --set %s=%s", flag->key, flag->value);
    else if (flag->type != VALUE_NONE && flag->type != VALUE_TEXT && flag->type != VALUE_SETTING)
        printf(": %s", accepted);
    if (flag == flags + FLAG_FRAMES)
        printf(" (default %s)", command->frames);
    else if (flag->default_text)
        printf(" (default %s)", flag->default_text);
    else if (flag->type == VALUE_NUMBER)
        printf(" (default %g)", flag->initial);
    else if (flag->type == VALUE_CHOICE)
        printf(" (default %s)", flag->choices[0]);
}

static void print_flag(const struct flag *flag, const struct command *command)
{
    char names[40];
    snprintf(names, sizeof names, "%s%s%s%s%s", flag->brief ? flag->brief : "", flag->brief ? ", " : "", flag->name,
             flag->value ? " " : "", flag->value ? flag->value : "");
    printf("  %-23s %s", names, flag->help);
    print_accepted(flag, command);
    putchar('\n');
}

static void print_command(const struct command *command)
{
    printf("dapple %s: %s\n\nusage: dapple %s%s%s [flags]\n\n", command->name, command->help, command->name,
           command->operand ? " " : "", command->operand ? command->operand : "");
    if (*command->more)
        printf("%s\n", command->more);
    puts("flags:");
    for (int i = 0; i < FLAG_COUNT; i++)
        if (command->flags & FLAG_BIT(i))
            print_flag(flags + i, command);
    puts("\nexamples:");
    for (int i = 0; i < 2; i++)
        printf("  dapple %s\n", command->examples[i]);
}

bool command_help(const struct options *options, struct program_log *log)
{
    const struct command *command = options->operand ? command_find(options->operand) : NULL;
    if (options->operand && !command) {
        char names[128], hint[64];
        command_names(names, sizeof names);
        command_hint(options->operand, hint, sizeof hint);
        return fail_input(log, "help: no such command: \"%.80s\" (%saccepted: %s)", options->operand, hint, names);
    }
    if (command)
        print_command(command);
    else
        print_overview();
    return true;
}
