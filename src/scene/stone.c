/* A stone as seen from a point inside it: for every direction one distance, so that it never folds.
 *
 * 1. Planes around the point, along which it has broken: the distance is the least of theirs, its edges rounded.
 * 2. A mass that is not even: broad noise bends the faces.
 * 3. Layers of sediment, harder and softer ones, stand out and back.
 * 4. Ridges and pits, finer and finer.
 * 5. The ground cuts it off below.
 * 6. It is drawn out to the size that is asked for. */
#include "scene/stone.h"

#include "base/random.h"
#include "scene/icosphere.h"
#include "scene/noise.h"

#include <math.h>

#define PLANES_MAX 24
#define GROUND 0.42 /* half sizes from the middle down to the ground */

struct stone {
    const struct stone_style *style;
    uint64_t seed;
    double planes[PLANES_MAX][4]; /* unit normal, distance */
    double stretch[3];            /* the size, its largest being 1 */
    double bedding[3];            /* unit normal of the layers */
};

static double fraction(const struct stone *stone, int use)
{
    return random_fraction(stone->seed + (uint64_t)use);
}

/* A direction spread evenly over the sphere (Vogel 1979), a little off. */
static void spread_direction(const struct stone *stone, int index, int count, double out[3])
{
    double y = 1 - 2 * (index + 0.2 + 0.6 * fraction(stone, 3 * index)) / count;
    double angle = M_PI * (3 - sqrt(5)) * index + 0.9 * fraction(stone, 3 * index + 1), out_of_axis = sqrt(1 - y * y);
    out[0] = out_of_axis * cos(angle);
    out[1] = y;
    out[2] = out_of_axis * sin(angle);
}

static struct stone make_stone(const struct scene_object *object, int seed, const struct stone_style *style)
{
    struct stone stone = {.style = style, .seed = random_mix((uint64_t)seed + 1)};
    double largest = fmax(object->size[0], fmax(object->size[1], object->size[2]));
    for (int p = 0; p < style->planes; p++) {
        spread_direction(&stone, p, style->planes, stone.planes[p]);
        stone.planes[p][3] = 0.62 + 0.38 * fraction(&stone, 3 * p + 2);
    }
    for (int c = 0; c < 3; c++)
        stone.stretch[c] = object->size[c] / largest;
    double lean = 0.35 * (fraction(&stone, 100) - 0.5), towards = 2 * M_PI * fraction(&stone, 101);
    stone.bedding[0] = sin(lean) * cos(towards);
    stone.bedding[1] = cos(lean);
    stone.bedding[2] = sin(lean) * sin(towards);
    return stone;
}

/* The least of several distances, where they are nearly alike a little less than that (log-sum-exp). */
static double broken(const struct stone *stone, const double direction[3])
{
    double sharpness = 4 + 40 * pow(1 - stone->style->roundness, 2), sum = exp(-sharpness * 1.15);
    for (int p = 0; p < stone->style->planes; p++) {
        const double *plane = stone->planes[p];
        double cosine = plane[0] * direction[0] + plane[1] * direction[1] + plane[2] * direction[2];
        if (cosine > 0.05)
            sum += exp(-sharpness * fmin(plane[3] / cosine, 3));
    }
    return -log(sum) / sharpness;
}

/* How far its layer makes a place stand out, about -1 to 1; and the layer's shade, -1 to 1. */
static double layer_at(const struct stone *stone, const double place[3], double *shade)
{
    double along = 0;
    for (int c = 0; c < 3; c++)
        along += stone->bedding[c] * place[c] * stone->stretch[c];
    const double bent[3] = {place[0] * 1.3, place[1] * 1.3, place[2] * 1.3};
    along = (along + 0.07 * noise_smooth(bent, stone->seed + 7)) * stone->style->layers;
    double layer = floor(along), inside = along - layer;
    uint64_t bits = random_mix(stone->seed + 31) + (uint64_t)(int64_t)layer;
    double here = 2 * random_fraction(bits) - 1, next = 2 * random_fraction(bits + 1) - 1;
    double over = fmin(fmax((inside - 0.7) / 0.3, 0), 1);
    over *= over * (3 - 2 * over);
    *shade = here + (next - here) * over;
    return *shade - 0.5 * exp(-pow((inside - 0.85) / 0.08, 2)); /* the joint between two is washed out */
}

/* What the stone is like in one direction. */
struct facet {
    double distance; /* half sizes */
    double hollow;   /* 0 to 1: how deep in pits and furrows */
    double shade;    /* of its layer, -1 to 1 */
};

