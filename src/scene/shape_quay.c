/* A quay: a wall of stone blocks that faces +z, weathered, with a coping in the second colour and bollards on it. */
#include "scene/noise.h"
#include "scene/pieces.h"
#include "scene/shape.h"

#include <math.h>
#include <string.h>

#define COPING 0.3          /* m, height of its stones */
#define COPING_NOSE 0.05    /* m before the wall */
#define BOLLARD_SPACING 5.0 /* m */
#define BOLLARD_HEIGHT 0.45 /* m */
#define BOLLARDS_MAX 200
#define ROUGHNESS 0.02 /* m that the face is in or out */

static const double bollard_color[3] = {0.05, 0.05, 0.055};

/* Pushes the vertices of a face in and out, less at its ends, and darkens what is low, where weed and wet are. */
static void weather(struct world_builder *builder, const struct scene_object *object, int first_vertex, int first_index,
                    int seed)
{
    for (int v = first_vertex; v < builder->vertex_count; v++) {
        struct world_vertex *vertex = builder->vertices + v;
        double place[3], up = (double)vertex->position[1] / object->size[1];
        for (int c = 0; c < 3; c++)
            place[c] = (double)vertex->position[c] * 1.7;
        double rough = noise_fractal(place, 4, (uint64_t)seed), stain = noise_fractal(place, 3, (uint64_t)seed + 50);
        double shade = fmin(fmax(0.55 + 0.6 * up + 0.35 * stain, 0.3), 1.1);
        double inside = fmin(fmax(object->size[0] / 2 - fabs((double)vertex->position[0]), 0) / 0.5, 1);
        vertex->position[2] += (float)(ROUGHNESS * inside * rough);
        for (int c = 0; c < 3; c++)
            vertex->color[c] *= (float)fmin(shade * (c == 1 ? 1 : 0.94 + 0.06 * up), 1);
    }
    builder_smooth(builder, first_vertex, first_index);
}

static void add_wall(struct world_builder *builder, const struct scene_object *object, int seed)
{
    const struct world_part blocks = piece_material(object, WORLD_BLOCKS);
    const double x = object->size[0], y = fmax(object->size[1] - COPING, 0.01), z = object->size[2];
    const double front = z / 2 - COPING_NOSE, cell = 0.12;
    builder_part(builder, &blocks);
    int vertex = builder->vertex_count, index = builder->index_count;
    piece_panel(builder, (double[3]){-x / 2, 0, front}, (double[3]){x, 0, 0}, (double[3]){0, y, 0}, cell,
                object->color);
    weather(builder, object, vertex, index, seed);
    piece_panel(builder, (double[3]){x / 2, 0, front}, (double[3]){0, 0, -z / 2 - front}, (double[3]){0, y, 0}, 0.25,
                object->color);
    piece_panel(builder, (double[3]){-x / 2, 0, -z / 2}, (double[3]){0, 0, z / 2 + front}, (double[3]){0, y, 0}, 0.25,
                object->color);
    piece_panel(builder, (double[3]){x / 2, 0, -z / 2}, (double[3]){-x, 0, 0}, (double[3]){0, y, 0}, 0.25,
                object->color);
}

static void add_bollards(struct world_builder *builder, const struct scene_object *object)
{
    const double h = BOLLARD_HEIGHT;
    const double profile[12][2] = {{0.2, 0},        {0.2, 0.05},      {0.2, 0.05},      {0.12, 0.07},
                                   {0.11, 0.15},    {0.11, h - 0.17}, {0.14, h - 0.11}, {0.19, h - 0.07},
                                   {0.2, h - 0.04}, {0.17, h - 0.01}, {0.1, h},         {0, h}};
    int count = (int)fmin(fmax(floor(object->size[0] / BOLLARD_SPACING), 1), BOLLARDS_MAX);
    for (int b = 0; b < count; b++) {
        const double place[3] = {object->size[0] * ((b + 0.5) / count - 0.5), object->size[1],
                                 object->size[2] / 2 - 0.4};
        int first = builder->vertex_count;
        builder_revolve(builder, profile, 12, 24, bollard_color);
        builder_place(builder, first, 0, 0, place);
    }
}

static bool build(struct world_builder *builder, const struct scene_object *object, int seed)
{
    const double x = object->size[0] / 2, y = object->size[1], z = object->size[2] / 2;
    struct world_part stone = piece_material(object, WORLD_BLOCKS), iron = stone;
    add_wall(builder, object, seed);
    stone.pattern_size = COPING;
    builder_part(builder, &stone);
    piece_block(builder, (double[3]){-x, fmax(y - COPING, 0), -z}, (double[3]){x, y, z}, 0.2, object->second_color);
    iron.pattern = WORLD_PLAIN;
    builder_part(builder, &iron);
    add_bollards(builder, object);
    return builder_ok(builder);
}

const struct scene_shape shape_quay = {
    .name = "quay",
    .summary = "a harbour's wall of stone blocks, facing +z, with a coping and bollards",
    .color = {{0.42, 0.4, 0.36}, {0.5, 0.48, 0.44}},
    .build = build,
};
