/* Scene text: reading, setting one value. */
#include "base/file.h"
#include "base/log.h"
#include "base/resource.h"
#include "scene/scene.h"

#include <ini.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SCENE_TEXT_MAX (1 << 20) /* bytes */
#define VALUE_SIZE 512           /* bytes of one value as text */
#define PLACE_SIZE 512           /* bytes of "file:line: section.key" */
#define HINT_SIZE 64             /* bytes of "did you mean …" */
#define LINE_SIZE 200            /* bytes of a line: what Debian's build of the parser takes */

#define MALFORMED "neither a [section], nor key = value, nor a comment"

/* Scene text on its way through the INI parser. */
struct reading {
    struct dpl_scene *scene;
    const char *name;       /* of the file, for messages */
    size_t folder;          /* bytes of `name` that are the file's folder; 0: names of files are the shell's */
    const char *next, *end; /* text not read yet */
    int line;               /* of the line read last, from 1 */
    bool failed;
};

/* "one of [scene], [sun], …" */
static void list_sections(const struct dpl_scene *scene, char *text, size_t size)
{
    size_t used = 0;
    for (int i = 0; dpl_scene_section(scene, i).name && used < size; i++) {
        const char *name = dpl_scene_section(scene, i).name;
        if (!scene_numbered_find(scene, name).name && strncmp(name, "object.", 7))
            used += (size_t)snprintf(text + used, size - used, "%s, ", name);
    }
    if (used < size)
        used += (size_t)snprintf(text + used, size - used, "object.NAME, ");
    if (used < size)
        scene_numbered_list(text + used, size - used);
}

static void list_keys(const struct dpl_param *params, char *text, size_t size)
{
    size_t used = 0;
    for (; params->name && used < size; params++)
        used += (size_t)snprintf(text + used, size - used, "%s%s", used ? ", " : "", params->name);
}

