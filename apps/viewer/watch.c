#include "viewer/watch.h"

#include <dirent.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#define INTERVAL 0.5   /* s */
#define FOLDER_DEPTH 3 /* folders inside folders */
#define PATH_SIZE 4096

/* Differs where the file's time, size or identity differs; 0 where there is no such file. */
static uint64_t file_stamp(const char *path)
{
    struct stat status;
    if (stat(path, &status) != 0 || !S_ISREG(status.st_mode))
        return 0;
    uint64_t stamp = (uint64_t)status.st_mtim.tv_sec * 1000000000u + (uint64_t)status.st_mtim.tv_nsec;
    return (stamp * 31 + (uint64_t)status.st_size) * 31 + (uint64_t)status.st_ino;
}

static bool is_shader(const char *name)
{
    size_t length = strlen(name);
    return length > 5 && !strcmp(name + length - 5, ".glsl");
}

/* The sum over all shaders in the folder, so that the order of reading does not matter. */
static uint64_t folder_stamp(const char *folder, int depth)
{
    uint64_t sum = 0;
    char path[PATH_SIZE];
    DIR *stream = depth > 0 ? opendir(folder) : NULL;
    for (struct dirent *entry; stream && (entry = readdir(stream));) {
        if (entry->d_name[0] == '.' || snprintf(path, sizeof path, "%s/%s", folder, entry->d_name) >= PATH_SIZE)
            continue;
        sum += is_shader(entry->d_name) ? file_stamp(path) : folder_stamp(path, depth - 1);
    }
    if (stream)
        closedir(stream);
    return sum;
}

/* A file that is missing for a moment, as when an editor replaces it, has not changed yet. */
static bool changed(uint64_t *seen, uint64_t found)
{
    bool differs = found != 0 && found != *seen;
    if (differs)
        *seen = found;
    return differs;
}

void watch_start(struct watch *watch, const char *scene_path, const char *shader_folder)
{
    watch->scene = scene_path ? file_stamp(scene_path) : 0;
    watch->shaders = shader_folder ? folder_stamp(shader_folder, FOLDER_DEPTH) : 0;
}

struct watch_changes watch_poll(struct watch *watch, const char *scene_path, const char *shader_folder, double now)
{
    if (now < watch->next)
        return (struct watch_changes){0};
    watch->next = now + INTERVAL;
    return (struct watch_changes){
        .scene = scene_path && changed(&watch->scene, file_stamp(scene_path)),
        .shaders = shader_folder && changed(&watch->shaders, folder_stamp(shader_folder, FOLDER_DEPTH)),
    };
}
