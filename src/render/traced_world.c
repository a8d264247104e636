#include "render/traced_world.h"

#include "base/log.h"
#include "scene/sway.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Between the three corners of a triangle. */
static void blend(const float *const corners[3], double u, double v, int count, float *out)
{
    const double weights[3] = {1 - u - v, u, v};
    for (int c = 0; c < count; c++)
        out[c] = (float)(weights[0] * (double)corners[0][c] + weights[1] * (double)corners[1][c] +
                         weights[2] * (double)corners[2][c]);
}

static void solid_reflectance(const void *user, int triangle, double u, double v, double out[3])
{
    const struct traced_world *traced = user;
    const struct world *solids = traced->solids;
    const unsigned *corners = solids->indices + (size_t)triangle * 3;
    const struct world_vertex *a = solids->vertices + corners[0], *b = solids->vertices + corners[1],
                              *d = solids->vertices + corners[2];
    float color[3], place[2], reflectance[3];
    blend((const float *const[3]){a->color, b->color, d->color}, u, v, 3, color);
    blend((const float *const[3]){a->place, b->place, d->place}, u, v, 2, place);
    world_color(solids->parts + traced->parts[triangle], color, place, reflectance);
    for (int c = 0; c < 3; c++)
        out[c] = (double)reflectance[c];
}

static void sand_reflectance(const struct traced_world *traced, double x, double z, double out[3])
{
    double size = traced->scene->settings.size, side = traced->sand_side;
    double column = (x / size + 0.5), row = (z / size + 0.5);
    int i = (int)((column - floor(column)) * side), j = (int)((row - floor(row)) * side);
    int last = traced->sand_side - 1;
    const unsigned char *texel =
        traced->sand + 4 * ((size_t)(j < last ? j : last) * (size_t)traced->sand_side + (size_t)(i < last ? i : last));
    for (int c = 0; c < 3; c++)
        out[c] = texel[c] / 255.0;
}

static void floor_reflectance(const void *user, double x, double z, double out[3])
{
    const struct traced_world *traced = user;
    const struct scene_floor *floor_ = &traced->scene->floor;
    struct world_part part = {.pattern = floor_->pattern, .pattern_size = floor_->pattern_size};
    float color[3], reflectance[3];
    const float place[2] = {(float)x, (float)z};
    if (floor_->pattern == WORLD_PLAIN && traced->sand) {
        sand_reflectance(traced, x, z, out);
        return;
    }
    for (int c = 0; c < 3; c++) {
        color[c] = (float)floor_->color[c];
        part.joint[c] = floor_->joint[c];
    }
    world_color(&part, color, place, reflectance);
    for (int c = 0; c < 3; c++)
        out[c] = (double)reflectance[c];
}

static bool copy_solids(struct traced_world *traced, double time, const struct dpl_log *log)
{
    const struct world *solids = traced->solids;
    size_t vertices = (size_t)solids->vertex_count, triangles = (size_t)solids->index_count / 3;
    traced->positions = base_allocate(log, vertices * 3 + 1, sizeof *traced->positions, "solids");
    traced->normals = base_allocate(log, vertices * 3 + 1, sizeof *traced->normals, "solids");
    traced->casts = base_allocate(log, triangles + 1, sizeof *traced->casts, "solids");
    traced->parts = base_allocate(log, triangles + 1, sizeof *traced->parts, "solids");
    if (!traced->positions || !traced->normals || !traced->casts || !traced->parts)
        return false;
    struct sway sway;
    sway_now(traced->scene, time, &sway);
    for (size_t i = 0; i < vertices; i++) {
        const struct world_vertex *vertex = solids->vertices + i;
        float moved[3];
        sway_move(&sway, vertex->position, vertex->sway, moved);
        for (size_t c = 0; c < 3; c++) {
            traced->positions[3 * i + c] = vertex->position[c] + moved[c];
            traced->normals[3 * i + c] = vertex->normal[c];
        }
    }
    for (int p = 0; p < solids->part_count; p++) {
        for (int i = 0; i < solids->parts[p].count / 3; i++) {
            traced->parts[solids->parts[p].first / 3 + i] = p;
            traced->casts[solids->parts[p].first / 3 + i] = solids->parts[p].casts;
        }
    }
    return true;
}

static bool copy_relief(struct traced_world *traced, const struct dpl_log *log)
{
    const struct world *solids = traced->solids;
    int side = solids->relief_side;
    double size = traced->scene->settings.size;
    if (side == 0)
        return true;
    if (!surface_resize(&traced->relief, side, side, true, false, size, log))
        return false;
    for (int j = 0; j < side; j++) {
        for (int i = 0; i < side; i++) {
            double at[3];
            world_floor(solids, size, (double)i / side * size - size / 2, (double)j / side * size - size / 2, at);
            for (int c = 0; c < 3; c++)
                traced->relief.texels[3 * (j * side + i) + c] = (float)at[c];
        }
    }
    traced->world.solids.relief = &traced->relief;
    return true;
}

/* Half a side of the square that the water fills: as the scene says, or without end, or the tile. */
static double water_half(const struct dpl_scene *scene)
{
    struct wave waves[WATER_WAVES_MAX];
    struct water_setup setup = scene_water_setup(scene, waves);
    if (scene->settings.extent > 0)
        return scene->settings.extent / 2;
    return water_models[scene->medium.model]->shape(&setup).periodic ? INFINITY : scene->settings.size / 2;
}

bool traced_world_make(struct traced_world *traced, const struct dpl_scene *scene, const struct world *solids,
                       const struct optics_sky *sky, double time, const struct dpl_log *log)
{
    *traced = (struct traced_world){.solids = solids, .scene = scene};
    if (!copy_solids(traced, time, log) || !copy_relief(traced, log)) {
        traced_world_finish(traced);
        return false;
    }
    traced->world.size = scene->settings.size;
    traced->world.depth = scene->settings.depth;
    traced->world.sky = sky;
    traced->world.sun = optics_sun_disc(&scene->sun);
    struct camera_solids *plain = &traced->world.solids;
    plain->vertex_count = solids->vertex_count;
    plain->triangle_count = solids->index_count / 3;
    plain->positions = traced->positions;
    plain->normals = traced->normals;
    plain->indices = solids->indices;
    plain->casts = traced->casts;
    plain->reflectance = solid_reflectance;
    plain->floor = scene->floor.extent > 0 ? scene->floor.extent / 2 : INFINITY;
    plain->floor_reflectance = floor_reflectance;
    plain->user = traced;
    traced->world.water.half = water_half(scene);
    traced->world.water.roughness = scene->medium.roughness;
    traced->world.water.optics = water_optics(&scene->medium);
    water_refractive_indices(&scene->medium, traced->world.water.ior);
    return true;
}

void traced_world_finish(struct traced_world *traced)
{
    free(traced->positions);
    free(traced->normals);
    free(traced->casts);
    free(traced->parts);
    free(traced->sand);
    surface_finish(&traced->relief);
    *traced = (struct traced_world){0};
}
