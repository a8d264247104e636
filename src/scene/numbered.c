#include "scene/numbered.h"

#include "scene/scene.h"

#include <stdio.h>
#include <string.h>

/* One kind of them. Offsets are in struct dpl_scene, of the first of `count`. */
struct kind {
    const char *prefix, *help;
    const struct dpl_param *params;
    int count;           /* at most 99 */
    size_t values, size; /* size: of one */
    size_t present, names;
    bool (*active)(const struct dpl_scene *scene);
};

static bool waves_move(const struct dpl_scene *scene)
{
    return water_model_has(scene->medium.model, 0, (const void *const *)scene->model_params);
}

static bool always(const struct dpl_scene *scene)
{
    (void)scene;
    return true;
}

static const struct kind kinds[] = {
    {"wave.", "one wave of the model `sines`", water_wave_params, WATER_WAVES_MAX, offsetof(struct dpl_scene, waves),
     sizeof(struct wave), offsetof(struct dpl_scene, wave_present), offsetof(struct dpl_scene, wave_names), waves_move},
    {"camera.", "a key of the camera's path", scene_camera_key_params, SCENE_CAMERA_KEYS_MAX,
     offsetof(struct dpl_scene, camera_keys), sizeof(struct scene_camera_key),
     offsetof(struct dpl_scene, camera_key_present), offsetof(struct dpl_scene, camera_key_names), always},
};
enum { KIND_COUNT = sizeof kinds / sizeof *kinds };

static bool *present_of(const struct kind *kind, const struct dpl_scene *scene)
{
    return (bool *)((char *)scene + kind->present);
}

/* `number` counts from 0. */
static char *name_of(const struct kind *kind, const struct dpl_scene *scene, int number)
{
    return (char *)scene + kind->names + (size_t)number * SCENE_NUMBERED_NAME_SIZE;
}

static struct dpl_section section_of(const struct kind *kind, const struct dpl_scene *scene, int number)
{
    return (struct dpl_section){name_of(kind, scene, number), kind->help, kind->params,
                                (char *)scene + kind->values + (size_t)number * kind->size, kind->active(scene)};
}

/* The kind of that name and its number from 0, or NULL. */
static const struct kind *find(const char *name, int *number)
{
    for (const struct kind *kind = kinds; kind < kinds + KIND_COUNT; kind++) {
        size_t prefix = strlen(kind->prefix);
        int length = 0;
        if (!strncmp(name, kind->prefix, prefix) && name[prefix] >= '1' && name[prefix] <= '9' &&
            sscanf(name + prefix, "%2d%n", number, &length) == 1 && !name[prefix + (size_t)length] &&
            (*number)-- <= kind->count)
            return kind;
    }
    return NULL;
}

void scene_numbered_start(struct dpl_scene *scene)
{
    for (const struct kind *kind = kinds; kind < kinds + KIND_COUNT; kind++) {
        for (int i = 0; i < kind->count; i++) {
            param_defaults(kind->params, section_of(kind, scene, i).values);
            snprintf(name_of(kind, scene, i), SCENE_NUMBERED_NAME_SIZE, "%s%d", kind->prefix, i + 1);
            present_of(kind, scene)[i] = false;
        }
    }
}

struct dpl_section scene_numbered_find(const struct dpl_scene *scene, const char *name)
{
    int number;
    const struct kind *kind = find(name, &number);
    return kind ? section_of(kind, scene, number) : (struct dpl_section){0};
}

bool scene_numbered_mark(struct dpl_scene *scene, const char *name, bool present)
{
    int number;
    const struct kind *kind = find(name, &number);
    if (!kind)
        return false;
    present_of(kind, scene)[number] = present;
    if (!present)
        param_defaults(kind->params, section_of(kind, scene, number).values);
    return true;
}

struct dpl_section scene_numbered_section(const struct dpl_scene *scene, int *index)
{
    for (const struct kind *kind = kinds; kind < kinds + KIND_COUNT; kind++)
        for (int i = 0; i < kind->count; i++)
            if (present_of(kind, scene)[i] && (*index)-- == 0)
                return section_of(kind, scene, i);
    return (struct dpl_section){0};
}

void scene_numbered_list(char *text, size_t size)
{
    size_t used = 0;
    for (const struct kind *kind = kinds; kind < kinds + KIND_COUNT && used < size; kind++)
        used += (size_t)snprintf(text + used, size - used, "%s%s1 to %s%d", used ? ", " : "", kind->prefix,
                                 kind->prefix, kind->count);
}
