/* optics/phase.h: where light goes that is scattered. optics/phase.glsl is its twin. */
#ifndef OPTICS_PHASE_H
#define OPTICS_PHASE_H

/* Share of scattered light for each steradian around a direction, 1/sr (Henyey & Greenstein 1941). `cosine`: between
 * the way of the light before and after, 1 straight on; `anisotropy`: the mean of that cosine, above -1 and below 1. */
double optics_phase(double cosine, double anisotropy);

/* The share of scattered light that turns by more than a right angle. */
double optics_phase_backward(double anisotropy);

/* The cosine below which a share `u` of the scattered light lies, for u from 0 to 1. */
double optics_phase_cosine(double u, double anisotropy);

#endif
