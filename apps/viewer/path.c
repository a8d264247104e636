#include "viewer/path.h"

#include "viewer/camera_control.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SAME_TIME 0.005 /* s: keys that are nearer are the same one */
#define KEYS_MAX 16     /* that a scene has room for */

/* Takes the sections [camera.N] from `*next` on, one a call: its name and time; false past the last. */
static bool next_key(const struct dpl_scene *scene, int *next, const char **name, double *time)
{
    char key[64], text[64];
    for (; dpl_scene_section(scene, *next).name; (*next)++) {
        *name = dpl_scene_section(scene, *next).name;
        if (strncmp(*name, "camera.", 7) != 0)
            continue;
        (*next)++;
        snprintf(key, sizeof key, "%.32s.time", *name);
        *time = dpl_scene_get(scene, key, text, sizeof text) ? strtod(text, NULL) : 0;
        return true;
    }
    return false;
}

int path_range(const struct dpl_scene *scene, double *first, double *last)
{
    const char *name;
    double time;
    int count = 0;
    *first = *last = 0;
    for (int next = 0; next_key(scene, &next, &name, &time); count++) {
        *first = count ? fmin(*first, time) : time;
        *last = count ? fmax(*last, time) : time;
    }
    return count;
}

static void copy(struct dpl_scene *scene, const char *to, const char *key)
{
    char from[64], name[64], value[128];
    snprintf(from, sizeof from, "camera.%s", key);
    snprintf(name, sizeof name, "%.32s.%s", to, key);
    if (dpl_scene_get(scene, from, value, sizeof value))
        dpl_scene_set(scene, name, value);
}

/* The key at that time, or one that is not there yet. */
static void choose_key(const struct dpl_scene *scene, double time, char chosen[32])
{
    const char *name;
    double other;
    bool taken[KEYS_MAX + 2] = {false};
    int number = 1;
    for (int next = 0; next_key(scene, &next, &name, &other);) {
        snprintf(chosen, 32, "%s", name);
        if (fabs(other - time) < SAME_TIME)
            return;
        taken[atoi(name + strlen("camera."))] = true;
    }
    while (number <= KEYS_MAX && taken[number])
        number++;
    snprintf(chosen, 32, "camera.%d", number);
}

bool path_add_key(struct dpl_scene *scene, double time)
{
    char key[32], name[64], value[32];
    choose_key(scene, time, key);
    snprintf(name, sizeof name, "%s.time", key);
    snprintf(value, sizeof value, "%.2f", time);
    if (!dpl_scene_set(scene, name, value))
        return false;
    copy(scene, key, "position");
    copy(scene, key, "target");
    copy(scene, key, "field_of_view");
    return true;
}

void path_clear(struct dpl_scene *scene)
{
    const char *name;
    double time;
    for (int next = 0; next_key(scene, &next, &name, &time); next = 0)
        dpl_scene_remove(scene, name);
}

static bool is_closed(const struct dpl_scene *scene)
{
    char text[16];
    return dpl_scene_get(scene, "camera.closed", text, sizeof text) && !strcmp(text, "true");
}

void path_toggle(struct viewer_path *path, const struct dpl_scene *scene, struct viewer_clock *clock)
{
    double first, last;
    path->follows = path_range(scene, &first, &last) > 1 && !path->follows;
    if (!path->follows)
        return;
    clock->paused = false;
    if (!is_closed(scene) && (clock->time < first || clock->time > last - SAME_TIME))
        clock->time = first;
}

void path_move(struct viewer_path *path, struct dpl_scene *scene, double time)
{
    double first, last;
    char text[32];
    path->follows = path->follows && path_range(scene, &first, &last) > 1;
    if (!path->follows)
        return;
    struct dpl_view view = dpl_scene_view(scene, time);
    camera_control_place(scene, view.position, view.target);
    snprintf(text, sizeof text, "%.7g", view.field_of_view);
    dpl_scene_set(scene, "camera.field_of_view", text);
}
