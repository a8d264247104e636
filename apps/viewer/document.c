#include "viewer/document.h"

#include <stdio.h>
#include <string.h>

/* Sets one value of a section as it is in the other scene. */
static bool copy_value(struct dpl_scene *to, const struct dpl_scene *from, const char *section, const char *key)
{
    char name[128], value[2 * DPL_PARAM_TEXT_SIZE];
    snprintf(name, sizeof name, "%s.%s", section, key);
    return dpl_scene_get(from, name, value, sizeof value) && dpl_scene_set(to, name, value);
}

static bool copy_scene(struct dpl_scene *to, const struct dpl_scene *from)
{
    if (!dpl_scene_read(to, "empty scene", "", 0))
        return false;
    for (int i = 0; dpl_scene_section(from, i).name; i++) {
        struct dpl_section section = dpl_scene_section(from, i);
        for (const struct dpl_param *param = section.params; param->name; param++)
            if (!copy_value(to, from, section.name, param->name))
                return false;
    }
    return true;
}

bool document_open(struct document *document, const struct dpl_scene *from, const char *path, const struct dpl_log *log)
{
    document->scene = dpl_scene_create(log);
    document->start = dpl_scene_create(log);
    snprintf(document->path, sizeof document->path, "%s", path ? path : "");
    return document->scene && document->start && copy_scene(document->start, from) && document_reset(document);
}

void document_close(struct document *document)
{
    dpl_scene_destroy(document->scene);
    dpl_scene_destroy(document->start);
}

bool document_load(struct document *document, const char *path)
{
    if (!dpl_scene_load(document->start, path))
        return false;
    if (path != document->path)
        snprintf(document->path, sizeof document->path, "%s", path);
    return document_reset(document);
}

bool document_reset(struct document *document)
{
    return copy_scene(document->scene, document->start);
}

void document_reset_values(struct document *document, const char *section_name, const char *key)
{
    for (int i = 0; dpl_scene_section(document->start, i).name; i++) {
        struct dpl_section section = dpl_scene_section(document->start, i);
        for (const struct dpl_param *param = section.params; !strcmp(section.name, section_name) && param->name;
             param++)
            if (!key || !strcmp(param->name, key))
                copy_value(document->scene, document->start, section.name, param->name);
    }
}
