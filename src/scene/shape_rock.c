/* A rock: broken along planes, with layers, cracks and growth. */
#include "scene/shape.h"
#include "scene/stone.h"

#include <math.h>

#define EDGE 0.013 /* m, of the triangles wanted */

static bool build(struct world_builder *builder, const struct scene_object *object, int seed)
{
    double largest = fmax(object->size[0], fmax(object->size[1], object->size[2]));
    /* An icosahedron's edge is about half as long as the ball around it is wide. */
    int divisions = (int)fmin(fmax(largest / 2 / EDGE, 8), 40);
    const struct stone_style style = {
        .divisions = divisions, .planes = 15, .roundness = 0.15, .roughness = 0.12, .layers = 5, .grown_over = true};
    return stone_build(builder, object, seed, &style);
}

const struct scene_shape shape_rock = {
    .name = "rock",
    .summary = "a rock with layers and cracks; second_color grows on it, low down and in hollows",
    .color = {{0.4, 0.35, 0.28}, {0.085, 0.1, 0.045}},
    .build = build,
};
