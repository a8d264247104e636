#include "reference/camera_scene.h"

#include "base/vector3.h"

#include <string.h>

#define GAP 1e-4     /* m that a ray leaves out at its start, so that it does not meet the surface that it comes from */
#define FLUSH 2e-3   /* m: a wall that near to the side of the water touches it, and there is no air between */
#define GAP_FAR 2e-6 /* the same for each metre from the middle of the scene, for the sake of the floats */

/* The triangles, or those of them that throw shadows, as a scene of their own. */
static RTCScene make_triangles(RTCDevice device, const struct camera_solids *solids, bool casting)
{
    size_t count = 0, vertices = (size_t)solids->vertex_count;
    for (int i = 0; i < solids->triangle_count; i++)
        count += !casting || !solids->casts || solids->casts[i];
    RTCScene scene = rtcNewScene(device);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float *positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                               3 * sizeof *positions, vertices);
    unsigned *indices =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof *indices, count);
    if (positions && indices) {
        memcpy(positions, solids->positions, vertices * 3 * sizeof *positions);
        for (int i = 0; i < solids->triangle_count; i++) {
            if (casting && solids->casts && !solids->casts[i])
                continue;
            memcpy(indices, solids->indices + 3 * i, 3 * sizeof *indices);
            indices += 3;
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
    }
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene);
    return scene;
}

static bool casts_all(const struct camera_solids *solids)
{
    bool all = true;
    for (int i = 0; solids->casts && i < solids->triangle_count; i++)
        all = all && solids->casts[i];
    return all;
}

static bool make_solids(struct camera_scene *scene, const struct dpl_log *log)
{
    const struct camera_solids *solids = &scene->world.solids;
    if (solids->triangle_count == 0)
        return true;
    scene->solids = make_triangles(scene->device, solids, false);
    if (casts_all(solids)) {
        rtcRetainScene(scene->solids);
        scene->casting = scene->solids;
    } else {
        scene->casting = make_triangles(scene->device, solids, true);
    }
    return rtcGetDeviceError(scene->device) == RTC_ERROR_NONE ||
           base_fail(log, DPL_REASON_LIMIT, "not enough memory for %d triangles", solids->triangle_count);
}

bool camera_scene_make(struct camera_scene *scene, const struct camera_world *world, const struct dpl_log *log)
{
    *scene = (struct camera_scene){.world = *world, .device = rtcNewDevice("threads=1")};
    if (!scene->device)
        return base_fail(log, DPL_REASON_LIMIT, "Embree does not start");
    bool ok =
        make_solids(scene, log) &&
        camera_tiles_make(&scene->floor, scene->device, world->solids.relief, -world->depth, world->size,
                          world->solids.floor, log) &&
        camera_tiles_make(&scene->water, scene->device, world->water.surface, 0, world->size, world->water.half, log);
    if (!ok)
        camera_scene_finish(scene);
    return ok;
}

void camera_scene_finish(struct camera_scene *scene)
{
    camera_tiles_finish(&scene->floor);
    camera_tiles_finish(&scene->water);
    if (scene->casting)
        rtcReleaseScene(scene->casting);
    if (scene->solids)
        rtcReleaseScene(scene->solids);
    if (scene->device)
        rtcReleaseDevice(scene->device);
    *scene = (struct camera_scene){0};
}

static double gap_at(const double origin[3])
{
    return GAP + GAP_FAR * fmax(fabs(origin[0]), fmax(fabs(origin[1]), fabs(origin[2])));
}

/* Normals of a triangle, turned to where the ray came from. */
static void finish_triangle(const struct camera_solids *solids, const struct RTCHit *met, const double direction[3],
                            struct camera_hit *hit)
{
    const unsigned *corners = solids->indices + (size_t)met->primID * 3;
    double u = (double)met->u, v = (double)met->v, weights[3] = {1 - u - v, u, v};
    const double face[3] = {(double)met->Ng_x, (double)met->Ng_y, (double)met->Ng_z};
    double normal[3] = {0, 0, 0};
    for (int k = 0; k < 3; k++)
        for (int c = 0; c < 3; c++)
            normal[c] += weights[k] * (double)solids->normals[3 * (size_t)corners[k] + (size_t)c];
    vector3_scale(face, vector3_dot(face, direction) > 0 ? -1 : 1, hit->face);
    vector3_normalize(hit->face);
    double side = vector3_dot(normal, hit->face), length = sqrt(vector3_dot(normal, normal));
    if (length > 0)
        vector3_scale(normal, (side < 0 ? -1 : 1) / length, hit->normal);
    if (!(length > 0) || vector3_dot(hit->normal, direction) >= 0)
        vector3_copy(hit->face, hit->normal); /* seen so flatly that the interpolated side looks away */
    hit->casts = !solids->casts || solids->casts[met->primID];
    solids->reflectance(solids->user, (int)met->primID, u, v, hit->reflectance);
}

static void meet_solids(const struct camera_scene *scene, const double origin[3], const double direction[3],
                        double near, struct camera_hit *hit)
{
    struct RTCRayHit ray = {.ray = camera_ray_of(origin, direction, near, hit->distance)};
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene->solids, &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return;
    hit->what = CAMERA_SOLID;
    hit->distance = (double)ray.ray.tfar;
    finish_triangle(&scene->world.solids, &ray.hit, direction, hit);
}

