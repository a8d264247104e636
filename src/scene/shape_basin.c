/* A pool: walls of tiles that face the water, with a band in the second colour at their top, a coping, and a deck
 * around it. Its floor is the scene's. */
#include "scene/pieces.h"
#include "scene/shape.h"

#include <math.h>

#define BAND 0.45          /* m, height of the band */
#define COPING_WIDTH 0.35  /* m */
#define COPING_HEIGHT 0.06 /* m */
#define COPING_NOSE 0.03   /* m that it reaches over the water */
#define OVER 0.02          /* m that the walls reach behind the coping and below the floor */
#define DECK_WIDTH 2.5     /* m */
#define DECK_TILE 0.3      /* m */

static const double coping_color[3] = {0.62, 0.6, 0.55};
static const double deck_color[3] = {0.46, 0.42, 0.36};

/* One of the four sides, seen from the water. */
struct side {
    double x, z;      /* unit, from the middle of the pool to its wall */
    double out, half; /* m: to the wall; of its length */
    bool corners;     /* what lies outside the wall goes on around the corners */
};

/* Adds the part of a strip that begins at a way along the side, m from its middle. */
static void add_part(struct world_builder *builder, const struct side *side, const double low[2], const double high[2],
                     double begin, double length, double cell, const double color[3])
{
    const double corner[3] = {(side->out + low[1]) * side->x - begin * side->z, low[0],
                              (side->out + low[1]) * side->z + begin * side->x};
    const double right[3] = {-length * side->z, 0, length * side->x};
    const double up[3] = {(high[1] - low[1]) * side->x, high[0] - low[0], (high[1] - low[1]) * side->z};
    piece_panel(builder, corner, right, up, cell, color);
}

/* Adds a strip along the whole side, between two lines that each have a height and a way behind the wall. All are cut
 * where others end at the corners, so that they share their vertices with those beside them. */
static void add_strip(struct world_builder *builder, const struct side *side, const double low[2], const double high[2],
                      double cell, const double color[3])
{
    double half = side->half;
    if (low[1] != 0 || high[1] != 0) /* as far as the strips of the sides with corners begin or end */
        half += side->corners ? high[1] : low[1];
    const double nose = side->half - COPING_NOSE, deck = side->half + COPING_WIDTH;
    const double cuts[6] = {-half, -deck, -nose, nose, deck, half};
    double begin = -half;
    for (int i = 1; i < 6; i++) {
        if (cuts[i] <= begin || cuts[i] > half)
            continue;
        int first = builder->vertex_count;
        add_part(builder, side, low, high, begin, cuts[i] - begin, cell, color);
        piece_move_pattern(builder, first, begin + half, 0);
        begin = cuts[i];
    }
}

static double coping_base(const struct scene_object *object)
{
    return fmax(object->size[1] - COPING_HEIGHT, 0.5 * object->size[1]);
}

static void add_walls(struct world_builder *builder, const struct side *side, const struct scene_object *object)
{
    const struct world_part tiles = piece_material(object, WORLD_TILES);
    double top = coping_base(object), tile = tiles.pattern_size;
    double band = fmax(floor((top - BAND) / tile + 0.5) * tile, 0); /* between two rows of tiles */
    double behind = fmin(OVER, (object->size[1] - top) / 2);
    int first = builder->vertex_count;
    builder_part(builder, &tiles);
    add_strip(builder, side, (double[2]){-OVER, 0}, (double[2]){band, 0}, builder_cell(10), object->color);
    piece_move_pattern(builder, first, 0, -OVER);
    add_strip(builder, side, (double[2]){band, 0}, (double[2]){top + behind, 0}, builder_cell(10),
              object->second_color);
}

static void add_coping(struct world_builder *builder, const struct side *side, const struct scene_object *object)
{
    struct world_part stone = builder_material(object);
    double top = object->size[1], low = coping_base(object);
    stone.pattern = WORLD_PLAIN;
    builder_part(builder, &stone);
    add_strip(builder, side, (double[2]){low, 0}, (double[2]){low, -COPING_NOSE}, 0.25, coping_color);
    add_strip(builder, side, (double[2]){low, -COPING_NOSE}, (double[2]){top, -COPING_NOSE}, 0.25, coping_color);
    add_strip(builder, side, (double[2]){top, -COPING_NOSE}, (double[2]){top, COPING_WIDTH}, 0.25, coping_color);
}

static void add_deck(struct world_builder *builder, const struct side *side, const struct scene_object *object)
{
    struct world_part tiles = piece_material(object, WORLD_TILES);
    double top = object->size[1];
    tiles.pattern_size = DECK_TILE;
    builder_part(builder, &tiles);
    add_strip(builder, side, (double[2]){top, COPING_WIDTH}, (double[2]){top, COPING_WIDTH + DECK_WIDTH}, 0.25,
              deck_color);
}

static bool build(struct world_builder *builder, const struct scene_object *object, int seed)
{
    (void)seed; /* all pools are alike */
    double x = object->size[0] / 2, z = object->size[2] / 2;
    const struct side sides[4] = {{1, 0, x, z, false}, {-1, 0, x, z, false}, {0, 1, z, x, true}, {0, -1, z, x, true}};
    for (int s = 0; s < 4; s++)
        add_walls(builder, &sides[s], object);
    for (int s = 0; s < 4; s++)
        add_coping(builder, &sides[s], object);
    for (int s = 0; s < 4; s++)
        add_deck(builder, &sides[s], object);
    return builder_ok(builder);
}

const struct scene_shape shape_basin = {
    .name = "basin",
    .summary = "a pool's walls, coping and deck; size: inside, from the floor to the deck",
    .color = {{0.62, 0.74, 0.78}, {0.12, 0.3, 0.48}},
    .build = build,
};
