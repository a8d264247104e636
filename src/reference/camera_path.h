/* reference/camera_path.h: the light that comes along a ray from where it goes, found by following it backwards
 * (Kajiya 1986).
 *
 * The first water that a path meets reflects and refracts it, later water does one of the two by chance; in water it is
 * scattered by chance, at something solid it goes on in any direction. Light of the sun that has met water on its way
 * to something solid, or to a place in the water, is no path's to find: it is looked up among photons, or, where water
 * is at rest, known in closed form. */
#ifndef REFERENCE_CAMERA_PATH_H
#define REFERENCE_CAMERA_PATH_H

#include "reference/camera_photons.h"
#include "reference/camera_scene.h"
#include "reference/draws.h"

struct camera_path {
    const struct camera_scene *scene;
    const struct camera_photons *photons; /* NULL: the water is at rest */
    int bounces;                          /* most reflections by solids and scatterings in water */
    bool sun_seen;                        /* the sun's disc itself counts, where only water or nothing lies between */
    double spread;                     /* m of width that a pixel gains on a way of 1 m: light is gathered over that */
    double solid_radius, water_radius; /* m: but over no less than this, on solids and in the water */
};

/* `wet`: the ray starts in water. */
void camera_path_radiance(const struct camera_path *path, const double origin[3], const double direction[3], bool wet,
                          struct draws *draws, double radiance[3]);

#endif
