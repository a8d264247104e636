/* path.h: the camera's path in the window: keys from the camera as it stands, and the way along them. */
#ifndef VIEWER_PATH_H
#define VIEWER_PATH_H

#include "viewer/clock.h"

#include "dapple/scene.h"

struct viewer_path {
    bool follows; /* the camera is on its path; else the hands move it */
};

/* How many keys there are, and the times of the first and the last. */
int path_range(const struct dpl_scene *scene, double *first, double *last);

/* The camera as it is, as a key at that time. False: there is no room for another one. */
bool path_add_key(struct dpl_scene *scene, double time);
void path_clear(struct dpl_scene *scene);

/* Plays the path, from its start where the clock is not on it; or stops. */
void path_toggle(struct viewer_path *path, const struct dpl_scene *scene, struct viewer_clock *clock);

/* Puts the scene's camera where the path is at that time, while it follows it. */
void path_move(struct viewer_path *path, struct dpl_scene *scene, double time);

#endif
