/* reference/camera_aim.h: on which water photons are worth sending to: that whose light is in the picture.
 *
 * Paths from the eye tell where the picture shows something; from there the sun's light is followed back to where it
 * would have met flat water. Places of the water are then drawn by how many such ways come from around them, and some
 * from anywhere. The choice changes the noise of a picture, not what it tends to. */
#ifndef REFERENCE_CAMERA_AIM_H
#define REFERENCE_CAMERA_AIM_H

#include "reference/camera_scene.h"
#include "reference/camera_sight.h"

#define CAMERA_AIM_SIDE 96 /* cells a side */

struct camera_aim {
    double x, z, size; /* m: corner and side of the square of water that most photons are sent to */
    /* Sums of the cells' shares, row after row, and of the rows. */
    double cells[CAMERA_AIM_SIDE][CAMERA_AIM_SIDE + 1], rows[CAMERA_AIM_SIDE + 1];
};

bool camera_aim_make(struct camera_aim *aim, const struct camera_scene *scene, const struct camera_sight *view,
                     const struct dpl_log *log);

/* A place of the water for two numbers from 0 to 1; returns its density, 1/m². */
double camera_aim_place(const struct camera_aim *aim, double u, double v, double place[2]);

#endif
