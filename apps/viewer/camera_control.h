/* camera_control.h: moves a scene's camera: in orbit round its target, or flying. */
#ifndef VIEWER_CAMERA_CONTROL_H
#define VIEWER_CAMERA_CONTROL_H

#include "dapple/scene.h"

/* What the hands did since the last frame. */
struct camera_input {
    double orbit[2];           /* pixels to the right and down, dragged to go round the target */
    double look[2];            /* pixels to the right and down, dragged to look around */
    double wheel;              /* notches, positive: nearer to the target */
    double forward, right, up; /* -1 to 1 each */
    bool fast;                 /* flies more quickly */
    double seconds;            /* real time that passed */
};

/* Sets camera.position and camera.target. */
void camera_control_move(struct dpl_scene *scene, const struct camera_input *input);

#endif
