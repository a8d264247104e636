/* reference/camera_crossing.h: the two ways that light goes on where it meets water. */
#ifndef REFERENCE_CAMERA_CROSSING_H
#define REFERENCE_CAMERA_CROSSING_H

#include "reference/camera_scene.h"

struct camera_crossing {
    bool wet;           /* it comes from the water */
    double reflectance; /* 1: nothing is refracted */
    double reflected[3], refracted[3];
};

/* Of a ray that meets the water there. An interpolated normal would now and then send a ray through the mesh; such a
 * direction is mirrored to the side that it belongs to. */
struct camera_crossing camera_crossing(const struct camera_hit *hit, const double direction[3], double ior);

#endif
