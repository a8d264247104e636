/* A quay: a wall of stone blocks that faces +z, weathered, with a coping in the second colour and bollards on it. */
#include "scene/noise.h"
#include "scene/pieces.h"
#include "scene/shape.h"

#include <math.h>
#include <string.h>

#define COPING 0.3          /* m, height of its stones */
#define COPING_NOSE 0.05    /* m before the wall */
#define COPING_CELL 0.2     /* m */
#define OVER 0.01           /* m before the wall's other sides */
#define WALL_CELL 0.12      /* m */
#define BOLLARD_SPACING 5.0 /* m */
#define BOLLARD_HEIGHT 0.45 /* m */
#define BOLLARDS_MAX 200
#define ROUGHNESS 0.02 /* m that the face is in or out */

static const double bollard_color[3] = {0.05, 0.05, 0.055};

static double wall_front(const struct scene_object *object)
{
    return object->size[2] / 2 - fmin(COPING_NOSE, 0.1 * object->size[2]);
}

static double wall_side(const struct scene_object *object)
{
    return object->size[0] / 2 - fmin(OVER, 0.1 * object->size[0]);
}

static double coping_base(const struct scene_object *object)
{
    return fmax(object->size[1] - COPING, 0.5 * object->size[1]);
}

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
        double inside = fmin(fmax(wall_side(object) - fabs((double)vertex->position[0]), 0) / 0.5, 1);
        vertex->position[2] += (float)(ROUGHNESS * inside * rough);
        for (int c = 0; c < 3; c++)
            vertex->color[c] *= (float)fmin(shade * (c == 1 ? 1 : 0.94 + 0.06 * up), 1);
    }
    builder_smooth(builder, first_vertex, first_index);
}

/* Its sides share their vertices and reach into the coping. */
static void add_wall(struct world_builder *builder, const struct scene_object *object, int seed)
{
    const struct world_part blocks = piece_material(object, WORLD_BLOCKS);
    const double x = wall_side(object), front = wall_front(object);
    const double back = -object->size[2] / 2 + fmin(OVER, 0.1 * object->size[2]);
    const double up[3] = {0, (coping_base(object) + object->size[1]) / 2, 0}, *color = object->color;
    builder_part(builder, &blocks);
    int vertex = builder->vertex_count, index = builder->index_count;
    piece_panel(builder, (double[3]){-x, 0, front}, (double[3]){2 * x, 0, 0}, up, WALL_CELL, color);
    weather(builder, object, vertex, index, seed);
    piece_panel(builder, (double[3]){x, 0, front}, (double[3]){0, 0, back - front}, up, WALL_CELL, color);
    piece_panel(builder, (double[3]){-x, 0, back}, (double[3]){0, 0, front - back}, up, WALL_CELL, color);
    piece_panel(builder, (double[3]){x, 0, back}, (double[3]){-2 * x, 0, 0}, up, WALL_CELL, color);
}

/* The coping's profile: heights and ways in z. Its underside rises from behind the wall's face to the nose, so that it
 * is seen as the edge of a stone. */
struct profile {
    double low, nose, top, back, middle, front;
};

static struct profile coping_profile(const struct scene_object *object)
{
    const double low = coping_base(object), top = object->size[1], front = object->size[2] / 2;
    return (struct profile){low, low + (top - low) / 3, top, -front, 2 * wall_front(object) - front, front};
}

/* One end, at x, facing outwards. */
static void add_coping_end(struct world_builder *builder, const struct profile *p, double x, const double color[3])
{
    const double z[3] = {p->back, p->middle, p->front}, y[3] = {p->low, p->nose, p->top};
    for (int i = 0; i < 3; i++) { /* all but that under the nose */
        int column = i == 2, row = i > 0;
        double width = z[column + 1] - z[column];
        piece_panel(builder, (double[3]){x, y[row], x > 0 ? z[column + 1] : z[column]},
                    (double[3]){0, 0, x > 0 ? -width : width}, (double[3]){0, y[row + 1] - y[row], 0}, COPING_CELL,
                    color);
    }
    unsigned corners[3];
    for (int i = 0; i < 3; i++) {
        const double at[3][2] = {{p->low, p->middle}, {p->nose, p->middle}, {p->nose, p->front}};
        corners[i] =
            builder_vertex(builder, &(struct world_vertex){.position = {(float)x, (float)at[i][0], (float)at[i][1]},
                                                           .normal = {x > 0 ? 1 : -1, 0, 0},
                                                           .color = {(float)color[0], (float)color[1], (float)color[2]},
                                                           .place = {(float)at[i][1], (float)at[i][0]}});
    }
    builder_triangle(builder, corners[0], corners[x > 0 ? 1 : 2], corners[x > 0 ? 2 : 1]);
}

/* Its faces share their vertices. */
static void add_coping(struct world_builder *builder, const struct scene_object *object)
{
    const double x = object->size[0] / 2, *color = object->second_color;
    const struct profile p = coping_profile(object);
    const double line[8][2] = {{p.low, p.middle}, {p.nose, p.front}, {p.top, p.front}, {p.top, p.middle},
                               {p.top, p.back},   {p.nose, p.back},  {p.low, p.back},  {p.low, p.middle}};
    struct world_part stone = piece_material(object, WORLD_BLOCKS);
    stone.pattern_size = COPING;
    builder_part(builder, &stone);
    for (int i = 0; i < 7; i++) {
        int first = builder->vertex_count;
        piece_panel(builder, (double[3]){-x, line[i][0], line[i][1]}, (double[3]){2 * x, 0, 0},
                    (double[3]){0, line[i + 1][0] - line[i][0], line[i + 1][1] - line[i][1]}, COPING_CELL, color);
        if (line[i][0] == p.top && line[i][1] == p.middle) /* the top goes on */
            piece_move_pattern(builder, first, 0, p.front - p.middle);
    }
    add_coping_end(builder, &p, x, color);
    add_coping_end(builder, &p, -x, color);
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
    struct world_part iron = piece_material(object, WORLD_BLOCKS);
    add_wall(builder, object, seed);
    add_coping(builder, object);
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
