/* water/ripples_tank.h: the water of the model `ripples` on its grid, and what can happen to it. */
#ifndef WATER_RIPPLES_TANK_H
#define WATER_RIPPLES_TANK_H

#include "water/ripples_ball.h"

/* All that changes water is one of these. */
enum ripples_kind { RIPPLES_STEP, RIPPLES_DROP, RIPPLES_MOVE };
struct ripples_event {
    enum ripples_kind kind;
    struct water_drop drop;
    struct ball from, to; /* the ball, which makes room for water and takes it elsewhere */
};

/* All zero: none yet. */
struct tank {
    int side;       /* vertices */
    double spacing; /* m */
    double damping; /* of the speed, a step */
    struct ball_pool pool;
    float *heights; /* side × side, m */
    float *speeds;  /* m a step; heights less speeds are the heights a step before */
};

/* Makes room for side × side vertices. */
bool tank_resize(struct tank *tank, int side, const struct dpl_log *log);

/* Leaves it zeroed. */
void tank_finish(struct tank *tank);

/* Water at rest at that height. */
void tank_calm(struct tank *tank, float height);

/* Mean of the heights. */
float tank_level(const struct tank *tank);

void tank_apply(struct tank *tank, const struct ripples_event *event);

#endif
