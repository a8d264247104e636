/* watch.h: notices when the scene's file or a shader changes on disk. */
#ifndef VIEWER_WATCH_H
#define VIEWER_WATCH_H

#include <stdbool.h>
#include <stdint.h>

struct watch {
    double next;             /* s, real time of the next look */
    uint64_t scene, shaders; /* stamps of what was seen last; 0: nothing there */
};

struct watch_changes {
    bool scene, shaders;
};

/* Notes what is there now. Either path may be NULL. */
void watch_start(struct watch *watch, const char *scene_path, const char *shader_folder);

/* Looks at the disk about twice a second; in between nothing has changed. `now` is a steady real time in seconds. */
struct watch_changes watch_poll(struct watch *watch, const char *scene_path, const char *shader_folder, double now);

#endif
