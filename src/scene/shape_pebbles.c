/* A pebble, worn round; `count` makes a bed of them. */
#include "scene/shape.h"
#include "scene/stone.h"

static bool build(struct world_builder *builder, const struct scene_object *object, int seed)
{
    const struct stone_style style = {.divisions = 6, .planes = 9, .roundness = 0.85, .roughness = 0.03};
    return stone_build(builder, object, seed, &style);
}

const struct scene_shape shape_pebbles = {
    .name = "pebbles",
    .summary = "a pebble, worn round; count makes a bed of them, in shades from color to second_color",
    .color = {{0.5, 0.46, 0.4}, {0.2, 0.18, 0.16}},
    .build = build,
};
