/* optics/atmosphere.h: clear air around a round earth: what it lets through and what it scatters.
 *
 * Lengths in metres. A column is the length of air as dense as at the ground that a path's air would fill: a vertical
 * one from the ground has 8000 m of molecules, 1200 m of haze and 15000 m of ozone as dense as where it is densest. */
#ifndef OPTICS_ATMOSPHERE_H
#define OPTICS_ATMOSPHERE_H

#include "optics/spectrum.h"

#include <stdbool.h>

#define ATMOSPHERE_GROUND 6371e3 /* m, the earth's radius */
#define ATMOSPHERE_TOP 6431e3    /* above it there is nothing */
#define ATMOSPHERE_HAZE_KEPT                                                                                           \
    0.9f /* of the light that haze takes away this much is scattered (Bruneton & Neyret 2008) */

enum atmosphere_part { ATMOSPHERE_AIR, ATMOSPHERE_HAZE, ATMOSPHERE_OZONE, ATMOSPHERE_PARTS };

#define ATMOSPHERE_HEIGHTS 48
#define ATMOSPHERE_ANGLES 96

/* Columns up to the top, of all heights and of all angles that do not meet the ground. Always the same. */
struct atmosphere_columns {
    float column[ATMOSPHERE_HEIGHTS][ATMOSPHERE_ANGLES][ATMOSPHERE_PARTS];
};
void atmosphere_columns_make(struct atmosphere_columns *columns);

/* What each part takes away, 1/m where it is densest, by wavelength. Turbidity as Preetham et al. 1999 define it. */
struct atmosphere {
    float extinction[ATMOSPHERE_PARTS][SPECTRUM_COUNT];
};
struct atmosphere atmosphere_of(double turbidity);

/* Densities at a distance from the earth's middle, 1 where each part is densest. */
void atmosphere_density(double radius, float density[ATMOSPHERE_PARTS]);

/* The columns from there towards a direction of that cosine to the vertical. A direction below the horizon gets those
 * of the horizon. */
void atmosphere_column(const struct atmosphere_columns *columns, double radius, double cosine,
                       float column[ATMOSPHERE_PARTS]);

/* Share of the sun's disc that stands above the horizon there, 0 to 1. */
double atmosphere_sun_share(double radius, double cosine);

/* Length of a path to the top, or to the ground where it meets that. */
double atmosphere_path(double radius, double cosine, bool *meets_ground);

#endif
