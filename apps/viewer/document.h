/* document.h: the scene in the window, and as it was when it was loaded. */
#ifndef VIEWER_DOCUMENT_H
#define VIEWER_DOCUMENT_H

#include "dapple/scene.h"

#include <limits.h>

struct document {
    struct dpl_scene *scene; /* shown; the panel and the camera change it */
    struct dpl_scene *start; /* as it was loaded: what "reset" goes back to */
    char path[PATH_MAX];     /* file or built-in scene; "": neither */
};

/* Starts with a copy of `from`. A document that failed to open can be closed all the same. */
bool document_open(struct document *document, const struct dpl_scene *from, const char *path,
                   const struct dpl_log *log);
void document_close(struct document *document);

/* Loads a file or a built-in scene. On failure everything stays as it was. */
bool document_load(struct document *document, const char *path);

/* Brings every value back to where it was loaded. */
bool document_reset(struct document *document);

/* Brings back one value, or with key = NULL those of the whole section. */
void document_reset_values(struct document *document, const char *section, const char *key);

#endif
