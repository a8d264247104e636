/* Scene text: writing. */
#include "base/file.h"
#include "base/log.h"
#include "scene/scene.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define VALUE_SIZE 512 /* bytes of one value as text */

static bool is_default(const struct dpl_section *section)
{
    char now[VALUE_SIZE], initial[VALUE_SIZE];
    union {
        double align;
        char bytes[4096];
    } defaults;
    param_defaults(section->params, &defaults);
    for (const struct dpl_param *param = section->params; param->name; param++) {
        dpl_param_format(param, section->values, now, sizeof now);
        dpl_param_format(param, &defaults, initial, sizeof initial);
        if (strcmp(now, initial))
            return false;
    }
    return true;
}

/* A file's name as the scene in `path` has to write it, so that it is found again from there. */
static bool name_from(const char *path, char *name, const struct dpl_log *log)
{
    size_t folder = file_folder(path);
    char whole[PATH_MAX];
    if (folder > 0 && !strncmp(name, path, folder)) {
        memmove(name, name + folder, strlen(name + folder) + 1);
        return true;
    }
    if (!*name || *name == '/' || folder == 0)
        return true;
    size_t used = getcwd(whole, sizeof whole) ? strlen(whole) : sizeof whole;
    if (used + strlen(name) + 2 > DPL_PARAM_TEXT_SIZE)
        return base_fail(log, DPL_REASON_LIMIT, "%s: the whole name of a file is too long for scene text: \"%s\"", path,
                         name);
    snprintf(whole + used, sizeof whole - used, "/%s", name);
    if (!param_fits_scene_text(whole))
        return base_fail(log, DPL_REASON_VALUE, "%s: the whole name of a file cannot stand in scene text: \"%s\"", path,
                         whole);
    strcpy(name, whole);
    return true;
}

static bool write_section(FILE *stream, const struct dpl_section *section, const char *path, const struct dpl_log *log)
{
    fprintf(stream, "[%s]\n", section->name);
    for (const struct dpl_param *param = section->params; param->name; param++) {
        char value[VALUE_SIZE];
        dpl_param_format(param, section->values, value, sizeof value);
        if (param->type == DPL_PARAM_TEXT && !name_from(path, value, log))
            return false;
        fprintf(stream, "%s = %s\n", param->name, value);
    }
    fputc('\n', stream);
    return true;
}

bool dpl_scene_save(const struct dpl_scene *scene, const char *path)
{
    struct file_writer writer;
    if (!file_begin(&writer, path, scene->log))
        return false;
    bool ok = true;
    for (int i = 0; ok && dpl_scene_section(scene, i).name; i++) {
        struct dpl_section section = dpl_scene_section(scene, i);
        if (section.active || scene_numbered_find(scene, section.name).name || !is_default(&section))
            ok = write_section(writer.stream, &section, path, scene->log);
    }
    return file_end(&writer, ok, scene->log);
}
