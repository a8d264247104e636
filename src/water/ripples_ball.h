/* water/ripples_ball.h: the ball of the model `ripples`: the water that it displaces, and how it moves by itself. */
#ifndef WATER_RIPPLES_BALL_H
#define WATER_RIPPLES_BALL_H

#include "water/water.h"

/* The pool that it is in. Wallace's lengths are in half sides of the pool. */
struct ball_pool {
    double half;    /* m, half a side */
    double depth;   /* m */
    double gravity; /* m/s² */
};

struct ball {
    double center[3], radius; /* m */
};

/* The water that the ball displaces at a point of the surface, as a height (m); 0 farther than ball_reach(). */
float ball_volume(const struct ball *ball, const struct ball_pool *pool, double x, double z);

/* m from its middle */
double ball_reach(const struct ball *ball);

/* One step of BALL_TICK seconds: weight, buoyancy, drag, and the floor. */
#define BALL_TICK (1.0 / 60)
void ball_move(struct ball *ball, const struct ball_pool *pool, double velocity[3]);

#endif
