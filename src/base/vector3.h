/* base/vector3.h: sums over the three numbers of places and directions. */
#ifndef BASE_VECTOR3_H
#define BASE_VECTOR3_H

#include <math.h>

static inline double vector3_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void vector3_copy(const double from[3], double to[3])
{
    for (int c = 0; c < 3; c++)
        to[c] = from[c];
}

/* to = from × scale */
static inline void vector3_scale(const double from[3], double scale, double to[3])
{
    for (int c = 0; c < 3; c++)
        to[c] = from[c] * scale;
}

/* to = from + direction × distance */
static inline void vector3_along(const double from[3], const double direction[3], double distance, double to[3])
{
    for (int c = 0; c < 3; c++)
        to[c] = from[c] + direction[c] * distance;
}

static inline double vector3_length(const double a[3])
{
    return sqrt(vector3_dot(a, a));
}

static inline void vector3_cross(const double a[3], const double b[3], double out[3])
{
    for (int c = 0; c < 3; c++)
        out[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
}

static inline void vector3_normalize(double a[3])
{
    vector3_scale(a, 1 / vector3_length(a), a);
}

static inline double vector3_most(const double a[3])
{
    return fmax(fmax(a[0], a[1]), a[2]);
}

/* Mirrors a direction in the plane across a unit vector, where it does not go that way (`side` 1) or against it (-1).
 */
static inline void vector3_keep_side(const double across[3], double side, double direction[3])
{
    double along = vector3_dot(direction, across);
    if (along * side < 0)
        vector3_along(direction, across, -2 * along, direction);
}

/* Turns a direction given along two sides of a unit vector and itself to where that vector points (Duff et al. 2017,
 * "Building an orthonormal basis, revisited"). */
static inline void vector3_turn(const double axis[3], const double local[3], double out[3])
{
    double sign = copysign(1, axis[2]), a = -1 / (sign + axis[2]), b = axis[0] * axis[1] * a;
    const double first[3] = {1 + sign * axis[0] * axis[0] * a, sign * b, -sign * axis[0]};
    const double second[3] = {b, sign + axis[1] * axis[1] * a, -axis[1]};
    for (int c = 0; c < 3; c++)
        out[c] = local[0] * first[c] + local[1] * second[c] + local[2] * axis[c];
}

#endif
