/* A sea cave in a cliff, seen from inside and from before its mouth, which is at +x: a vault whose rock lies in strata,
 * hard ones standing out, soft ones worn. It has no floor, so that its walls may go on below the water. */
#include "scene/noise.h"
#include "scene/shape.h"
#include "scene/world_builder.h"

#include "base/random.h"

#include <math.h>

#define AROUND 181   /* vertices from foot to foot over the vault */
#define VAULT 120    /* rows of these from the back to the mouth */
#define LIP 14       /* around the mouth's edge */
#define CLIFF 40     /* outwards over the cliff */
#define MOUTH 0.62   /* height and breadth of the mouth, of those of the cliff */
#define EDGE 0.06    /* of the length: radius of the mouth's edge */
#define STRATA 0.055 /* of the height, of a stratum */
#define LEAN 0.5     /* of the length: how far the top of the cliff leans back, times the square of its height */
#define LEDGE 0.25   /* of a stratum's height: where it goes over from the one below */
#define DIP 0.12     /* slope of the strata along x */

struct cave {
    const double *size;
    const double *colors[2];
    uint64_t seed;
    double scale; /* m: the size of its large forms */
};

/* The vault's outline on its way from the back, 0, to the mouth, 1. It closes as a sphere does. */
static void vault_point(const struct cave *cave, double along, double angle, double point[3])
{
    double back = fmin(along / 0.5, 1), round = sqrt(fmax(1 - (1 - back) * (1 - back), 0));
    double narrow = 1 - 0.2 * sin(M_PI * fmax(along - 0.45, 0) / 0.55); /* a neck before the mouth */
    double width = MOUTH * cave->size[2] / 2 * round * narrow;
    double height = MOUTH * cave->size[1] * round * (1 + 0.25 * sin(M_PI * fmin(along * 1.2, 1)));
    double c = cos(angle), s = sin(angle);
    /* rows stand closer at the back, where the vault turns */
    point[0] = cave->size[0] * (-0.5 + (1 - EDGE) * along * (0.4 + 0.6 * along));
    point[1] = height * pow(fabs(s), 0.8);
    point[2] = width * copysign(pow(fabs(c), 0.7), c);
}

/* From the mouth's outline, 0, around its edge, 1, and over the cliff, 2, to the box that it fills. */
static void cliff_point(const struct cave *cave, double out, double angle, double point[3])
{
    double radius = EDGE * cave->size[0], turn = fmin(out, 1) * M_PI / 2;
    vault_point(cave, 1, angle, point);
    double reach = fmin(cave->size[2] / 2 / fmax(fabs(point[2]), 1e-9), cave->size[1] / fmax(point[1], 1e-9));
    double away = 1 + radius * (1 - cos(turn)) / fmax(hypot(point[1], point[2]), radius);
    const double around[3] = {3 * cos(angle), 3 * sin(angle), 0};
    reach = fmax(reach * (0.85 + 0.3 * fmin(noise_fractal(around, 4, cave->seed + 100), 0.5)), away);
    away += (reach - away) * fmax(out - 1, 0);
    point[0] += radius * sin(turn);
    point[1] *= away;
    point[2] *= away;
    double lean = fmax(out - 1, 0) * point[1] / cave->size[1];
    point[0] -= LEAN * cave->size[0] * lean * lean;
}

/* How hard a stratum's rock is, 0 to 1. */
static double hardness(const struct cave *cave, double layer)
{
    double hard = random_fraction(cave->seed + 7 + (uint64_t)(int64_t)(layer + 1000));
    return hard * hard;
}

/* How far the rock stands out by its stratum, 0 to 1: hard ones do; where two meet, a ledge. */
static double ledge_at(const struct cave *cave, double height)
{
    double layer = floor(height), inside = height - layer, step = fmin(inside / LEDGE, 1);
    double below = hardness(cave, layer - 1), here = hardness(cave, layer);
    double worn = 1 - pow(fabs(2 * inside - 1), 4); /* rounded at its edges */
    return (below + (here - below) * step * step * (3 - 2 * step)) * (0.7 + 0.3 * worn);
}

/* What a place in the rock has of each kind of noise. */
struct noises {
    double bend, rough, cracks, grain, gap;
};

