/* reference/camera_photons.h: the sun's light that has met water, as photons (Jensen 1996).
 *
 * A photon starts where the sun shines on the water, is reflected or refracted there and wherever it meets water again,
 * is scattered in the water, and ends at the first solid, or goes on behind it where that throws no shadow. In water
 * that scatters it leaves some of its light at places on its way. Light at a place is then what the photons around it
 * carry, over the area or the room in which they were counted: it is smeared over that radius, and at a solid's edge,
 * where part of the disc is beyond it, too dark. */
#ifndef REFERENCE_CAMERA_PHOTONS_H
#define REFERENCE_CAMERA_PHOTONS_H

#include "reference/camera_aim.h"
#include "reference/camera_scene.h"
#include "reference/photon_tree.h"

/* What has come of some photons that were sent together. */
struct camera_block {
    int solids, marks;
};

/* All zero: none. */
struct camera_photons {
    const struct camera_scene *scene;
    struct camera_aim aim;
    struct photon_tree solids, water;
    struct camera_block *blocks;
    int sent; /* photons of a pass */
};

/* Room for `count` photons of the picture. */
bool camera_photons_begin(struct camera_photons *photons, const struct camera_scene *scene,
                          const struct camera_sight *view, int count, const struct dpl_log *log);
void camera_photons_finish(struct camera_photons *photons);

/* Sends all of them, others in each pass. */
void camera_photons_send(struct camera_photons *photons, uint64_t pass);

/* Irradiance on a surface of that normal, from a disc of that radius. */
void camera_photons_surface(const struct camera_photons *photons, const double place[3], const double normal[3],
                            double radius, double irradiance[3]);

/* Light in the water that is scattered against `direction`: radiance for each metre and each 1/m of scattering, from
 * a ball of that radius. */
void camera_photons_volume(const struct camera_photons *photons, const double place[3], const double direction[3],
                           double radius, double radiance[3]);

#endif
