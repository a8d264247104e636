/* An aquarium without its panes, which are no triangles: the frame along the edges of the glass, on a table that
 * stands below the base. */
#include "scene/pieces.h"
#include "scene/shape.h"

#include <math.h>

#define FRAME 0.025       /* of the shortest side */
#define TABLE_HEIGHT 0.72 /* m */
#define TABLE_TOP 0.04    /* m */
#define TABLE_MARGIN 0.12 /* m around the tank */
#define LEG 0.06          /* m */

/* A bar along an axis at one of the four edges of that direction; it lies around the glass. */
static void add_bar(struct world_builder *builder, const struct scene_object *object, int axis, int edge, double thick)
{
    double low[3], high[3];
    for (int c = 0; c < 3; c++) {
        double first = c == 1 ? 0 : -object->size[c] / 2;
        int far = c == (axis + 1) % 3 ? edge & 1 : edge >> 1;
        low[c] = c == axis ? first : far ? first + object->size[c] - thick : first;
        high[c] = c == axis ? first + object->size[c] : low[c] + thick;
    }
    if (axis != 1) { /* upright bars reach from the lower to the upper ones */
        piece_block(builder, low, high, 0.1, object->second_color);
        return;
    }
    low[1] += thick;
    high[1] -= thick;
    piece_block(builder, low, high, 0.1, object->second_color);
}

static void add_table(struct world_builder *builder, const struct scene_object *object)
{
    struct world_part wood = piece_material(object, WORLD_PLANKS);
    const double x = object->size[0] / 2 + TABLE_MARGIN, z = object->size[2] / 2 + TABLE_MARGIN;
    for (int c = 0; c < 3 && object->pattern == WORLD_PLAIN; c++)
        wood.joint[c] = 0.3 * object->color[c];
    builder_part(builder, &wood);
    piece_block(builder, (double[3]){-x, -TABLE_TOP, -z}, (double[3]){x, 0, z}, 0.1, object->color);
    wood.pattern = WORLD_PLAIN;
    builder_part(builder, &wood);
    for (int leg = 0; leg < 4; leg++) {
        double a = leg & 1 ? x - LEG - 0.05 : -x + 0.05, b = leg & 2 ? z - LEG - 0.05 : -z + 0.05;
        piece_block(builder, (double[3]){a, -TABLE_HEIGHT, b}, (double[3]){a + LEG, -TABLE_TOP, b + LEG}, 0.1,
                    object->color);
    }
}

static bool build(struct world_builder *builder, const struct scene_object *object, int seed)
{
    (void)seed; /* all tanks are alike */
    struct world_part metal = builder_material(object);
    double thick = FRAME * fmin(object->size[0], fmin(object->size[1], object->size[2]));
    metal.pattern = WORLD_PLAIN;
    builder_part(builder, &metal);
    for (int axis = 0; axis < 3; axis++)
        for (int edge = 0; edge < 4; edge++)
            add_bar(builder, object, axis, edge, thick);
    add_table(builder, object);
    return builder_ok(builder);
}

const struct scene_shape shape_tank = {
    .name = "tank",
    .summary = "the frame of an aquarium, and a table that it stands on, 0.72 m high, below its base",
    .color = {{0.4, 0.25, 0.13}, {0.03, 0.03, 0.035}},
    .build = build,
};
