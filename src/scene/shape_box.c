/* A box whose faces have their own normals. */
#include "scene/shape.h"
#include "scene/world_builder.h"

#include <math.h>

static bool build(struct world_builder *builder, const struct scene_object *object, int seed)
{
    (void)seed; /* all boxes are alike */
    const double x = object->size[0], y = object->size[1], z = object->size[2];
    const struct {
        double corner[3], right[3], up[3];
    } faces[6] = {
        {{-x / 2, 0, z / 2}, {x, 0, 0}, {0, y, 0}},  {{x / 2, 0, -z / 2}, {-x, 0, 0}, {0, y, 0}},
        {{x / 2, 0, z / 2}, {0, 0, -z}, {0, y, 0}},  {{-x / 2, 0, -z / 2}, {0, 0, z}, {0, y, 0}},
        {{-x / 2, y, z / 2}, {x, 0, 0}, {0, 0, -z}}, {{-x / 2, 0, -z / 2}, {x, 0, 0}, {0, 0, z}},
    };
    double cell = builder_cell(fmax(x, fmax(y, z)));
    for (int f = 0; f < 6; f++)
        builder_face(builder, faces[f].corner, faces[f].right, faces[f].up, cell, object->color);
    return builder_ok(builder);
}

const struct scene_shape shape_box = {
    .name = "box",
    .summary = "a box",
    .color = {{0.45, 0.43, 0.4}, {0.45, 0.43, 0.4}},
    .build = build,
};
