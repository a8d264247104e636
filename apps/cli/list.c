#include "cli/commands.h"
#include "cli/json.h"
#include "dapple/scene.h"

#include <string.h>

#define TEXT_SIZE 512 /* bytes of a value, or of what a value accepts */

/* A parameter as the three ways of writing it need it. */
struct entry {
    const struct dpl_section *section;
    const struct dpl_param *param;
    char initial[TEXT_SIZE], accepted[TEXT_SIZE];
};

static struct dpl_entry builtin_scene(int index)
{
    const struct dpl_builtin_scene *scene = dpl_builtin_scenes() + index;
    return (struct dpl_entry){.name = scene->name, .summary = scene->summary};
}

static const struct list {
    const char *name;
    struct dpl_entry (*entry)(int index);
} lists[] = {{"scenes", builtin_scene},
             {"waters", dpl_water_model},
             {"techniques", dpl_technique},
             {"looks", dpl_look},
             {"shapes", dpl_shape}};
enum { LIST_COUNT = sizeof lists / sizeof *lists };

static void list_text(const struct list *list)
{
    for (int i = 0; list->entry(i).name; i++) {
        struct dpl_entry entry = list->entry(i);
        printf("%-14s %s\n", entry.name, entry.summary);
        if (entry.source)
            printf("%-14s (%s)%s", "", entry.source, entry.physical ? "; physical" : "");
        if (entry.energy > 0)
            printf(", its mean within %g %%", entry.energy * 100);
        if (entry.source)
            printf("%s%s\n", entry.reflects ? "; also light thrown back" : "",
                   entry.refines ? "; refines step by step" : "");
    }
}

static void list_json(const struct list *list)
{
    struct json json = {.stream = stdout};
    json_open(&json, NULL, '{');
    json_open(&json, list->name, '[');
    for (int i = 0; list->entry(i).name; i++) {
        struct dpl_entry entry = list->entry(i);
        json_open(&json, NULL, '{');
        json_text(&json, "name", entry.name);
        json_text(&json, "summary", entry.summary);
        if (entry.source)
            json_text(&json, "source", entry.source);
        if (list->entry == dpl_technique) {
            json_bool(&json, "physical", entry.physical);
            if (entry.physical)
                json_number(&json, "energy", entry.energy);
            json_bool(&json, "reflects", entry.reflects);
            json_bool(&json, "refines", entry.refines);
        }
        json_close(&json, '}');
    }
    json_close(&json, ']');
    json_close(&json, '}');
    putchar('\n');
}

/* Whether the value's name starts so; NULL: every name does. */
static bool has_prefix(const struct dpl_section *section, const struct dpl_param *param, const char *prefix)
{
    char key[TEXT_SIZE];
    snprintf(key, sizeof key, "%s.%s", section->name, param->name);
    return !prefix || !strncmp(key, prefix, strlen(prefix));
}

static int count_entries(const struct dpl_section *section, const char *prefix)
{
    int count = 0;
    for (const struct dpl_param *param = section->params; param->name; param++)
        count += has_prefix(section, param, prefix);
    return count;
}

static void text_entry(const struct entry *entry)
{
    char key[TEXT_SIZE];
    snprintf(key, sizeof key, "%s.%s", entry->section->name, entry->param->name);
    printf("  %-28s %s\n  %-28s %s; default %s\n", key, entry->param->help, "", entry->accepted,
           *entry->initial ? entry->initial : "empty");
}

/* A cell of a table: its column ends at "|". */
static void markdown_cell(const char *text)
{
    fputs("| ", stdout);
    for (; *text; text++)
        printf("%s%c", *text == '|' ? "\\" : "", *text);
    putchar(' ');
}

static void markdown_entry(const struct entry *entry)
{
    char key[TEXT_SIZE];
    snprintf(key, sizeof key, "`%s`", entry->param->name);
    markdown_cell(key);
    snprintf(key, sizeof key, "`%.500s`", entry->initial);
    markdown_cell(*entry->initial ? key : "");
    markdown_cell(entry->accepted);
    markdown_cell(entry->param->help);
    puts("|");
}

static void json_entry(const struct entry *entry, struct json *json)
{
    char key[TEXT_SIZE];
    snprintf(key, sizeof key, "%s.%s", entry->section->name, entry->param->name);
    json_open(json, NULL, '{');
    json_text(json, "key", key);
    json_text(json, "default", entry->initial);
    json_text(json, "accepted", entry->accepted);
    json_text(json, "unit", entry->param->unit);
    json_text(json, "help", entry->param->help);
    json_close(json, '}');
}

