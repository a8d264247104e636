#include "render/traced_world.h"

#include "base/log.h"
#include "scene/sway.h"

#include <math.h>
#include <stdlib.h>

/* Reflectance of a triangle where its second and third vertices weigh u and v. */
static void solid_reflectance(const void *user, int triangle, double u, double v, double out[3])
{
    const struct traced_world *traced = user;
    const struct world *world = traced->solids;
    const double weights[3] = {1 - u - v, u, v};
    float color[3] = {0}, place[2] = {0}, reflectance[3];
    for (int k = 0; k < 3; k++) {
        const struct world_vertex *vertex = world->vertices + world->indices[3 * triangle + k];
        for (int c = 0; c < 3; c++)
            color[c] += (float)weights[k] * vertex->color[c];
        for (int c = 0; c < 2; c++)
            place[c] += (float)weights[k] * vertex->place[c];
    }
    world_color(world->parts + traced->parts[triangle], color, place, reflectance);
    for (int c = 0; c < 3; c++)
        out[c] = (double)reflectance[c];
}

/* Of a sandy floor: the texel there. */
static void sand_reflectance(const struct traced_world *traced, double x, double z, double out[3])
{
    const double size = traced->camera.size, place[2] = {x / size + 0.5, z / size + 0.5};
    int texel[2];
    for (int k = 0; k < 2; k++) {
        texel[k] = (int)((place[k] - floor(place[k])) * traced->sand_side);
        texel[k] = texel[k] < traced->sand_side ? texel[k] : traced->sand_side - 1;
    }
    const unsigned char *color = traced->sand + 4 * ((size_t)texel[1] * (size_t)traced->sand_side + (size_t)texel[0]);
    for (int c = 0; c < 3; c++)
        out[c] = color[c] / 255.0;
}

static void floor_reflectance(const void *user, double x, double z, double out[3])
{
    const struct traced_world *traced = user;
    const struct scene_floor *sea_floor = &traced->floor;
    struct world_part part = {.pattern = sea_floor->pattern, .pattern_size = sea_floor->pattern_size};
    float color[3], reflectance[3];
    const float place[2] = {(float)x, (float)z};
    if (traced->sand && part.pattern == WORLD_PLAIN) {
        sand_reflectance(traced, x, z, out);
        return;
    }
    for (int c = 0; c < 3; c++) {
        part.joint[c] = sea_floor->joint[c];
        color[c] = (float)sea_floor->color[c];
    }
    world_color(&part, color, place, reflectance);
    for (int c = 0; c < 3; c++)
        out[c] = (double)reflectance[c];
}

static bool make_solids(struct traced_world *traced, const struct dpl_scene *scene, double time,
                        const struct dpl_log *log)
{
    const struct world *world = traced->solids;
    size_t vertices = (size_t)world->vertex_count + 1, triangles = (size_t)world->index_count / 3 + 1;
    traced->positions = base_allocate(log, vertices * 3, sizeof *traced->positions, "traced solids");
    traced->normals = base_allocate(log, vertices * 3, sizeof *traced->normals, "traced solids");
    traced->casts = base_allocate(log, triangles, sizeof *traced->casts, "traced solids");
    traced->parts = base_allocate(log, triangles, sizeof *traced->parts, "traced solids");
    if (!traced->positions || !traced->normals || !traced->casts || !traced->parts)
        return false;
    struct sway sway;
    sway_now(scene, time, &sway);
    for (int i = 0; i < world->vertex_count; i++) {
        const struct world_vertex *vertex = world->vertices + i;
        float moved[3];
        sway_move(&sway, vertex->position, vertex->sway, moved);
        for (int c = 0; c < 3; c++) {
            traced->positions[3 * i + c] = vertex->position[c] + moved[c];
            traced->normals[3 * i + c] = vertex->normal[c];
        }
    }
    for (int p = 0; p < world->part_count; p++) {
        const struct world_part *part = world->parts + p;
        for (int t = part->first / 3; t < (part->first + part->count) / 3; t++) {
            traced->casts[t] = part->casts;
            traced->parts[t] = p;
        }
    }
    return true;
}

/* The relief's heights, and slopes, as a surface. */
static bool make_relief(struct traced_world *traced, double size, const struct dpl_log *log)
{
    const struct world *world = traced->solids;
    int side = world->relief_side;
    if (side == 0)
        return true;
    if (!surface_resize(&traced->relief, side, side, true, false, size, log))
        return false;
    for (int j = 0; j < side; j++) {
        for (int i = 0; i < side; i++) {
            double place[3];
            world_floor(world, size, (double)i / side * size - size / 2, (double)j / side * size - size / 2, place);
            for (int c = 0; c < 3; c++)
                traced->relief.texels[3 * (j * side + i) + c] = (float)place[c];
        }
    }
    return true;
}

bool traced_world_make(struct traced_world *traced, const struct dpl_scene *scene, const struct world *solids,
                       const struct optics_sky *sky, const struct surface *water, bool periodic, double time,
                       const struct dpl_log *log)
{
    traced_world_finish(traced);
    traced->floor = scene->floor;
    traced->solids = solids;
    if (!make_solids(traced, scene, time, log) || !make_relief(traced, scene->settings.size, log))
        return false;
    struct camera_world *camera = &traced->camera;
    const double half = periodic && scene->settings.edge == SCENE_EDGE_OPEN ? INFINITY : scene->settings.size / 2;
    *camera = (struct camera_world){
        .size = scene->settings.size,
        .depth = scene->settings.depth,
        .solids = {.vertex_count = solids->vertex_count,
                   .triangle_count = solids->index_count / 3,
                   .positions = traced->positions,
                   .normals = traced->normals,
                   .indices = solids->indices,
                   .casts = traced->casts,
                   .reflectance = solid_reflectance,
                   .floor = half,
                   .relief = solids->relief_side > 0 ? &traced->relief : NULL,
                   .floor_reflectance = floor_reflectance,
                   .user = traced},
        .water = {.half = half,
                  .surface = water,
                  .roughness = scene->medium.roughness,
                  .optics = water_optics(&scene->medium)},
        .sky = sky,
        .sun = optics_sun_disc(&scene->sun),
    };
    water_refractive_indices(&scene->medium, camera->water.ior);
    return true;
}

void traced_world_finish(struct traced_world *traced)
{
    free(traced->positions);
    free(traced->normals);
    free(traced->casts);
    free(traced->parts);
    surface_finish(&traced->relief);
    free(traced->sand);
    *traced = (struct traced_world){0};
}
