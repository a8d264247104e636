/* reference/camera_medium.h: what happens to light inside the water. */
#ifndef REFERENCE_CAMERA_MEDIUM_H
#define REFERENCE_CAMERA_MEDIUM_H

#include "reference/camera_world.h"
#include "reference/draws.h"

/* Share of the light of a colour that is neither absorbed nor scattered on a way of so many metres. */
double camera_medium_left(const struct camera_water *water, int color, double length);

/* The same of the colour of which most is left. */
double camera_medium_most_left(const struct camera_water *water, double length);

/* A direction that scattered light takes, distributed as the phase function. */
void camera_medium_turn(double anisotropy, struct draws *draws, double direction[3]);

/* Draws how far a path goes before it is scattered, at most `length`; colours with a throughput of 0 have no say. The
 * throughput becomes that at the end. True where it is scattered there. */
bool camera_medium_walk(const struct camera_water *water, double length, struct draws *draws, double throughput[3],
                        double *distance);

/* Draws a place on a way of `length` metres to look at light from, nearer ones more often; returns its density, 1/m. */
double camera_medium_place(const struct camera_water *water, double length, double draw, double *distance);

#endif
