#include "scene/world_builder.h"

#include "base/log.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool builder_ok(const struct world_builder *builder)
{
    return !builder->failed;
}

void builder_finish(struct world_builder *builder)
{
    free(builder->vertices);
    free(builder->indices);
    free(builder->parts);
    io_mesh_finish(&builder->mesh);
    *builder = (struct world_builder){0};
}

/* Makes room for `wanted` items; the larger of that and twice as many as there was room for. */
static void *grow(struct world_builder *builder, void *items, int *room, int wanted, int most, size_t size)
{
    if (builder->failed || wanted <= *room)
        return items;
    builder->failed = wanted > most;
    if (builder->failed) {
        base_fail(builder->log, DPL_REASON_LIMIT,
                  "%s: the objects of the scene are too large: %d (at most %d vertices and %d triangles)",
                  builder->name, wanted, WORLD_VERTICES_MAX, WORLD_INDICES_MAX / 3);
        return items;
    }
    int larger = *room < most / 2 ? *room * 2 : most;
    larger = larger > wanted ? larger : wanted;
    void *grown = realloc(items, (size_t)larger * size);
    builder->failed = !grown;
    if (grown)
        *room = larger;
    else
        base_fail(builder->log, DPL_REASON_LIMIT, "%s: out of memory for triangles: %zu bytes", builder->name,
                  (size_t)larger * size);
    return grown ? grown : items;
}

struct world_part builder_material(const struct scene_object *object)
{
    struct world_part part = {.pattern = object->pattern, .pattern_size = object->pattern_size, .casts = object->casts};
    memcpy(part.joint, object->joint, sizeof part.joint);
    return part;
}

static bool same_material(const struct world_part *a, const struct world_part *b)
{
    return a->pattern == b->pattern && a->pattern_size == b->pattern_size && a->two_sided == b->two_sided &&
           a->casts == b->casts && !memcmp(a->joint, b->joint, sizeof a->joint);
}

void builder_part(struct world_builder *builder, const struct world_part *material)
{
    const int most = WORLD_INDICES_MAX / 3;
    if (builder->part_count > 0 && builder->parts[builder->part_count - 1].count == 0)
        builder->part_count--;
    int last = builder->part_count - 1;
    if (last >= 0 && same_material(builder->parts + last, material))
        return;
    builder->parts = grow(builder, builder->parts, &builder->part_room, last + 2, most, sizeof *builder->parts);
    if (builder->failed)
        return;
    builder->parts[last + 1] = *material;
    builder->parts[last + 1].first = builder->index_count;
    builder->parts[last + 1].count = 0;
    builder->part_count++;
}

unsigned builder_vertex(struct world_builder *builder, const struct world_vertex *vertex)
{
    builder->vertices = grow(builder, builder->vertices, &builder->vertex_room, builder->vertex_count + 1,
                             WORLD_VERTICES_MAX, sizeof *builder->vertices);
    if (builder->failed)
        return 0;
    builder->vertices[builder->vertex_count] = *vertex;
    return (unsigned)builder->vertex_count++;
}

void builder_triangle(struct world_builder *builder, unsigned a, unsigned b, unsigned c)
{
    builder->indices = grow(builder, builder->indices, &builder->index_room, builder->index_count + 3,
                            WORLD_INDICES_MAX, sizeof *builder->indices);
    if (builder->failed)
        return;
    unsigned *corners = builder->indices + builder->index_count;
    corners[0] = a;
    corners[1] = b;
    corners[2] = c;
    builder->index_count += 3;
    builder->parts[builder->part_count - 1].count += 3;
}

static void turn_vector(float vector[3], const double rows[3][3])
{
    const double v[3] = {vector[0], vector[1], vector[2]};
    for (int c = 0; c < 3; c++)
        vector[c] = (float)(rows[c][0] * v[0] + rows[c][1] * v[1] + rows[c][2] * v[2]);
}

void builder_place(struct world_builder *builder, int first_vertex, double turn, double tilt, const double position[3])
{
    double a = turn * M_PI / 180, b = tilt * M_PI / 180;
    const double rows[3][3] = {
        {cos(a) * cos(b), cos(a) * sin(b), -sin(a)}, {-sin(b), cos(b), 0}, {sin(a) * cos(b), sin(a) * sin(b), cos(a)}};
    for (int v = first_vertex; v < builder->vertex_count; v++) {
        struct world_vertex *vertex = builder->vertices + v;
        turn_vector(vertex->position, rows);
        turn_vector(vertex->normal, rows);
        for (int c = 0; c < 3; c++)
            vertex->position[c] += (float)position[c];
    }
}
