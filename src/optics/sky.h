/* optics/sky.h: the light of the sun and of the sky above the water, as numbers and as a picture of the whole sky.
 *
 * Radiometric, linear, red green blue; the unit is that in which the sun's irradiance outside the atmosphere, on a
 * surface across its rays, has the luminance 1. */
#ifndef OPTICS_SKY_H
#define OPTICS_SKY_H

#include "base/param.h"
#include "optics/sun.h"

#include <stdint.h>

/* Section [sky]. */
enum sky_model { SKY_CLEAR, SKY_OVERCAST, SKY_ENVIRONMENT };
struct optics_sky_settings {
    int model;                             /* enum sky_model */
    double turbidity;                      /* of the clear sky: haze; 1 is clean air */
    double sun;                            /* share of the direct sun's light that clouds let pass: 1 clear, 0 none;
                                              below 0: 0 of an overcast sky, 1 of the others */
    double brightness;                     /* times everything */
    double ground[3];                      /* reflectance of what lies beyond the horizon */
    double turn;                           /* degrees, of the environment about the vertical, from +x towards +z */
    char environment[DPL_PARAM_TEXT_SIZE]; /* .exr, .pfm: a picture of the whole sky, of which the upper half is used */
};
extern const struct dpl_param optics_sky_params[];

#define SKY_COLUMNS 256
#define SKY_ROWS 128

/* All zero: none yet. */
struct optics_sky {
    float *texels; /* SKY_ROWS × SKY_COLUMNS × 3: radiance without the sun's disc. Row 0 is the zenith, the last the
                      nadir (below the horizon: ground); column 0 is at azimuth 0, they go round from +x towards +z.
                      The middle of texel (i, j) is i + ½ columns of 360° / SKY_COLUMNS round, and j + ½ rows of
                      180° / SKY_ROWS below the zenith. The horizon is the line between two rows: what is seen on one
                      side of it is not to be mixed with the other */
    double sun[3]; /* irradiance of the sun's disc on a surface across its rays */
    double sun_radiance[3]; /* of the disc, where it has a width; of one 0.2665° wide where it is a point */
    double irradiance[3];   /* of the sky alone on a horizontal surface */
    uint64_t fingerprint;   /* of what it was made from; changes when the light changes */
    struct sky_kept *kept;  /* tables, and the environment's picture */
};

/* Makes the sky of the settings and the sun, or leaves it where both are as they were. False (logged): no memory, or an
 * environment that cannot be read; the sky then stays as it was. A picture is read once, whatever becomes of its file.
 */
bool optics_sky_make(struct optics_sky *sky, const struct optics_sky_settings *settings, const struct optics_sun *sun,
                     const struct dpl_log *log);

/* Radiance from a direction (a unit vector that points there), interpolated, without the sun's disc. */
void optics_sky_radiance(const struct optics_sky *sky, const double direction[3], double radiance[3]);

void optics_sky_finish(struct optics_sky *sky);

#endif
