/* Seaweed: a clump of blades that rise, lean outwards, twist and taper; where it is tall, their edges are wavy as those
 * of kelp. */
#include "base/random.h"
#include "scene/shape.h"
#include "scene/world_builder.h"

#include <math.h>

#define STEPS 12        /* along a blade */
#define STEPS_TALL 24   /* along one of kelp, whose edges are frilled */
#define TALL 1.5        /* m: from here on it is kelp */
#define WIDTH 0.055     /* of a blade, in its height */
#define SWAY 0.2        /* of the tip, in the blade's height */
#define ROOT_SHADE 0.55 /* of the second colour, at the root */

struct blade {
    double root[2];       /* m */
    double height, width; /* m */
    double towards, lean; /* radians; m that its tip is off its root */
    double bend, phase;   /* m that it winds to either side; radians */
    double facing, twist; /* radians: of its width at the root; over its length */
    double frill;         /* that its edges stand out of its plane, in its width */
    double shade;
};

static struct blade make_blade(const struct scene_object *object, uint64_t seed, int index, int count)
{
    double out = 0.16 * sqrt((index + 0.5) / count), round = M_PI * (3 - sqrt(5)) * index, height = object->size[1];
    struct blade blade = {
        .root = {object->size[0] * out * cos(round), object->size[2] * out * sin(round)},
        .height = height * (index == 0 ? 1 : 0.5 + 0.48 * random_fraction(seed)),
        .towards = round + 1.2 * (random_fraction(seed + 1) - 0.5),
        .facing = 2 * M_PI * random_fraction(seed + 4),
        .twist = 3.4 * (random_fraction(seed + 3) - 0.5),
        .frill = height >= TALL ? 0.3 : 0.1,
        .phase = 2 * M_PI * random_fraction(seed + 5),
        .shade = 0.75 + 0.45 * random_fraction(seed + 6),
    };
    double radius = (0.45 - out) * hypot(object->size[0] * cos(blade.towards), object->size[2] * sin(blade.towards));
    blade.lean = 0.75 * radius * (0.5 + 0.5 * random_fraction(seed + 2));
    blade.bend = fmin(0.25 * radius, 0.06 * blade.height);
    blade.width = WIDTH * blade.height * (0.75 + 0.5 * random_fraction(seed + 7));
    return blade;
}

/* Where a blade is at a share of its length, and how wide; `across` is its unit direction from edge to edge. */
static double along_blade(const struct blade *blade, double share, double middle[3], double across[3])
{
    double out = blade->lean * share * share + blade->bend * share * sin(4.1 * share + 2 * blade->phase);
    double aside = blade->bend * share * sin(5.3 * share + blade->phase), turn = blade->facing + blade->twist * share;
    middle[0] = blade->root[0] + out * cos(blade->towards) - aside * sin(blade->towards);
    middle[1] = blade->height * share;
    middle[2] = blade->root[1] + out * sin(blade->towards) + aside * cos(blade->towards);
    across[0] = cos(turn);
    across[1] = 0;
    across[2] = sin(turn);
    double taper = sqrt(1 - share * share * share) * (0.4 + 0.6 * sin(M_PI * fmin(share * 1.6 + 0.1, 0.5)));
    return blade->width * taper;
}

/* `side`: -1 and 1 at the edges, 0 in the middle, which lies a little behind them: a groove. */
static void add_vertex(struct world_builder *builder, const struct scene_object *object, const struct blade *blade,
                       double share, int side)
{
    double middle[3], across[3], width = along_blade(blade, share, middle, across);
    double rise = middle[1] / object->size[1], shade = blade->shade * (ROOT_SHADE + (1 - ROOT_SHADE) * share);
    double off = side == 0 ? -0.12 : blade->frill * sin((side < 0 ? 19 : 23) * share + blade->phase);
    const double offset[3] = {side * 0.5 * across[0] - off * across[2], 0, side * 0.5 * across[2] + off * across[0]};
    struct world_vertex vertex = {.place = {(float)(side * width / 2), (float)(share * blade->height)},
                                  .sway = (float)(object->sway * SWAY * object->size[1] * rise * rise)};
    for (int c = 0; c < 3; c++) {
        double mixed = object->second_color[c] + (object->color[c] - object->second_color[c]) * share;
        vertex.position[c] = (float)(middle[c] + width * offset[c]);
        vertex.color[c] = (float)fmin(mixed * shade * (side == 0 ? 0.8 : 1), 1);
    }
    builder_vertex(builder, &vertex);
}

/* Three vertices across at each step, and one at the tip. */
static void add_blade(struct world_builder *builder, const struct scene_object *object, const struct blade *blade)
{
    int first_vertex = builder->vertex_count, first_index = builder->index_count;
    int steps = object->size[1] >= TALL ? STEPS_TALL : STEPS;
    unsigned first = (unsigned)first_vertex, tip = first + 3 * (unsigned)steps;
    for (int s = 0; s < steps; s++)
        for (int side = -1; side <= 1; side++)
            add_vertex(builder, object, blade, (double)s / steps, side);
    add_vertex(builder, object, blade, 1, 0);
    builder_grid(builder, first, 3, steps);
    builder_triangle(builder, tip - 3, tip - 2, tip);
    builder_triangle(builder, tip - 2, tip - 1, tip);
    builder_smooth(builder, first_vertex, first_index);
}

static bool build(struct world_builder *builder, const struct scene_object *object, int seed)
{
    struct world_part leaves = builder_material(object);
    uint64_t bits = random_mix((uint64_t)seed + 1);
    int count = 5 + (int)(8 * random_fraction(bits));
    leaves.two_sided = true;
    builder_part(builder, &leaves);
    for (int b = 0; b < count; b++) {
        const struct blade blade = make_blade(object, bits + 16 * (uint64_t)(b + 1), b, count);
        add_blade(builder, object, &blade);
    }
    return builder_ok(builder);
}

const struct scene_shape shape_seaweed = {
    .name = "seaweed",
    .summary = "a clump of blades, from second_color at the roots to color at the tips; from 1.5 m up wavy as kelp",
    .color = {{0.36, 0.44, 0.1}, {0.1, 0.14, 0.04}},
    .build = build,
};
