/* A ball; stretched where its size differs along x, y and z. */
#include "scene/icosphere.h"
#include "scene/shape.h"

#include <math.h>

#define DIVISIONS 16

static bool build(struct world_builder *builder, const struct scene_object *object, int seed)
{
    (void)seed; /* all balls are alike */
    int first = icosphere_add(builder, DIVISIONS);
    for (int v = first; v < builder->vertex_count && builder_ok(builder); v++) {
        struct world_vertex *vertex = builder->vertices + v;
        double across = 0;
        for (int c = 0; c < 3; c++)
            across += pow((double)vertex->normal[c] / object->size[c], 2);
        for (int c = 0; c < 3; c++) {
            vertex->normal[c] = (float)((double)vertex->normal[c] / object->size[c] / sqrt(across));
            vertex->position[c] = (float)(object->size[c] / 2 * ((double)vertex->position[c] + (c == 1)));
            vertex->color[c] = (float)object->color[c];
        }
        vertex->place[0] = vertex->position[0];
        vertex->place[1] = vertex->position[1];
    }
    return builder_ok(builder);
}

const struct scene_shape shape_sphere = {
    .name = "sphere",
    .summary = "a ball, or an ellipsoid",
    .color = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}},
    .build = build,
};
