#include "scene/look.h"

const char *look_name(int i)
{
    static const char *const names[] = {"collard", NULL};
    return names[i];
}

const struct dpl_param look_collard_params[] = {
    PARAM_FLOAT(struct look_collard, sand_share, 0.9, 0, 2, "", "floor: share of the sand's colour without caustics"),
    PARAM_FLOATS(struct look_collard, attenuation, 3, 0, 100, "",
                 "floor: a b c of the loss with depth g, min(a / (b g² + c g + 1), 1)", 2, 0.1, 0.1),
    PARAM_FLOAT(struct look_collard, brightest, 1.4, 0, 10, "", "floor: most light, in units of the sand's colour"),
    PARAM_FLOAT(struct look_collard, floor_tint, 0.25, 0, 1, "", "floor: share of the water's colour added"),
    PARAM_COLOR(struct look_collard, water_color, 1, "colour of the water", 0, 112.5 / 255, 1),
    PARAM_COLOR(struct look_collard, lamp_color, 4, "water: colour of the lamp", 0.9922, 0.9843, 0.8275),
    PARAM_FLOATS(struct look_collard, lamp_position, 3, -1000, 1000, "m", "water: place of the lamp", 2.5, 5, -10),
    PARAM_FLOAT(struct look_collard, ambient, 0.1, 0, 1, "", "water: share of the lamp's light from all around"),
    PARAM_FLOAT(struct look_collard, shininess, 256, 1, 4096, "", "water: exponent of the highlights (Phong)"),
    PARAM_FLOAT(struct look_collard, threshold, 0.3, 0, 2, "", "water: mean above which a highlight becomes white"),
    PARAM_END,
};
