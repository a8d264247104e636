/* scene/camera_path.h: the view, and the path that it takes through keys [camera.1], [camera.2], … of scene text.
 *
 * Position, target and field of view are cubic Hermite splines of the time. The velocity at a key is that of the
 * parabola through it and its neighbours (Catmull & Rom 1974, with the keys' times as knots), but at most three times
 * the mean speed of the slower side: where a single number rises on both sides it never falls in between (Fritsch &
 * Carlson 1980), and a camera that stands still between two keys does not drift there. An open path starts and ends at
 * rest. Two keys at one time are a cut. */
#ifndef SCENE_CAMERA_PATH_H
#define SCENE_CAMERA_PATH_H

#include "base/param.h"

#define SCENE_CAMERA_KEYS_MAX 16
#define SCENE_FIELD_OF_VIEW_MIN 1 /* degrees */
#define SCENE_FIELD_OF_VIEW_MAX 150

struct dpl_scene;

struct scene_camera {
    double position[3], target[3];
    double field_of_view; /* degrees, vertical */
    double near_plane, far_plane;
    double exposure; /* stops */
    double white[3]; /* light that looks white */
    bool closed; /* the path: it is back at the first key when the last key's time is there, and goes on from there */
};

/* [camera.N] */
struct scene_camera_key {
    double time; /* s */
    double position[3], target[3];
    double field_of_view; /* degrees, vertical */
};
extern const struct dpl_param scene_camera_key_params[];

/* The view at that time: the scene's camera, moved along the path where there are two keys or more. */
struct scene_camera scene_camera_at(const struct dpl_scene *scene, double time);

#endif
