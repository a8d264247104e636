/* A pool's ladder: two tubes that rise before the wall, arch over its edge and stand on the deck, and treads between
 * them. The water is on the side of +z; the deck is RAIL below the top. */
#include "scene/pieces.h"
#include "scene/shape.h"

#include <math.h>

#define RAIL 0.7         /* m, from the deck to the top of the arch, in a ladder that is that high */
#define TUBE 0.02        /* m, radius */
#define TREAD_STEP 0.25  /* m between treads */
#define TREAD_WIDTH 0.09 /* m */
#define TREAD_HEIGHT 0.025
#define TREADS_MAX 100
#define ARCH_POINTS 17
#define FOOT_POINTS 6 /* from the arch to the deck */
#define POINTS (ARCH_POINTS + FOOT_POINTS + 40 + 6)

static double rail_height(const struct scene_object *object)
{
    return fmin(RAIL, 0.6 * object->size[1]);
}

/* The line of a tube: its foot bends to the wall; straight up; half an ellipse; down to the deck. */
static int tube_line(const struct scene_object *object, double x, double line[POINTS][3])
{
    double reach = object->size[2] / 2 - TUBE, arch = fmin(reach, 0.5 * rail_height(object)), count = 0;
    double straight = object->size[1] - TUBE - arch, bend = fmin(0.1, straight / 4);
    int p = 0;
    for (int i = 0; i < 6; i++, p++) {
        double angle = M_PI / 2 * i / 5;
        line[p][2] = reach - bend + bend * sin(angle);
        line[p][1] = TUBE + bend - bend * cos(angle);
    }
    count = fmin(fmax(ceil((straight - bend) / 0.1), 1), 40);
    for (int i = 1; i < count; i++, p++) {
        line[p][2] = reach;
        line[p][1] = TUBE + bend + (straight - bend - TUBE) * i / count;
    }
    for (int i = 0; i < ARCH_POINTS; i++, p++) {
        double angle = M_PI * i / (ARCH_POINTS - 1);
        line[p][2] = reach * cos(angle);
        line[p][1] = straight + arch * sin(angle);
    }
    for (int i = 1; i <= FOOT_POINTS; i++, p++) {
        line[p][2] = -reach;
        line[p][1] = straight + (object->size[1] - rail_height(object) - straight) * i / FOOT_POINTS;
    }
    for (int i = 0; i < p; i++)
        line[i][0] = x;
    return p;
}

static void add_tube(struct world_builder *builder, const struct scene_object *object, double x)
{
    double line[POINTS][3];
    int points = tube_line(object, x, line);
    double deck = object->size[1] - rail_height(object), foot = line[points - 1][2];
    const double flange[4][2] = {{2.2 * TUBE, 0}, {2.2 * TUBE, 0.015}, {2.2 * TUBE, 0.015}, {0, 0.015}};
    piece_tube(builder, line, points, TUBE, 16, object->color);
    int first = builder->vertex_count;
    builder_revolve(builder, flange, 4, 16, object->color);
    builder_place(builder, first, 0, 0, (double[3]){x, deck, foot});
}

static void add_treads(struct world_builder *builder, const struct scene_object *object, double half)
{
    double reach = object->size[2] / 2 - TUBE, deck = object->size[1] - rail_height(object);
    int count = (int)fmin(floor((deck - 0.1) / TREAD_STEP), TREADS_MAX);
    for (int t = 0; t < count; t++) {
        double top = deck - 0.1 - t * TREAD_STEP;
        piece_block(builder, (double[3]){-half, top - TREAD_HEIGHT, reach - TREAD_WIDTH / 2},
                    (double[3]){half, top, reach + TREAD_WIDTH / 2}, 0.06, object->second_color);
    }
}

static bool build(struct world_builder *builder, const struct scene_object *object, int seed)
{
    (void)seed; /* all ladders are alike */
    double half = fmax(object->size[0] / 2 - TUBE, TUBE);
    add_tube(builder, object, -half);
    add_tube(builder, object, half);
    add_treads(builder, object, half);
    return builder_ok(builder);
}

const struct scene_shape shape_ladder = {
    .name = "ladder",
    .summary = "a pool's ladder of steel, the water on its +z; its arch stands 0.7 m above the deck",
    .color = {{0.56, 0.57, 0.58}, {0.7, 0.7, 0.7}},
    .build = build,
};
