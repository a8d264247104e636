/* optics/scattering.h: sunlight that the air scatters once, and many times. */
#ifndef OPTICS_SCATTERING_H
#define OPTICS_SCATTERING_H

#include "optics/atmosphere.h"

#define SCATTERING_HEIGHTS 8
#define SCATTERING_SUNS 16

/* Radiance of light that has been scattered at least once, mean over all directions, for each unit of the sun's
 * irradiance outside the atmosphere; by height and by the sun's angle there. */
struct scattering {
    float mean[SCATTERING_HEIGHTS][SCATTERING_SUNS][SPECTRUM_COUNT];
};

/* `ground`: the ground's reflectance. Approximate: beyond the second time light goes on evenly and finds the same air
 * everywhere (Hillaire 2020, section 5.5). */
void scattering_make(struct scattering *scattering, const struct atmosphere *atmosphere,
                     const struct atmosphere_columns *columns, double ground);

/* What arrives at the ground from a direction, for each unit of the sun's irradiance outside the atmosphere: `once`
 * times the phase function of air and of haze, and `more`. */
struct scattering_sum {
    float once[2][SPECTRUM_COUNT], more[SPECTRUM_COUNT];
};
void scattering_gather(const struct scattering *scattering, const struct atmosphere *atmosphere,
                       const struct atmosphere_columns *columns, const double direction[3], const double sun[3],
                       struct scattering_sum *sum);

#endif
