/* viewer.h: a window that shows a scene as it moves, with a control for every value. */
#ifndef VIEWER_VIEWER_H
#define VIEWER_VIEWER_H

#include "dapple/dapple.h"

struct viewer_options {
    struct dpl_scene *scene;   /* shown first; never written to */
    const char *scene_path;    /* file or built-in scene that it came from, read anew when it changes; may be NULL */
    const char *shader_folder; /* as in struct dpl_gl_options; its files are read anew when they change */
    enum dpl_device device;
    int width, height; /* of the window, before the desktop's scale; 0: 1280 × 720 */
    double time;       /* s, at the first frame */
    const struct dpl_log *log;
};

/* Runs until the window is closed. Returns the program's exit code: 0, or 1 where there can be no window. */
int viewer_run(const struct viewer_options *options);

#endif
