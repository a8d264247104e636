/* still.h: a still picture of any size, written beside the scene. */
#ifndef VIEWER_STILL_H
#define VIEWER_STILL_H

#include "dapple/param.h"

struct viewer_still {
    char name[DPL_PARAM_TEXT_SIZE]; /* of the file; beside the scene's where it starts with no folder's root */
    int size[2];                    /* pixels */
};

/* Names it after the scene: "pool-still.png"; the size stays. */
void still_rename(struct viewer_still *still, const char *scene_path);

/* Where it is written. A built-in scene's: the current folder. */
void still_path(const struct viewer_still *still, const char *scene_path, char *path, size_t size);

#endif
