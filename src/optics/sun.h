/* optics/sun.h: the sun: where it stands and how wide it is. */
#ifndef OPTICS_SUN_H
#define OPTICS_SUN_H

#include "base/param.h"

/* Section [sun]. Stands by two angles, or by the clock, where +x is east and -z north. */
enum sun_by { SUN_BY_ANGLES, SUN_BY_CLOCK };
#define SUN_LOWEST 1.0 /* degrees; the sun does not set */
struct optics_sun {
    double elevation, azimuth, angular_radius; /* degrees */
    int by;                                    /* enum sun_by */
    int date[3];                               /* as optics/sun_clock.h */
    double hour, time_zone, latitude, longitude;
};
extern const struct dpl_param optics_sun_params[];

/* Degrees, whichever way it is placed by: 1 to 90, and from +x towards +z. */
void optics_sun_angles(const struct optics_sun *sun, double *elevation, double *azimuth);

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
