#include "viewer/still.h"

#include <stdio.h>
#include <string.h>

/* How much of the path is its folder, the slash included. */
static int folder_length(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? (int)(slash + 1 - path) : 0;
}

void still_rename(struct viewer_still *still, const char *scene_path)
{
    const char *name = scene_path + folder_length(scene_path), *dot = strrchr(name, '.');
    if (!*name)
        name = "dapple";
    int length = dot && dot != name ? (int)(dot - name) : (int)strlen(name);
    snprintf(still->name, sizeof still->name, "%.*s-still.png", length > 120 ? 120 : length, name);
}

void still_path(const struct viewer_still *still, const char *scene_path, char *path, size_t size)
{
    int folder = *still->name == '/' ? 0 : folder_length(scene_path);
    snprintf(path, size, "%.*s%s", folder, scene_path, still->name);
}
