/* What solids and floor get from all around: traced at the vertices of solids and at a grid of points of the floor, and
 * kept until world or light change. */
#include "render/physical.h"

#include "base/log.h"
#include "reference/ambient.h"
#include "render/probes.h"
#include "render/traced_world.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MANY_VERTICES 20000 /* of a world for which that takes a while */
#define FLOOR_SIDE 48       /* points of the floor a side */
#define FLOOR_MARGIN 2.0    /* m of floor around the solids */
#define ABOVE_FLOOR 0.05    /* m that sight from one of them to the next passes above it */
#define BURIED 1e-2         /* of the brightest: darker is what lies within a solid */
#define APART 4             /* times as bright is what lies on another side of a wall; less may be one side's shade */
#define WHOLE_SPACING 0.3   /* m between the probes of a part that have all rays */
#define LEAST_RAYS 0.25     /* share of them */

/* A probe of a small part, which stands for little of a picture, has fewer rays. */
static int count_rays(const struct probes *probes, const struct probe *probe, int rays)
{
    return (int)(rays * fmax(fmin(probes->spacing[probe->part] / WHOLE_SPACING, 1), LEAST_RAYS));
}

static bool trace_probes(struct probes *probes, const struct traced_world *traced, int most, const struct dpl_log *log)
{
    size_t count = (size_t)probes->count;
    float *room = base_allocate(log, count * 9 + 1, sizeof *room, "ambient light");
    int *rays = base_allocate(log, count + 1, sizeof *rays, "ambient light");
    if (!room || !rays) {
        free(room);
        free(rays);
        return false;
    }
    float *places = room, *normals = room + 3 * count, *irradiance = room + 6 * count;
    for (size_t i = 0; i < count; i++) {
        memcpy(places + 3 * i, probes->all[i].position, 3 * sizeof *room);
        memcpy(normals + 3 * i, probes->all[i].normal, 3 * sizeof *room);
        rays[i] = count_rays(probes, probes->all + i, most);
    }
    bool ok = ambient_bake(&traced->camera, probes->count, places, normals, rays, irradiance, log);
    for (size_t i = 0; ok && i < count; i++)
        memcpy(probes->all[i].irradiance, irradiance + 3 * i, 3 * sizeof *room);
    free(room);
    free(rays);
    return ok;
}

static bool bake_solids(struct physical *physical, const struct frame *frame, const struct traced_world *traced)
{
    const struct dpl_log *log = frame->gl->log;
    const struct world *world = &physical->world;
    struct probes probes = {0};
    float *irradiance = base_allocate(log, (size_t)world->vertex_count * 3 + 1, sizeof *irradiance, "ambient light");
    bool ok = irradiance && probes_place(&probes, world, log) &&
              trace_probes(&probes, traced, physical->quality.ambient_rays, log);
    if (ok)
        probes_spread(&probes, world, irradiance);
    ok = ok && solids_upload(&physical->solids, frame->gl, world, irradiance);
    probes_finish(&probes);
    free(irradiance);
    return ok;
}

/* The square of floor around the solids: its least x and z, and its side; a point where there are none. */
static int frame_floor(const struct world *world, double square[3])
{
    square[0] = square[1] = 0;
    square[2] = 1;
    if (world->vertex_count == 0)
        return 1;
    square[2] = fmax(world->high[0] - world->low[0], world->high[2] - world->low[2]) + 2 * FLOOR_MARGIN;
    square[0] = (world->low[0] + world->high[0] - square[2]) / 2;
    square[1] = (world->low[2] + world->high[2] - square[2]) / 2;
    return FLOOR_SIDE;
}

/* Where light from all around is asked for on the floor: side × side places, and the upward normals there. */
static void place_floor(const struct physical *physical, const struct frame *frame, int side, float *places,
                        float *normals)
{
    const double *square = physical->seabed.ambient_square;
    const struct scene_settings *settings = &frame->scene->settings;
    for (int j = 0; j < side; j++) {
        for (int i = 0; i < side; i++) {
            double x = square[0] + (i + 0.5) / side * square[2], z = square[1] + (j + 0.5) / side * square[2], floor[3];
            world_floor(&physical->world, settings->size, x, z, floor);
            float *place = places + 3 * (j * side + i), *normal = normals + 3 * (j * side + i);
            place[0] = (float)x;
            place[1] = (float)(floor[0] - settings->depth);
            place[2] = (float)z;
            normal[1] = 1;
        }
    }
}

static float brightness(const float irradiance[3])
{
    return irradiance[0] + irradiance[1] + irradiance[2];
}

