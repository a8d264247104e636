/* scene/noise.h: noise in space, for what shapes look like; the same number for the same place and seed. */
#ifndef SCENE_NOISE_H
#define SCENE_NOISE_H

#include <stdint.h>

/* Smooth noise, about -1 to 1, whose bumps are one unit wide (Perlin 2002, with gradients from a hash). */
double noise_smooth(const double place[3], uint64_t seed);

/* Its sum over octaves, each twice as fine and half as high as the one before; -1 to 1. */
double noise_fractal(const double place[3], int octaves, uint64_t seed);

/* Octaves of 1 - |noise|, squared: rounded valleys and sharp ridges; each octave is strong where the one before is
 * (after Musgrave, in Ebert et al. 2003, ch. 16). 0 to 1. */
double noise_ridged(const double place[3], int octaves, uint64_t seed);

/* Distances to the nearest and the second nearest of points strewn one a unit cube (Worley 1996). */
void noise_cells(const double place[3], uint64_t seed, double distances[2]);

#endif
