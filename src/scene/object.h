/* scene/object.h: the values of one object, a section [object.NAME] of scene text. */
#ifndef SCENE_OBJECT_H
#define SCENE_OBJECT_H

#include "base/param.h"

#define SCENE_OBJECTS_MAX 64
#define SCENE_OBJECT_NAME_SIZE 40 /* bytes of "object.NAME", its ending zero included */

struct scene_object {
    int shape;                      /* index into scene_shapes */
    char file[DPL_PARAM_TEXT_SIZE]; /* of a shape that is read from one */
    double position[3];             /* m, of the middle of its base */
    bool on_floor;                  /* position[1] counts from the floor, with its relief, and not from the water */
    double size[3];                 /* m, along x, y and z before it is turned */
    double turn, tilt;              /* degrees, about y; then of its top towards +x */
    double color[3];                /* reflectance; all zero: the shape's own */
    double second_color[3];         /* what its colour varies towards; all zero: the shape's own */
    int count;                      /* copies */
    double spread;                  /* m, radius of the disc that the copies stand in */
    double variation;               /* share of the size by which copies are smaller */
    int seed;                       /* of what is random in the shape and in the places of its copies */
    double sway;                    /* times as far as the shape's own */
    int pattern;                    /* enum world_pattern */
    double pattern_size;            /* m */
    double joint[3];                /* reflectance between a pattern's tiles */
    bool casts;                     /* throws a shadow */
};
extern const struct dpl_param scene_object_params[];

#endif