static void list_section(const struct dpl_section *section, const struct options *options, struct json *json)
{
    if (count_entries(section, options->prefix) == 0)
        return;
    if (options->markdown)
        printf("\n## [%s]\n\n%s\n\n| key | default | accepted | what it is |\n|---|---|---|---|\n", section->name,
               section->help);
    else if (!options->json)
        printf("[%s] %s\n", section->name, section->help);
    for (const struct dpl_param *param = section->params; param->name; param++) {
        struct entry entry = {.section = section, .param = param};
        if (!has_prefix(section, param, options->prefix))
            continue;
        dpl_param_format(param, section->values, entry.initial, sizeof entry.initial);
        dpl_param_describe(param, entry.accepted, sizeof entry.accepted);
        if (options->markdown)
            markdown_entry(&entry);
        else if (options->json)
            json_entry(&entry, json);
        else
            text_entry(&entry);
    }
    if (!options->markdown && !options->json)
        putchar('\n');
}

/* Some sections come into being when one of their values is set: here one of each kind, with its defaults. */
static bool make_sections(struct dpl_scene *scene)
{
    static const char *const names[] = {"wave.1.phase", "camera.1.time", "object.NAME.seed"};
    char value[TEXT_SIZE];
    bool ok = true;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        ok = ok && dpl_scene_get(scene, names[i], value, sizeof value) && dpl_scene_set(scene, names[i], value);
    return ok;
}

static void list_sections(const struct dpl_scene *scene, const struct options *options)
{
    struct json json = {.stream = stdout};
    if (options->markdown)
        puts("# Values of a scene\n\nIn a scene file: `key = value` below `[section]`. On the command line: "
             "`--set section.key=value`.\nWaves are `[wave.1]`, `[wave.2]` and so on, keys of the camera's path "
             "`[camera.1]` and so on;\nNAME is any word of letters, digits and `-`.");
    if (options->json) {
        json_open(&json, NULL, '{');
        json_open(&json, "params", '[');
    }
    for (int i = 0; dpl_scene_section(scene, i).name; i++) {
        struct dpl_section section = dpl_scene_section(scene, i);
        list_section(&section, options, &json);
    }
    if (options->json) {
        json_close(&json, ']');
        json_close(&json, '}');
        putchar('\n');
    }
}

static bool list_params(const struct options *options, struct program_log *log)
{
    struct dpl_scene *scene = dpl_scene_create(&log->log);
    bool ok = scene && make_sections(scene);
    int count = 0;
    for (int i = 0; ok && dpl_scene_section(scene, i).name; i++) {
        struct dpl_section section = dpl_scene_section(scene, i);
        count += count_entries(&section, options->prefix);
    }
    if (ok && count == 0)
        ok = fail_input(log, "list: no value's name starts so: \"%.80s\" (accepted: as in \"sun.\" or \"water.a\")",
                        options->prefix);
    else if (ok)
        list_sections(scene, options);
    dpl_scene_destroy(scene);
    return ok;
}

static const char *list_name(const void *user, int i)
{
    (void)user;
    return i < LIST_COUNT ? lists[i].name : i == LIST_COUNT ? "params" : NULL;
}

bool command_list(const struct options *options, struct program_log *log)
{
    const char *what = options->operand ? options->operand : "";
    bool params = !strcmp(what, "params");
    if (options->markdown && (!params || options->json))
        return fail_input(log, "list: --markdown: only for params, and without --json");
    if (options->prefix && !params)
        return fail_input(log, "list: one word too many: \"%.80s\" (only params are chosen by how they start)",
                          options->prefix);
    if (params)
        return list_params(options, log);
    for (int i = 0; i < LIST_COUNT; i++) {
        if (!strcmp(what, lists[i].name)) {
            (options->json ? list_json : list_text)(lists + i);
            return true;
        }
    }
    static const char accepted[] = "scenes, waters, techniques, looks, shapes, params";
    char hint[64];
    dpl_hint(what, list_name, NULL, hint, sizeof hint);
    if (!*what)
        return fail_input(log, "list: of what? (accepted: %s)", accepted);
    return fail_input(log, "list: no such list: \"%.80s\" (%saccepted: %s)", what, hint, accepted);
}
