/* A hall around a pool, seen from inside: walls, a ceiling with beams, and in the wall at +x tall windows, open to sun
 * and sky, with bars. It has no floor: a basin's deck is one. */
#include "scene/pieces.h"
#include "scene/shape.h"

#include <math.h>

#define WINDOW_SPACING 2.4 /* m between the middles of windows, at most */
#define WINDOW_SHARE 0.72  /* of the spacing that is open */
#define WINDOWS_MAX 64
#define SILL 0.08 /* of the height */
#define LINTEL 0.84
#define OVER 0.02        /* m that walls and ceiling reach through each other, and below the deck */
#define REVEAL 0.3       /* m, thickness of the wall with windows */
#define BAR 0.05         /* m, of a window's bars */
#define BEAM_SPACING 2.5 /* m, at most */
#define BEAM_WIDTH 0.22  /* m */
#define BEAM_HEIGHT 0.45 /* m, at most a twelfth of the hall's */

static const double beam_color[3] = {0.38, 0.24, 0.13};
static const double bar_color[3] = {0.2, 0.21, 0.22};

static void add_walls(struct world_builder *builder, const struct scene_object *object, double cell)
{
    const double x = object->size[0], y = object->size[1], z = object->size[2];
    piece_panel_over(builder, (double[3]){-x / 2, 0, z / 2}, (double[3]){0, 0, -z}, (double[3]){0, y, 0}, OVER, cell,
                     object->color);
    piece_panel_over(builder, (double[3]){-x / 2, 0, -z / 2}, (double[3]){x, 0, 0}, (double[3]){0, y, 0}, OVER, cell,
                     object->color);
    piece_panel_over(builder, (double[3]){x / 2, 0, z / 2}, (double[3]){-x, 0, 0}, (double[3]){0, y, 0}, OVER, cell,
                     object->color);
    piece_panel_over(builder, (double[3]){-x / 2, y, -z / 2}, (double[3]){x, 0, 0}, (double[3]){0, 0, z}, OVER, cell,
                     object->second_color);
}

/* A part of the wall at +x, from z0 to z1 and y0 to y1, facing -x. */
static void add_pier(struct world_builder *builder, const struct scene_object *object, const double z[2],
                     const double y[2], double cell)
{
    int first = builder->vertex_count;
    piece_panel(builder, (double[3]){object->size[0] / 2, y[0], z[0]}, (double[3]){0, 0, z[1] - z[0]},
                (double[3]){0, y[1] - y[0], 0}, cell, object->color);
    piece_move_pattern(builder, first, z[0] + object->size[2] / 2, y[0]);
}

/* That wall from z0 to z1: from below the deck to the sill, from there to the lintel if it is closed there, and on to
 * behind the ceiling. Parts side by side share their vertices. */
static void add_piers(struct world_builder *builder, const struct scene_object *object, double z0, double z1,
                      bool closed, double cell)
{
    const double sill = SILL * object->size[1], lintel = LINTEL * object->size[1], z[2] = {z0, z1};
    add_pier(builder, object, z, (double[2]){-OVER, sill}, cell);
    if (closed)
        add_pier(builder, object, z, (double[2]){sill, lintel}, cell);
    add_pier(builder, object, z, (double[2]){lintel, object->size[1] + OVER}, cell);
}

/* The four inner sides of an opening. They share their vertices with each other and the wall. */
static void add_reveal(struct world_builder *builder, const struct scene_object *object, const double z[2],
                       const double y[2], double cell)
{
    const double x = object->size[0] / 2, *color = object->color;
    const double back[3] = {REVEAL, 0, 0}, front[3] = {-REVEAL, 0, 0}, up[3] = {0, y[1] - y[0], 0};
    const double along[3] = {0, 0, z[1] - z[0]};
    piece_panel(builder, (double[3]){x, y[0], z[0]}, back, up, cell, color);
    piece_panel(builder, (double[3]){x + REVEAL, y[0], z[1]}, front, up, cell, color);
    piece_panel(builder, (double[3]){x, y[0], z[0]}, along, back, cell, color);
    piece_panel(builder, (double[3]){x + REVEAL, y[1], z[0]}, along, front, cell, color);
}

static void add_bars(struct world_builder *builder, const struct scene_object *object, const double z[2],
                     const double y[2])
{
    const double x = object->size[0] / 2 + 0.6 * REVEAL, h = BAR / 2, middle = (z[0] + z[1]) / 2;
    piece_block(builder, (double[3]){x - h, y[0], middle - h}, (double[3]){x + h, y[1], middle + h}, 0.25, bar_color);
    for (int side = 0; side < 2; side++) {
        double at = side ? z[1] - h : z[0] + h;
        piece_block(builder, (double[3]){x - h, y[0], at - h}, (double[3]){x + h, y[1], at + h}, 0.25, bar_color);
    }
    for (int row = 0; row <= 4; row++) {
        double at = y[0] + h + (y[1] - y[0] - BAR) * row / 4;
        piece_block(builder, (double[3]){x - 0.8 * h, at - h, z[0]}, (double[3]){x + 0.8 * h, at + h, z[1]}, 0.25,
                    bar_color);
    }
}

static void add_windows(struct world_builder *builder, const struct scene_object *object, double cell)
{
    const double length = object->size[2];
    int count = (int)fmin(ceil(length / WINDOW_SPACING), WINDOWS_MAX);
    double spacing = length / count, open = WINDOW_SHARE * spacing, end = -length / 2 - OVER;
    for (int w = 0; w < count; w++) {
        double middle = length * ((w + 0.5) / count - 0.5);
        const double z[2] = {middle - open / 2, middle + open / 2};
        const double y[2] = {SILL * object->size[1], LINTEL * object->size[1]};
        add_piers(builder, object, end, z[0], true, cell);
        add_piers(builder, object, z[0], z[1], false, cell);
        add_reveal(builder, object, z, y, cell);
        add_bars(builder, object, z, y);
        end = z[1];
    }
    add_piers(builder, object, end, length / 2 + OVER, true, cell);
}

/* Under the ceiling, from the wall with windows to the one across. */
static void add_beams(struct world_builder *builder, const struct scene_object *object)
{
    const double x = object->size[0], y = object->size[1], z = object->size[2], high = fmin(BEAM_HEIGHT, y / 12);
    int count = (int)fmin(ceil(z / BEAM_SPACING), WINDOWS_MAX);
    for (int b = 0; b < count; b++) {
        double middle = -z / 2 + z * (b + 0.5) / count;
        piece_block(builder, (double[3]){-x / 2, y - high, middle - BEAM_WIDTH / 2},
                    (double[3]){x / 2, y, middle + BEAM_WIDTH / 2}, 0.2, beam_color);
    }
}

static bool build(struct world_builder *builder, const struct scene_object *object, int seed)
{
    (void)seed; /* all halls are alike */
    double cell = builder_cell(fmax(object->size[0], object->size[2]));
    add_walls(builder, object, cell);
    add_windows(builder, object, cell);
    add_beams(builder, object);
    return builder_ok(builder);
}

const struct scene_shape shape_hall = {
    .name = "hall",
    .summary = "walls and ceiling of an indoor hall, seen from inside, with tall windows at its +x",
    .color = {{0.72, 0.7, 0.65}, {0.74, 0.73, 0.7}},
    .build = build,
};