static void meet_floor(const struct camera_scene *scene, const double origin[3], const double direction[3], double near,
                       struct camera_hit *hit)
{
    const struct camera_solids *solids = &scene->world.solids;
    struct camera_tiles_hit met;
    if (!camera_tiles_meet(&scene->floor, origin, direction, near, hit->distance, &met))
        return;
    double side = vector3_dot(met.face, direction) > 0 ? -1 : 1;
    hit->what = CAMERA_SOLID;
    hit->casts = true;
    hit->distance = met.distance;
    vector3_scale(met.face, side, hit->face);
    vector3_scale(met.normal, side, hit->normal);
    if (vector3_dot(hit->normal, direction) >= 0)
        vector3_copy(hit->face, hit->normal);
    solids->floor_reflectance(solids->user, origin[0] + direction[0] * met.distance,
                              origin[2] + direction[2] * met.distance, hit->reflectance);
}

/* The upright sides of water that ends at the tile's edges. */
static bool meet_sides(const struct camera_scene *scene, const double origin[3], const double direction[3], double near,
                       struct camera_hit *hit)
{
    double half = scene->water.half;
    bool met = false;
    for (int k = 0; k < 4; k++) {
        int across = k & 2, along = 2 - across; /* x and z, or z and x */
        double sign = k & 1 ? 1 : -1, distance = (sign * half - origin[across]) / direction[across], place[3];
        if (!(distance > near && distance < hit->distance))
            continue;
        vector3_along(origin, direction, distance, place);
        if (fabs(place[along]) > half || place[1] < -scene->world.depth ||
            place[1] > camera_tiles_height(&scene->water, fmin(place[0], half), fmin(place[2], half)))
            continue;
        met = true;
        *hit = (struct camera_hit){.what = CAMERA_WATER, .distance = distance};
        hit->normal[across] = hit->face[across] = sign;
    }
    return met;
}

static bool meet_water(const struct camera_scene *scene, const double origin[3], const double direction[3], double near,
                       struct camera_hit *hit)
{
    struct camera_tiles_hit top;
    struct camera_hit side = {.what = CAMERA_NOTHING, .distance = hit->distance};
    bool met = camera_tiles_meet(&scene->water, origin, direction, near, hit->distance, &top);
    if (met) {
        side.distance = top.distance;
        *hit = (struct camera_hit){.what = CAMERA_WATER, .distance = top.distance};
        vector3_copy(top.normal, hit->normal);
        vector3_copy(top.face, hit->face);
    }
    if (isinf(scene->water.half) || !meet_sides(scene, origin, direction, near, &side))
        return met;
    *hit = side;
    return true;
}

bool camera_scene_water(const struct camera_scene *scene, const double origin[3], const double direction[3], double far,
                        struct camera_hit *hit)
{
    *hit = (struct camera_hit){.distance = fmin(far, CAMERA_FARTHEST)};
    if (!(scene->world.water.half > 0) || !meet_water(scene, origin, direction, gap_at(origin), hit))
        return false;
    vector3_along(origin, direction, hit->distance, hit->position);
    return true;
}

struct camera_hit camera_scene_hit(const struct camera_scene *scene, const double origin[3], const double direction[3])
{
    double near = gap_at(origin);
    struct camera_hit hit = {.distance = CAMERA_FARTHEST}, water;
    if (scene->solids)
        meet_solids(scene, origin, direction, near, &hit);
    if (scene->world.solids.floor > 0)
        meet_floor(scene, origin, direction, near, &hit);
    if (camera_scene_water(scene, origin, direction, hit.distance, &water)) {
        bool touched = water.normal[1] == 0 && hit.what == CAMERA_SOLID && hit.distance < water.distance + FLUSH;
        hit = touched ? hit : water;
    }
    vector3_along(origin, direction, hit.distance, hit.position);
    return hit;
}

bool camera_scene_clear(const struct camera_scene *scene, const double origin[3], const double direction[3],
                        double length)
{
    double near = gap_at(origin), far = fmin(length - near, CAMERA_FARTHEST);
    if (far <= near)
        return true;
    if (scene->world.solids.floor > 0 && camera_tiles_block(&scene->floor, origin, direction, near, far))
        return false;
    if (!scene->casting)
        return true;
    struct RTCRay ray = camera_ray_of(origin, direction, near, far);
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene->casting, &context, &ray);
    return ray.tfar >= 0;
}

bool camera_scene_lit(const struct camera_scene *scene, const struct camera_hit *water, const double to_sun[3])
{
    double inside[3];
    vector3_along(water->position, water->face, water->face[1] == 0 ? -FLUSH : 0, inside);
    return camera_scene_clear(scene, inside, to_sun, CAMERA_FARTHEST);
}

bool camera_scene_wet(const struct camera_scene *scene, const double place[3])
{
    static const double up[3] = {0, 1, 0};
    double half = scene->water.half;
    if (!(scene->world.water.half > 0))
        return false;
    if (fabs(place[0]) > half || fabs(place[2]) > half || (!isinf(half) && place[1] < -scene->world.depth))
        return false;
    return camera_tiles_block(&scene->water, place, up, 0, CAMERA_FARTHEST);
}
