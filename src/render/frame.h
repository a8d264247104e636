/* render/frame.h: what every look gets to draw a picture from. */
#ifndef RENDER_FRAME_H
#define RENDER_FRAME_H

#include "gpu/target.h"
#include "gpu/timer.h"
#include "render/camera.h"
#include "scene/scene.h"

struct frame {
    struct dpl_gl *gl;
    const struct dpl_scene *scene;
    const struct scene_camera *camera; /* in use now: scene->camera, or where its path has got to */
    const void *params;                /* the look's own struct */
    double time;                       /* s */
    double sphere[3];                  /* m, the middle of the scene's sphere now */
    const struct water_setup *setup;   /* of the scene's water model */
    const struct surface_gpu *surface;
    const struct surface_gpu *above;  /* the same as it is straight above each place: without shifts, if it is choppy */
    const struct gpu_texture *map;    /* the caustic maps; see light/map_texture.h */
    const struct ray_window *windows; /* that they show */
    const struct gpu_texture *reflected;        /* those of light that is thrown back; NULL: none */
    const struct ray_window *reflected_windows; /* that they show */
    const struct gpu_texture *sand;             /* of looks that ask for it */
    const struct gpu_target *target;            /* that is bound when draw() is called */
    struct camera_view view;                    /* the part of the picture that is drawn now */
    float view_projection[16];                  /* columns; world to clip space, of that part */
    struct camera_rays rays;                    /* of that part */
    struct gpu_timer *timer;
    struct light_progress progress; /* of looks that refine a picture */
};

#endif
