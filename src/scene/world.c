#include "scene/world.h"

#include "base/hash.h"
#include "scene/scene.h"
#include "scene/world_copies.h"
#include "scene/world_floor.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static uint64_t fingerprint_of(const struct dpl_scene *scene)
{
    uint64_t value = hash_number(hash_start, scene->settings.size);
    value = hash_number(value, scene->settings.depth);
    value = hash_number(value, scene->settings.seed);
    value = hash_number(value, scene->current.strength);
    value = hash_number(value, scene->floor.relief_height);
    value = hash_number(value, scene->floor.relief_length);
    value = hash_number(value, scene->floor.relief_turn);
    value = hash_bytes(value, scene->floor.relief_map, sizeof scene->floor.relief_map);
    for (int o = 0; o < scene->object_count; o++) {
        value = hash_bytes(value, scene->object_names[o], strlen(scene->object_names[o]) + 1);
        value = hash_params(value, scene_object_params, scene->objects + o);
    }
    return value ? value : 1; /* 0: no world yet */
}

static float highest_corner(const struct world *world, const unsigned *corners)
{
    float y = world->vertices[corners[0]].position[1];
    for (int k = 1; k < 3; k++)
        y = fmaxf(y, world->vertices[corners[k]].position[1]);
    return y;
}

void world_box(const struct world *world, double strength, double level, double low[3], double high[3])
{
    for (int c = 0; c < 3; c++) {
        low[c] = INFINITY;
        high[c] = -INFINITY;
    }
    for (int i = 0; i < world->index_count; i++) {
        if ((double)highest_corner(world, world->indices + i - i % 3) < level)
            continue;
        const struct world_vertex *vertex = world->vertices + world->indices[i];
        double reach = strength * (double)vertex->sway;
        for (int c = 0; c < 3; c++) {
            low[c] = fmin(low[c], (double)vertex->position[c] - reach);
            high[c] = fmax(high[c], (double)vertex->position[c] + reach);
        }
    }
}

static bool build_objects(struct world *world, const struct dpl_scene *scene, const struct dpl_log *log)
{
    struct world_builder builder = {.log = log};
    for (int o = 0; o < scene->object_count; o++) {
        if (!copies_build(&builder, world, scene, o)) {
            builder_finish(&builder);
            return false;
        }
    }
    world->vertices = builder.vertices;
    world->indices = builder.indices;
    world->parts = builder.parts;
    world->vertex_count = builder.vertex_count;
    world->index_count = builder.index_count;
    world->part_count = builder.part_count;
    io_mesh_finish(&builder.mesh);
    world_box(world, scene->current.strength, -INFINITY, world->low, world->high);
    return true;
}

bool world_build(struct world *world, const struct dpl_scene *scene, const struct dpl_log *log)
{
    struct world fresh = {.fingerprint = fingerprint_of(scene)};
    if (fresh.fingerprint == world->fingerprint)
        return true;
    if (!floor_build(&fresh, scene, log) || !build_objects(&fresh, scene, log)) {
        world_finish(&fresh);
        return false;
    }
    world_finish(world);
    *world = fresh;
    return true;
}

void world_finish(struct world *world)
{
    free(world->vertices);
    free(world->indices);
    free(world->parts);
    free(world->relief);
    *world = (struct world){0};
}
