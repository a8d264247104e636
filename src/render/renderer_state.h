/* render/renderer_state.h: the renderer from inside, for the files that it is made of. */
#ifndef RENDER_RENDERER_STATE_H
#define RENDER_RENDERER_STATE_H

#include "dapple/renderer.h"
#include "render/difference.h"
#include "render/lighting.h"
#include "render/picture.h"
#include "render/sand.h"
#include "render/thumbnail.h"
#include "render/tone.h"

struct dpl_renderer {
    struct dpl_gl *gl; /* NULL: CPU only */
    const struct dpl_log *log;
    struct gpu_timer timer;
    struct lighting lighting;
    struct dpl_compare compare;
    bool compared; /* the maps made last are two */
    bool has_sphere;
    double sphere[3]; /* m, its middle in the last picture */
    struct difference difference;
    struct sand sand;
    void *look_states[SCENE_LOOKS_MAX]; /* made when first used */
    struct gpu_target target;
    struct tone tone;
    struct thumbnails thumbnails;
    struct picture picture;
    struct scene_camera camera; /* of the frame under way */
    bool still;                 /* the camera's path does not count */
};

/* Ends a call: true where OpenGL had nothing to say against it. */
bool renderer_leave(struct dpl_renderer *renderer, unsigned framebuffer);

#endif
