/* optics/sun.h: the sun: where it stands and how wide it is. */
#ifndef OPTICS_SUN_H
#define OPTICS_SUN_H

#include "base/param.h"

/* Section [sun]. */
struct optics_sun {
    double elevation, azimuth, angular_radius; /* degrees */
};
extern const struct dpl_param optics_sun_params[];

/* The unit vector towards the middle of the sun. Light travels the other way. */
void optics_sun_direction(const struct optics_sun *sun, double out[3]);

/* The unit vector towards a place of the sun's disc; `disc` lies in the unit circle, whose area is spread evenly over
 * the disc. Its first axis points up, its second horizontally. */
void optics_sun_place(const struct optics_sun *sun, const double disc[2], double out[3]);

#endif
