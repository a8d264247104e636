/* base/resource.h: files of the repository that the build puts into the library: shaders and scenes. */
#ifndef BASE_RESOURCE_H
#define BASE_RESOURCE_H

#include <stddef.h>

struct base_resource {
    const char *path; /* "light/multi_sample.glsl", "scenes/collard-1.ini"; NULL ends the list */
    const char *text; /* ends with a zero byte */
};

/* Written by script/embed.py at build time, sorted by path. */
extern const struct base_resource base_resources[];

/* The text, or NULL. */
const char *base_resource_find(const char *path);

#endif
