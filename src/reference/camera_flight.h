/* reference/camera_flight.h: one photon of the sun's light that has met water. */
#ifndef REFERENCE_CAMERA_FLIGHT_H
#define REFERENCE_CAMERA_FLIGHT_H

#include "reference/camera_aim.h"
#include "reference/camera_scene.h"
#include "reference/draws.h"
#include "reference/photon_tree.h"

#define CAMERA_MEETINGS 64 /* most of one photon, after that with the water that it comes to first */

/* A photon on its way, and what it leaves. */
struct camera_flight {
    const struct camera_scene *scene;
    const struct camera_aim *aim;
    struct draws draws;
    double place[3], direction[3], flux[3];
    bool wet;
    int color; /* the one that is left after it was refracted as one; -1: all */
    bool landed;
    struct photon solid; /* where it has landed */
    int marked;
    struct photon marks[CAMERA_MEETINGS];
};

/* Sends the photon that the draws make; it carries the light of all. */
void camera_fly(struct camera_flight *flight, const struct camera_scene *scene, const struct camera_aim *aim,
                struct draws draws);

#endif