/* True for "object.NAME", NAME of letters, digits and `-`. */
static bool names_object(const char *section)
{
    static const char accepted[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-";
    size_t length = strlen(section);
    return !strncmp(section, "object.", 7) && length > 7 && length < SCENE_OBJECT_NAME_SIZE &&
           strspn(section + 7, accepted) == length - 7;
}

/* The section of that name, one of those with numbers or an object's also where it is not there yet; NULL-named where
 * there is none. */
static struct dpl_section find_section(const struct dpl_scene *scene, const char *name)
{
    struct dpl_section section = scene_numbered_find(scene, name);
    for (int i = 0; !section.name; i++) {
        section = dpl_scene_section(scene, i);
        if (!section.name && names_object(name) && scene->object_count < SCENE_OBJECTS_MAX)
            return (struct dpl_section){name, "", scene_object_params, (void *)(scene->objects + scene->object_count),
                                        true};
        if (!section.name)
            return section;
        if (strcmp(section.name, name))
            section.name = NULL;
    }
    return section;
}

static const char *section_name(const void *scene, int i)
{
    return dpl_scene_section(scene, i).name;
}

static const char *key_name(const void *params, int i)
{
    return ((const struct dpl_param *)params)[i].name;
}

static const char *builtin_name(const void *scenes, int i)
{
    return ((const struct dpl_builtin_scene *)scenes)[i].name;
}

/* Says that there is no section of that name; `where` opens the message. */
static bool fail_section(const struct dpl_scene *scene, const char *where, const char *name)
{
    char accepted[2 * VALUE_SIZE], hint[HINT_SIZE];
    if (names_object(name))
        return base_fail(scene->log, DPL_REASON_LIMIT, "%s: too many objects: \"%s\" (accepted: at most %d)", where,
                         name, SCENE_OBJECTS_MAX);
    if (!strncmp(name, "object", strlen("object")))
        return base_fail(scene->log, DPL_REASON_UNKNOWN_SECTION,
                         "%s: no name of an object: \"%s\" (accepted: object.NAME, a NAME of letters, digits and -)",
                         where, name);
    list_sections(scene, accepted, sizeof accepted);
    dpl_hint(name, section_name, scene, hint, sizeof hint);
    return base_fail(scene->log, DPL_REASON_UNKNOWN_SECTION, "%s: no such section: \"%s\" (%saccepted: %s)", where,
                     name, hint, accepted);
}

/* A section that need not be there is there from the moment that one of its values is set. */
static void make_present(struct dpl_scene *scene, const struct dpl_section *section)
{
    int next = scene->object_count;
    scene_numbered_mark(scene, section->name, true);
    if (next < SCENE_OBJECTS_MAX && section->values == scene->objects + next) {
        snprintf(scene->object_names[next], sizeof scene->object_names[next], "%s", section->name);
        scene->object_count++;
    }
}

/* Finds the value's description. `place` opens the message: "pool.ini:12: " or "". */
static const struct dpl_param *find_value(const struct dpl_scene *scene, const char *place, const char *section_name,
                                          const char *key, struct dpl_section *section)
{
    char accepted[VALUE_SIZE], where[PLACE_SIZE], hint[HINT_SIZE];
    *section = find_section(scene, section_name);
    if (!section->name) {
        snprintf(where, sizeof where, "%.420s%.60s.%.30s", place, section_name, key);
        fail_section(scene, where, section_name);
        return NULL;
    }
    const struct dpl_param *param = param_find(section->params, key);
    if (!param) {
        list_keys(section->params, accepted, sizeof accepted);
        dpl_hint(key, key_name, section->params, hint, sizeof hint);
        base_fail(scene->log, DPL_REASON_UNKNOWN_KEY, "%s%s.%s: no such key: \"%s\" (%saccepted: %s)", place,
                  section_name, key, key, hint, accepted);
    }
    return param;
}

static bool assign(struct dpl_scene *scene, const char *place, const char *section_name, const char *key,
                   const char *value)
{
    struct dpl_section section;
    const struct dpl_param *param = find_value(scene, place, section_name, key, &section);
    char where[PLACE_SIZE];
    snprintf(where, sizeof where, "%.420s%.60s.%.30s", place, section_name, key);
    if (!param || !param_parse(param, section.values, value, where, scene->log))
        return false;
    make_present(scene, &section);
    return true;
}

/* Splits "section.key" at its last dot. */
static bool split_key(const struct dpl_scene *scene, const char *name, char section[64], const char **key)
{
    const char *dot = strrchr(name, '.');
    if (!dot || dot == name || !dot[1] || dot - name >= 64)
        return base_fail(scene->log, DPL_REASON_UNKNOWN_KEY,
                         "%.80s: not the name of a value (accepted: section.key, as in sun.elevation)", name);
    memcpy(section, name, (size_t)(dot - name));
    section[dot - name] = '\0';
    *key = dot + 1;
    return true;
}

bool dpl_scene_set(struct dpl_scene *scene, const char *name, const char *value)
{
    char section[64];
    const char *key = NULL;
    return split_key(scene, name, section, &key) && assign(scene, "", section, key, value);
}

bool dpl_scene_get(const struct dpl_scene *scene, const char *name, char *value, size_t size)
{
    char section_name[64];
    const char *key = NULL;
    struct dpl_section section;
    if (!split_key(scene, name, section_name, &key))
        return false;
    const struct dpl_param *param = find_value(scene, "", section_name, key, &section);
    if (!param)
        return false;
    return dpl_param_format(param, section.values, value, size) ||
           base_fail(scene->log, DPL_REASON_LIMIT, "%s: the value does not fit into %zu bytes", name, size);
}

/* Takes an object away; the others keep their order. */
static bool remove_object(struct dpl_scene *scene, const char *name)
{
    int index = 0;
    while (index < scene->object_count && strcmp(scene->object_names[index], name))
        index++;
    if (index == scene->object_count)
        return false;
    size_t after = (size_t)(--scene->object_count - index);
    memmove(scene->objects + index, scene->objects + index + 1, after * sizeof *scene->objects);
    memmove(scene->object_names + index, scene->object_names + index + 1, after * sizeof *scene->object_names);
    param_defaults(scene_object_params, scene->objects + scene->object_count);
    return true;
}

bool dpl_scene_remove(struct dpl_scene *scene, const char *section)
{
    char accepted[VALUE_SIZE];
    if (scene_numbered_mark(scene, section, false) || remove_object(scene, section))
        return true;
    scene_numbered_list(accepted, sizeof accepted);
    return base_fail(scene->log, DPL_REASON_UNKNOWN_SECTION,
                     "%.80s: cannot be taken away (accepted: %s, the name of an object that is there)", section,
                     accepted);
}

static void fail_line(struct reading *reading, const char *what)
{
    if (!reading->failed)
        base_fail(reading->scene->log, DPL_REASON_SYNTAX, "%s:%d: %s", reading->name, reading->line, what);
    reading->failed = true;
}

/* Where a line's text ends: before a comment, which starts the line or follows a blank. */
static const char *text_end(const char *start, const char *stop)
{
    for (const char *c = start; c < stop; c++)
        if ((*c == '#' || *c == ';') && (c == start || c[-1] == ' ' || c[-1] == '\t'))
            return c;
    return stop;
}

/* The parser itself says nothing of a section without keys, nor of what follows its bracket. */
static void check_section(struct reading *reading, const char *line)
{
    char name[LINE_SIZE], where[PLACE_SIZE];
    size_t length = strcspn(line, "]");
    if (!line[length] || line[length + 1 + strspn(line + length + 1, " \t\r\n")]) {
        fail_line(reading, MALFORMED);
        return;
    }
    snprintf(name, sizeof name, "%.*s", (int)length, line);
    if (find_section(reading->scene, name).name)
        return;
    snprintf(where, sizeof where, "%.400s:%d", reading->name, reading->line);
    fail_section(reading->scene, where, name);
    reading->failed = true;
}

/* Hands the parser one line, checked, without leading blanks (it would take them for a continued value) and without its
 * comment. */
static char *next_line(char *line, int size, void *user)
{
    struct reading *reading = user;
    if (reading->next == reading->end || reading->failed)
        return NULL;
    const char *start = reading->next, *stop = memchr(start, '\n', (size_t)(reading->end - start));
    stop = stop ? stop : reading->end;
    reading->next = stop < reading->end ? stop + 1 : stop;
    if (reading->line++ == 0 && stop - start >= 3 && !memcmp(start, "\xEF\xBB\xBF", 3))
        start += 3; /* byte order mark */
    while (start < stop && strchr(" \t\r", *start))
        start++;
    size_t length = (size_t)(text_end(start, stop) - start), most = size < LINE_SIZE ? (size_t)size : LINE_SIZE;
    if (length + 2 > most) {
        fail_line(reading, "line too long (at most 197 bytes)");
        return NULL;
    }
    memcpy(line, start, length);
    strcpy(line + length, "\n");
    if (*line == '[')
        check_section(reading, line + 1);
    else if (length > 0 && !strchr(line, '='))
        fail_line(reading, MALFORMED);
    return reading->failed ? NULL : line;
}

/* The name of a file, which was just read, stands for one in the folder of the scene's, unless it starts at the root.
 */
static bool put_in_folder(const struct reading *reading, const char *place, const char *section_name, const char *key)
{
    struct dpl_section section = find_section(reading->scene, section_name);
    const struct dpl_param *param = param_find(section.params, key);
    char *value = (char *)section.values + param->offset;
    if (param->type != DPL_PARAM_TEXT || !*value || *value == '/' || reading->folder == 0)
        return true;
    size_t length = strlen(value);
    if (reading->folder + length >= DPL_PARAM_TEXT_SIZE)
        return base_fail(reading->scene->log, DPL_REASON_RANGE,
                         "%s%s.%s: too long with the scene's folder before it: \"%s\" (accepted: %d bytes at most)",
                         place, section_name, key, value, DPL_PARAM_TEXT_SIZE - 1);
    memmove(value + reading->folder, value, length + 1);
    memcpy(value, reading->name, reading->folder);
    return true;
}

/* Called by the parser with each value. */
static int take_value(void *user, const char *section, const char *key, const char *value)
{
    struct reading *reading = user;
    if (!*section)
        fail_line(reading, "a value outside of any section (accepted: [section] lines first)");
    if (reading->failed)
        return 1;
    char place[PLACE_SIZE];
    snprintf(place, sizeof place, "%.400s:%d: ", reading->name, reading->line);
    reading->failed = !assign(reading->scene, place, section, key, value ? value : "") ||
                      !put_in_folder(reading, place, section, key);
    return 1;
}

static bool parse(struct dpl_scene *scene, const char *name, size_t folder, const char *text, size_t length)
{
    if (memchr(text, '\0', length))
        return base_fail(scene->log, DPL_REASON_FILE_FORMAT, "%s: is not scene text: it contains zero bytes", name);
    struct reading reading = {.scene = scene, .name = name, .folder = folder, .next = text, .end = text + length};
    int line = ini_parse_stream(next_line, &reading, take_value, &reading);
    if (line != 0 && !reading.failed) {
        reading.line = line;
        fail_line(&reading, MALFORMED);
    }
    return !reading.failed;
}

static bool replace(struct dpl_scene *scene, const char *name, size_t folder, const char *text, size_t length)
{
    struct dpl_scene *fresh = dpl_scene_create(scene->log);
    bool ok = fresh && parse(fresh, name, folder, text, length);
    if (ok) {
        struct dpl_scene old = *scene;
        *scene = *fresh;
        *fresh = old;
    }
    dpl_scene_destroy(fresh);
    return ok;
}

bool dpl_scene_read(struct dpl_scene *scene, const char *name, const char *text, size_t length)
{
    return replace(scene, name, 0, text, length);
}

static const struct dpl_builtin_scene *find_builtin(const char *name)
{
    for (const struct dpl_builtin_scene *builtin = dpl_builtin_scenes(); builtin->name; builtin++)
        if (!strcmp(builtin->name, name))
            return builtin;
    return NULL;
}

bool dpl_scene_load(struct dpl_scene *scene, const char *path_or_name)
{
    const struct dpl_builtin_scene *builtin = find_builtin(path_or_name);
    if (builtin && !file_exists(path_or_name))
        return dpl_scene_read(scene, builtin->name, builtin->text, strlen(builtin->text));
    if (!file_exists(path_or_name)) {
        char hint[HINT_SIZE];
        dpl_hint(path_or_name, builtin_name, dpl_builtin_scenes(), hint, sizeof hint);
        return base_fail(scene->log, DPL_REASON_FILE_READ,
                         "%s: neither a file nor a built-in scene (%ssee `dapple list scenes`)", path_or_name, hint);
    }
    size_t length;
    char *text = file_read(path_or_name, SCENE_TEXT_MAX, &length, scene->log);
    bool ok = text && replace(scene, path_or_name, file_folder(path_or_name), text, length);
    free(text);
    return ok;
}
