#include "cli/options.h"

#include "cli/commands.h"
#include "dapple/param.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LIST_SIZE 512 /* bytes of a list of what is accepted */

static void set_defaults(struct options *options)
{
    *options = (struct options){.size = {1280, 720}, .against = DEFAULT_AGAINST};
    for (int i = 0; i < FLAG_COUNT; i++)
        if (flags[i].type == VALUE_NUMBER)
            *(double *)((char *)options + flags[i].offset) = flags[i].initial;
}

static bool reject(const struct flag *flag, const char *what, const char *text, struct program_log *log)
{
    char accepted[LIST_SIZE];
    flag_describe(flag, accepted, sizeof accepted);
    return fail_input(log, "%s: %s: \"%.80s\" (accepted: %s)", flag->name, what, text, accepted);
}

/* A decimal number that takes up the whole text; strtod() alone also takes blanks, nan, inf and hexadecimal. */
static bool read_number(const struct flag *flag, const char *text, double *number, struct program_log *log)
{
    const char *letters = flag->type == VALUE_NUMBER ? "+-.0123456789eE" : "+-0123456789";
    char *end;
    *number = strtod(text, &end);
    if (!*text || *end || text[strspn(text, letters)])
        return reject(flag, flag->type == VALUE_NUMBER ? "not a number" : "not a whole number", text, log);
    return (*number >= flag->minimum && *number <= flag->maximum) || reject(flag, "out of range", text, log);
}

static bool read_size(const struct flag *flag, const char *text, int size[2], struct program_log *log)
{
    const char *next = text;
    long sides[2];
    for (int i = 0; i < 2; i++) {
        size_t digits = strspn(next, "0123456789");
        if (digits == 0 || next[digits] != (i == 0 ? 'x' : '\0'))
            return reject(flag, "not a size", text, log);
        sides[i] = strtol(next, NULL, 10);
        next += digits + 1;
    }
    for (int i = 0; i < 2; i++) {
        if ((double)sides[i] < flag->minimum || (double)sides[i] > flag->maximum)
            return reject(flag, "out of range", text, log);
        size[i] = (int)sides[i];
    }
    return true;
}

static bool read_choice(const struct flag *flag, const char *text, int *choice, struct program_log *log)
{
    for (int i = 0; flag->choices[i]; i++) {
        if (!strcmp(text, flag->choices[i])) {
            *choice = i;
            return true;
        }
    }
    return reject(flag, "no such choice", text, log);
}

static bool read_setting(const struct flag *flag, char *text, struct options *options, struct program_log *log)
{
    struct setting setting = {flag->key, text};
    if (!flag->key) {
        char *equals = strchr(text, '=');
        if (!equals)
            return reject(flag, "no \"=\"", text, log);
        *equals = '\0';
        setting = (struct setting){text, equals + 1};
    }
    options->settings[options->setting_count++] = setting;
    return true;
}

static bool read_value(const struct flag *flag, char *text, struct options *options, struct program_log *log)
{
    void *place = (char *)options + flag->offset;
    double number = 0;
    switch (flag->type) {
    case VALUE_NONE:
        *(bool *)place = true;
        return true;
    case VALUE_TEXT:
        *(const char **)place = text;
        return *text || reject(flag, "empty", text, log);
    case VALUE_NUMBER:
        return read_number(flag, text, place, log);
    case VALUE_WHOLE:
        if (!read_number(flag, text, &number, log))
            return false;
        *(int *)place = (int)number;
        return true;
    case VALUE_CHOICE:
        return read_choice(flag, text, place, log);
    case VALUE_SIZE:
        return read_size(flag, text, place, log);
    case VALUE_SETTING:
        return read_setting(flag, text, options, log);
    }
    return false;
}

/* The i-th flag that the command takes. */
static const char *flag_name(const void *command, int i)
{
    for (int f = 0; f < FLAG_COUNT; f++)
        if (((const struct command *)command)->flags & FLAG_BIT(f) && i-- == 0)
            return flags[f].name;
    return NULL;
}

static bool refuse_flag(const struct command *command, const char *word, struct program_log *log)
{
    char accepted[LIST_SIZE], hint[64];
    size_t used = 0;
    dpl_hint(word, flag_name, command, hint, sizeof hint);
    for (int i = 0; i < FLAG_COUNT && used < sizeof accepted; i++)
        if (command->flags & FLAG_BIT(i))
            used += (size_t)snprintf(accepted + used, sizeof accepted - used, "%s%s", used ? ", " : "", flags[i].name);
    return fail_input(log, "%s: unknown flag: \"%.80s\" (%saccepted: %s)", command->name, word, hint, accepted);
}

/* The flag of that name, of `length` bytes, that the command takes; NULL: none. */
static const struct flag *find_flag(const struct command *command, const char *name, size_t length)
{
    for (int i = 0; i < FLAG_COUNT; i++) {
        const char *names[] = {flags[i].name, flags[i].brief};
        for (int n = 0; n < 2 && command->flags & FLAG_BIT(i); n++)
            if (names[n] && strlen(names[n]) == length && !memcmp(names[n], name, length))
                return flags + i;
    }
    return NULL;
}

/* Reads the flag at words[0]; returns how many words it took, 0 on failure. */
static int read_flag(struct options *options, const struct command *command, char **words, struct program_log *log)
{
    char *value = strchr(words[0], '=');
    const struct flag *flag = find_flag(command, words[0], value ? (size_t)(value - words[0]) : strlen(words[0]));
    int taken = 1;
    if (!flag)
        return refuse_flag(command, words[0], log);
    if (value && !flag->value)
        return fail_input(log, "%s: takes no value: \"%.80s\"", flag->name, value + 1);
    if (flag->value && !value && !words[1])
        return reject(flag, "a value is missing", words[0], log);
    if (value)
        value++;
    else if (flag->value)
        value = words[taken++];
    options->given |= FLAG_BIT(flag - flags);
    return read_value(flag, value, options, log) ? taken : 0;
}

bool options_read(struct options *options, const struct command *command, char **words, struct program_log *log)
{
    set_defaults(options);
    size_t count = 0;
    while (words[count])
        count++;
    options->settings = calloc(count + 1, sizeof *options->settings);
    if (!options->settings)
        return fail_work(log, "out of memory for %zu words", count);
    bool flags_end = false;
    while (*words) {
        if (!flags_end && !strcmp(*words, "--")) {
            flags_end = true;
            words++;
        } else if (!flags_end && (*words)[0] == '-' && (*words)[1]) {
            int taken = read_flag(options, command, words, log);
            if (!taken)
                return false;
            words += taken;
        } else if (options->operand && command->words > 1 && !options->prefix) {
            options->prefix = *words++;
        } else if (options->operand || !command->operand) {
            return fail_input(log, "%s: one word too many: \"%.80s\" (usage: dapple %s%s%s [flags])", command->name,
                              *words, command->name, command->operand ? " " : "",
                              command->operand ? command->operand : "");
        } else {
            options->operand = *words++;
        }
    }
    return true;
}

void options_finish(struct options *options)
{
    free(options->settings);
}