/* The index of the neighbour of a grid's place in one of eight directions; the place's own beyond the grid's edge. */
static int neighbour(int side, int index, int direction)
{
    static const int steps[8][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
    int x = index % side + steps[direction][0], z = index / side + steps[direction][1];
    return x >= 0 && x < side && z >= 0 && z < side ? z * side + x : index;
}

/* Light is interpolated between places, also between two that a wall parts. Lest it reach through, a place that has two
 * dark neighbours or more beyond a solid becomes as dark as the second darkest of them. */
static void part_place(int side, int index, const bool clear[8], const float *irradiance, float buried, float *texels)
{
    int found[2] = {index, index}; /* the darkest, the second darkest */
    for (int k = 0; k < 8; k++) {
        int other = neighbour(side, index, k);
        float dark = brightness(irradiance + 3 * other);
        bool apart = !clear[k] && dark > buried && (float)APART * dark < brightness(irradiance + 3 * index);
        if (apart && dark < brightness(irradiance + 3 * found[0])) {
            found[1] = found[0];
            found[0] = other;
        } else if (apart && dark < brightness(irradiance + 3 * found[1])) {
            found[1] = other;
        }
    }
    memcpy(texels + 4 * index, irradiance + 3 * found[1], 3 * sizeof *texels);
}

static bool part_floor(const struct traced_world *traced, int side, const float *places, const float *irradiance,
                       float *texels, const struct dpl_log *log)
{
    int count = side * side;
    float *pairs = base_allocate(log, (size_t)count * 8 * 6, sizeof *pairs, "ambient light"), most = 0;
    bool *clear = base_allocate(log, (size_t)count * 8, sizeof *clear, "ambient light");
    for (int i = 0; pairs && i < count * 8; i++) {
        int ends[2] = {i / 8, neighbour(side, i / 8, i % 8)};
        for (int k = 0; k < 6; k++)
            pairs[6 * i + k] = places[3 * ends[k / 3] + k % 3] + (k % 3 == 1 ? (float)ABOVE_FLOOR : 0);
        most = fmaxf(most, brightness(irradiance + 3 * ends[0]));
    }
    bool ok = pairs && clear && ambient_clear(&traced->camera, count * 8, pairs, clear, log);
    for (int i = 0; ok && i < count; i++)
        part_place(side, i, clear + 8 * i, irradiance, (float)BURIED * most, texels);
    free(pairs);
    free(clear);
    return ok;
}

static bool bake_floor(struct physical *physical, const struct frame *frame, const struct traced_world *traced)
{
    const struct dpl_log *log = frame->gl->log;
    struct seabed *seabed = &physical->seabed;
    int side = frame_floor(&physical->world, seabed->ambient_square);
    size_t count = (size_t)(side * side);
    float *room = base_allocate(log, count * 13, sizeof *room, "ambient light");
    int *rays = base_allocate(log, count, sizeof *rays, "ambient light");
    if (!room || !rays) {
        free(room);
        free(rays);
        return false;
    }
    float *places = room, *normals = room + 3 * count, *irradiance = room + 6 * count, *texels = room + 9 * count;
    place_floor(physical, frame, side, places, normals);
    for (size_t i = 0; i < count; i++)
        rays[i] = physical->quality.ambient_rays;
    bool ok = ambient_bake(&traced->camera, (int)count, places, normals, rays, irradiance, log) &&
              part_floor(traced, side, places, irradiance, texels, log);
    if (ok) {
        texture_resize(frame->gl, &seabed->ambient, GL_RGBA16F, side, side, TEXTURE_CLAMP, TEXTURE_LINEAR);
        texture_upload(frame->gl, &seabed->ambient, texels);
    }
    free(room);
    free(rays);
    return ok;
}

bool ambient_update(struct physical *physical, const struct frame *frame)
{
    const struct dpl_scene *scene = frame->scene;
    struct ambient_key key;
    memset(&key, 0, sizeof key);
    key.world = physical->world.fingerprint;
    key.sky = physical->sky.fingerprint;
    key.medium = scene->medium;
    key.settings = scene->settings;
    key.floor = scene->floor;
    key.rays = physical->quality.ambient_rays;
    if (!memcmp(&key, &physical->ambient, sizeof key))
        return true;
    struct traced_world traced = {0};
    if (physical->world.vertex_count > MANY_VERTICES)
        base_inform(frame->gl->log, "tracing the light from all around, once for this place");
    bool ok = traced_world_make(&traced, scene, &physical->world, &physical->sky, NULL, frame->above->periodic, 0,
                                frame->gl->log) &&
              bake_solids(physical, frame, &traced) && bake_floor(physical, frame, &traced);
    traced_world_finish(&traced);
    if (ok)
        physical->ambient = key;
    return ok;
}