static struct facet facet_at(const struct stone *stone, const double direction[3])
{
    const struct stone_style *style = stone->style;
    struct facet facet = {.distance = broken(stone, direction)};
    double place[3], fine[3];
    for (int c = 0; c < 3; c++)
        place[c] = direction[c] * facet.distance * 1.4 * stone->stretch[c];
    facet.distance *= 1 + 0.35 * noise_fractal(place, 2, stone->seed + 11);
    for (int c = 0; c < 3; c++) {
        place[c] = direction[c] * facet.distance;
        fine[c] = place[c] * 2.2 * stone->stretch[c];
    }
    if (style->layers > 0)
        facet.distance += 0.4 * style->roughness * layer_at(stone, place, &facet.shade);
    for (int c = 0; c < 3; c++) /* bends the ridges, which would else run straight */
        place[c] = fine[c] +
                   0.35 * noise_smooth((const double[3]){fine[c] * 1.7, fine[(c + 1) % 3], 3.1 * c}, stone->seed + 13);
    double cells[2], ridges = noise_ridged(place, 5, stone->seed + 17);
    noise_cells(fine, stone->seed + 23, cells);
    double cracks = exp(-pow((cells[1] - cells[0]) / 0.07, 2));
    facet.distance += style->roughness * (1.1 * (ridges - 0.55) - 0.35 * cracks);
    facet.distance += 0.3 * style->roughness *
                      noise_fractal((const double[3]){fine[0] * 9, fine[1] * 9, fine[2] * 9}, 3, stone->seed + 29);
    facet.hollow = fmin(fmax(1.2 - 1.8 * ridges + 0.6 * cracks, 0), 1);
    return facet;
}

/* The ground cuts off what is below it; 0 to 1: how near to it the place is, in half of its height. */
static double cut_off(double position[3], double distance, const double direction[3])
{
    double ground = direction[1] < 0 ? GROUND / -direction[1] : INFINITY;
    for (int c = 0; c < 3; c++)
        position[c] = direction[c] * fmin(distance, ground);
    return 1 - fmin((position[1] + GROUND) / GROUND, 1);
}

/* 0 to 1: the share of the second colour. `low` is near 1 at the ground, `patches` about -0.5 to 0.5. */
static double second_share(const struct stone *stone, double low, double hollow, double patches)
{
    if (!stone->style->grown_over)
        return fmin(fmax(0.5 + 2 * patches, 0), 1);
    double growth = fmin(fmax(1.5 * low + 0.5 * hollow + 2 * patches - 0.25, 0), 1);
    return 0.9 * growth * growth * (3 - 2 * growth);
}

static void color_of(const struct stone *stone, const struct scene_object *object, const struct facet *facet,
                     const double position[3], double low, float color[3])
{
    const double place[3] = {position[0] * 2.5, position[1] * 2.5, position[2] * 2.5};
    const double grain[3] = {position[0] * 24, position[1] * 24, position[2] * 24};
    double patches = noise_fractal(place, 4, stone->seed + 37), speckle = noise_smooth(grain, stone->seed + 41);
    double shade = (1 + 0.22 * facet->shade + 0.4 * patches + 0.12 * speckle) * (1 - 0.5 * facet->hollow);
    double second = second_share(stone, low, facet->hollow, patches);
    if (stone->style->grown_over)
        shade *= 1 + 0.4 * fmin(fmax(position[1] * 1.5, 0), 1); /* bleached on top */
    for (int c = 0; c < 3; c++) {
        double mixed = object->color[c] * (1 - second) + object->second_color[c] * second;
        color[c] = (float)fmin(fmax(mixed * shade, 0.01), 0.95);
    }
}

/* Draws what lies between low and high out to the object's size, its base at y = 0. */
static void fit(struct world_builder *builder, int first, const double size[3])
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int v = first; v < builder->vertex_count; v++) {
        for (int c = 0; c < 3; c++) {
            low[c] = fmin(low[c], (double)builder->vertices[v].position[c]);
            high[c] = fmax(high[c], (double)builder->vertices[v].position[c]);
        }
    }
    for (int v = first; v < builder->vertex_count; v++) {
        struct world_vertex *vertex = builder->vertices + v;
        for (int c = 0; c < 3; c++) {
            double share = ((double)vertex->position[c] - low[c]) / (high[c] - low[c]);
            vertex->position[c] = (float)(size[c] * (c == 1 ? share : share - 0.5));
        }
        vertex->place[0] = vertex->position[0];
        vertex->place[1] = vertex->position[2];
    }
}

bool stone_build(struct world_builder *builder, const struct scene_object *object, int seed,
                 const struct stone_style *style)
{
    const struct stone stone = make_stone(object, seed, style);
    int first_index = builder->index_count, first = icosphere_add(builder, style->divisions);
    if (!builder_ok(builder))
        return false;
#pragma omp parallel for schedule(static)
    for (int v = first; v < builder->vertex_count; v++) {
        struct world_vertex *vertex = builder->vertices + v;
        const double direction[3] = {vertex->position[0], vertex->position[1], vertex->position[2]};
        double position[3];
        struct facet facet = facet_at(&stone, direction);
        double low = cut_off(position, facet.distance, direction);
        color_of(&stone, object, &facet, position, low, vertex->color);
        for (int c = 0; c < 3; c++)
            vertex->position[c] = (float)position[c];
    }
    fit(builder, first, object->size);
    builder_smooth(builder, first, first_index);
    return true;
}
