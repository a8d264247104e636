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

/* The sun's disc: the unit vector towards its middle, and from there to its edge upwards and horizontally. */
struct optics_disc {
    double middle[3], up[3], across[3];
    double radius; /* sine of the angular radius */
};
struct optics_disc optics_sun_disc(const struct optics_sun *sun);

/* The unit vector towards a place of the disc; `place`, up and across, lies in the unit circle, whose area is spread
 * evenly over the disc. */
void optics_disc_place(const struct optics_disc *disc, const double place[2], double out[3]);

/* A place in the unit circle for one of the unit square; equal areas for equal areas. */
void optics_disc_spread(double u, double v, double place[2]);

#endif
