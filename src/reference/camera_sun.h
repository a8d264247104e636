/* reference/camera_sun.h: light that comes straight from the sun, through air alone or over water at rest, in closed
 * form. */
#ifndef REFERENCE_CAMERA_SUN_H
#define REFERENCE_CAMERA_SUN_H

#include "reference/camera_scene.h"
#include "reference/draws.h"

/* Light on its way: where it goes, and its irradiance on a surface across that. */
struct camera_beam {
    double direction[3];
    double irradiance[3];
};
#define CAMERA_BEAMS_MAX 9 /* three surfaces, three colours */

/* A place of the sun's disc. */
void camera_sun_place(const struct camera_scene *scene, struct draws *draws, double to_sun[3]);

/* The sun's light in the air at a place; false where something is in its way. */
bool camera_sun_direct(const struct camera_scene *scene, const double place[3], const double to_sun[3],
                       struct camera_beam *beam);

/* What water at rest sends there of the sun's light, refracted or reflected; returns how many beams. */
int camera_sun_at_rest(const struct camera_scene *scene, const double place[3], bool wet, const double to_sun[3],
                       struct camera_beam beams[CAMERA_BEAMS_MAX]);

#endif
