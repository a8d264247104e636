/* Steps down into a pool, from its wall at the smallest z: each has a strip in the second colour at its edge. */
#include "scene/pieces.h"
#include "scene/shape.h"

#include <math.h>

#define RISE 0.24 /* m, of a step, at most */
#define STEPS_MAX 200
#define STRIP 0.05 /* m, of the edge's strip */

/* One step, whose top is at that height, from its riser at `front` back to that of the next one, or the wall. */
static void add_step(struct world_builder *builder, const struct scene_object *object, double low, double high,
                     double front, double back)
{
    const double x = object->size[0], wall = -object->size[2] / 2, rise = high - low, strip = fmin(STRIP, front - back);
    const double *color = object->color, *edge = object->second_color;
    double cell = builder_cell(4);
    piece_panel(builder, (double[3]){-x / 2, low, front}, (double[3]){x, 0, 0}, (double[3]){0, rise - strip, 0}, cell,
                color);
    piece_panel(builder, (double[3]){-x / 2, high - strip, front}, (double[3]){x, 0, 0}, (double[3]){0, strip, 0}, cell,
                edge);
    piece_panel(builder, (double[3]){-x / 2, high, front}, (double[3]){x, 0, 0}, (double[3]){0, 0, -strip}, cell, edge);
    if (front - strip > back)
        piece_panel(builder, (double[3]){-x / 2, high, front - strip}, (double[3]){x, 0, 0},
                    (double[3]){0, 0, back - front + strip}, cell, color);
    piece_panel(builder, (double[3]){-x / 2, low, wall}, (double[3]){0, 0, front - wall}, (double[3]){0, rise, 0}, cell,
                color);
    piece_panel(builder, (double[3]){x / 2, low, front}, (double[3]){0, 0, wall - front}, (double[3]){0, rise, 0}, cell,
                color);
}

static bool build(struct world_builder *builder, const struct scene_object *object, int seed)
{
    (void)seed; /* all steps are alike */
    const struct world_part tiles = piece_material(object, WORLD_TILES);
    int steps = (int)fmin(ceil(object->size[1] / RISE), STEPS_MAX);
    double rise = object->size[1] / steps, tread = object->size[2] / steps;
    builder_part(builder, &tiles);
    for (int s = 0; s < steps; s++)
        add_step(builder, object, s * rise, (s + 1) * rise, object->size[2] / 2 - s * tread,
                 object->size[2] / 2 - (s + 1) * tread);
    return builder_ok(builder);
}

const struct scene_shape shape_steps = {
    .name = "steps",
    .summary = "a flight of steps, up towards its -z, where the wall is",
    .color = {{0.66, 0.74, 0.76}, {0.1, 0.22, 0.4}},
    .build = build,
};
