/* scene/look.h: the values of the renderer's looks. */
#ifndef SCENE_LOOK_H
#define SCENE_LOOK_H

#include "base/param.h"

enum scene_look { LOOK_COLLARD };
const char *look_name(int i);

/* [look.collard]: sections 3.5 and 3.6 of Collard & Mundi 2022. */
struct look_collard {
    /* floor */
    double sand_share;     /* of the sand's colour that shows without caustics */
    double attenuation[3]; /* a / (b g² + c g + 1), at most 1, g the depth */
    double brightest;      /* in units of the sand's colour */
    double floor_tint;     /* of the water's colour, added */
    /* water */
    double water_color[3], lamp_color[3], lamp_position[3];
    double ambient;
    double shininess;
    double threshold; /* mean of the highlight above which it is white */
};
extern const struct dpl_param look_collard_params[];

#endif
