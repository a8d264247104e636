/* reference/camera_photons.h: stub */
#ifndef REFERENCE_CAMERA_PHOTONS_H
#define REFERENCE_CAMERA_PHOTONS_H

#include "reference/camera_scene.h"

struct camera_photons;

/* Irradiance of the sun's light that has met water, on a surface of that normal; from a disc of that radius. */
void camera_photons_surface(const struct camera_photons *photons, const double place[3], const double normal[3],
                            double radius, double irradiance[3]);

/* The same light scattered once in the water at a place, into the direction against `direction`: radiance for each
 * metre and each 1/m of scattering coefficient, from a ball of that radius. */
void camera_photons_volume(const struct camera_photons *photons, const double place[3], const double direction[3],
                           double radius, double radiance[3]);

#endif
