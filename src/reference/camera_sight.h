/* reference/camera_sight.h: where a picture is seen from. */
#ifndef REFERENCE_CAMERA_SIGHT_H
#define REFERENCE_CAMERA_SIGHT_H

#include "base/vector3.h"

/* Rays go from the eye along ahead + right x + up y, x and y from -1 to 1. */
struct camera_sight {
    double eye[3], ahead[3], right[3], up[3];
    int width, height; /* pixels */
};

/* The unit vector of the ray through a place of the picture in pixels, from its left and lower edge. */
static inline void camera_sight_ray(const struct camera_sight *view, double column, double row, double direction[3])
{
    vector3_along(view->ahead, view->right, 2 * column / view->width - 1, direction);
    vector3_along(direction, view->up, 2 * row / view->height - 1, direction);
    vector3_normalize(direction);
}

/* m of width of a pixel that is 1 m away. */
static inline double camera_sight_spread(const struct camera_sight *view)
{
    return 2 * sqrt(vector3_dot(view->up, view->up)) / view->height;
}

#endif