static struct noises noises_at(const struct cave *cave, const double place[3])
{
    double large[3], small[3], fine[3], block[3], distances[2];
    for (int c = 0; c < 3; c++) {
        large[c] = place[c] / cave->scale;
        small[c] = place[c] / (0.22 * cave->scale);
        fine[c] = place[c] / (0.035 * cave->scale);
        block[c] = place[c] / ((c == 1 ? 0.17 : 0.3) * cave->scale);
    }
    double bend = noise_fractal(large, 3, cave->seed), rough = noise_fractal(small, 4, cave->seed + 20);
    for (int c = 0; c < 3; c++)
        block[c] += 0.5 * rough;
    noise_cells(block, cave->seed + 80, distances);
    return (struct noises){bend, rough, noise_ridged(small, 3, cave->seed + 40),
                           noise_fractal(fine, 3, cave->seed + 60), fmin(10 * (distances[1] - distances[0]), 1)};
}

/* The rock at a place: how far it stands into the cave, m, and its colour. */
static double rock_at(const struct cave *cave, const double place[3], float color[3])
{
    const struct noises n = noises_at(cave, place);
    double height = (place[1] + DIP * place[0] + 0.12 * cave->scale * n.bend) / (STRATA * cave->size[1]);
    double ledge = ledge_at(cave, height);
    double tint = fmin(fmax(0.15 + 0.6 * hardness(cave, floor(height + 0.5)) + 0.5 * n.bend + 0.4 * n.rough, 0), 1);
    double shade = 0.6 + 0.25 * ledge + 0.4 * n.grain + 0.3 * n.gap - 0.3 * fmax(n.cracks - 0.5, 0);
    for (int c = 0; c < 3; c++)
        color[c] = (float)fmax(shade * (cave->colors[0][c] + tint * (cave->colors[1][c] - cave->colors[0][c])), 0);
    double in =
        0.2 * (n.bend + 0.5) + 0.14 * ledge + 0.1 * (n.rough + 0.5) - 0.04 * n.cracks + 0.02 * n.grain + 0.06 * n.gap;
    return cave->scale * fmax(in, 0);
}

/* Moves a point into the cave by what the rock stands out there: towards the middle, and over the cliff to the back. */
static void add_point(struct world_builder *builder, const struct cave *cave, const double base[3], double out)
{
    struct world_vertex vertex = {.place = {(float)base[0], (float)base[1]}};
    double in = rock_at(cave, base, vertex.color), flat = fmin(out, 1);
    double middle = 0.2 * MOUTH * cave->size[1];
    double towards[3] = {0, middle - base[1], -base[2]}, length = hypot(towards[1], towards[2]);
    double most = 0.6 * length;                                            /* the walls never meet */
    in = fmin(in, most) * (1 - 0.5 * exp(-4 * (out - 0.5) * (out - 0.5))); /* the mouth's edge does not fold */
    towards[1] = base[1] > middle ? towards[1] : 0;                        /* the feet stay as low as they are */
    for (int c = 0; c < 3; c++) {
        double moved = base[c] + (1 - flat) * in * (length > 0 ? towards[c] / length : 0);
        vertex.position[c] = (float)(c == 0 ? moved - flat * in : moved);
    }
    builder_vertex(builder, &vertex);
}

static bool build(struct world_builder *builder, const struct scene_object *object, int seed)
{
    const struct cave cave = {object->size,
                              {object->color, object->second_color},
                              (uint64_t)seed,
                              MOUTH * fmin(object->size[1], object->size[2] / 2)};
    struct world_part rock = builder_material(object);
    rock.two_sided = true; /* it is seen from above the cliff too */
    builder_part(builder, &rock);
    int vertex = builder->vertex_count, index = builder->index_count;
    for (int j = 0; j < VAULT + LIP + CLIFF; j++) {
        double out = j < VAULT ? 0 : j < VAULT + LIP ? (j - VAULT + 1.0) / LIP : 1 + (j - VAULT - LIP + 1.0) / CLIFF;
        for (int i = 0; i < AROUND; i++) {
            double angle = M_PI * i / (AROUND - 1), base[3];
            if (j < VAULT)
                vault_point(&cave, (double)j / (VAULT - 1), angle, base);
            else
                cliff_point(&cave, out, angle, base);
            add_point(builder, &cave, base, out);
        }
    }
    for (unsigned a = (unsigned)vertex; a < (unsigned)vertex + AROUND - 1; a++) /* the first row is one place */
        builder_triangle(builder, a, a + 1 + AROUND, a + AROUND);
    builder_grid(builder, (unsigned)vertex + AROUND, AROUND, VAULT + LIP + CLIFF - 1);
    builder_smooth(builder, vertex, index);
    return builder_ok(builder);
}

const struct scene_shape shape_cave = {
    .name = "cave",
    .summary = "a sea cave in a cliff, its mouth towards +x; size: of the cliff and the whole depth of the cave",
    .color = {{0.3, 0.25, 0.2}, {0.46, 0.36, 0.25}},
    .build = build,
};
