/* scene/shape.h: the interface of a shape, which an object is made of, and the list of them.
 *
 * A shape is one file shape_NAME.c. A new one is a copy of shape_box.c and one line in shape.c. */
#ifndef SCENE_SHAPE_H
#define SCENE_SHAPE_H

#include "scene/object.h"

struct world_builder; /* scene/world_builder.h */

struct scene_shape {
    const char *name;
    const char *summary; /* one line */
    double color[2][3];  /* its own colours, where the object gives none */

    /* Adds one copy: y up from its base, whose middle is the origin, as large as object->size. What is asked for is in
     * range and its colours are filled in. Moving it to its place is the caller's work. `seed` differs from copy to
     * copy. False (logged) where it could not. */
    bool (*build)(struct world_builder *builder, const struct scene_object *object, int seed);
};

extern const struct scene_shape *const scene_shapes[]; /* ends with NULL */

/* The i-th shape's name, NULL past the last: the choices of `object.NAME.shape`. */
const char *scene_shape_name(int i);

#endif
