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

/* Sets camera.position and camera.target; true where they moved. */
bool camera_control_move(struct dpl_scene *scene, const struct camera_input *input);

/* Puts the camera there. */
void camera_control_place(struct dpl_scene *scene, const double position[3], const double target[3]);

/* The line of sight through a place of the picture. Directions are unit vectors. */
struct camera_ray {
    double eye[3], direction[3];
    double forward[3]; /* the direction through the middle */
};

/* `place`: -1 to 1 across the picture, to the right and up; `aspect`: its width / height. */
bool camera_control_ray(const struct dpl_scene *scene, const double place[2], double aspect, struct camera_ray *ray);

#endif
