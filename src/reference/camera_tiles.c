#include "reference/camera_tiles.h"

#include "base/vector3.h"

#include <math.h>

#define REACH 32   /* most tiles of mesh on either side of the middle one */
#define CLIPPED 16 /* most meetings beyond the end of it that one ray leaves out */

/* Vertices of the tile with its far edges, where a periodic surface leaves them out. */
static bool fill_vertices(RTCGeometry geometry, const struct surface *surface, double base, int side)
{
    float *vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                              3 * sizeof *vertices, (size_t)side * (size_t)side);
    struct RTCGrid *grid = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_GRID, 0, RTC_FORMAT_GRID, sizeof *grid, 1);
    if (!vertices || !grid)
        return false;
    *grid = (struct RTCGrid){0, (unsigned)side, (unsigned short)side, (unsigned short)side};
    double spacing = surface_spacing(surface);
    for (int j = 0; j < side; j++) {
        for (int i = 0; i < side; i++) {
            size_t at = (size_t)(j % surface->rows) * (size_t)surface->columns + (size_t)(i % surface->columns);
            float *vertex = vertices + 3 * ((size_t)j * (size_t)side + (size_t)i);
            const float *shift = surface->shifts ? surface->shifts + 2 * at : (const float[2]){0, 0};
            vertex[0] = (float)(i * spacing - surface->size / 2) + shift[0];
            vertex[1] = (float)base + surface->texels[3 * at];
            vertex[2] = (float)(j * spacing - surface->size / 2) + shift[1];
        }
    }
    return true;
}

static bool make_mesh(RTCDevice device, RTCScene scene, const struct surface *surface, double base)
{
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_GRID);
    bool ok = fill_vertices(geometry, surface, base, surface->columns + (surface->periodic ? 1 : 0));
    if (ok) {
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
        rtcCommitScene(scene);
    }
    rtcReleaseGeometry(geometry);
    return ok;
}

static void repeat(RTCDevice device, RTCScene scene, RTCScene mesh, double size, int tiles)
{
    for (int j = -tiles; j <= tiles; j++) {
        for (int i = -tiles; i <= tiles; i++) {
            const float columns[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, (float)(i * size), 0, (float)(j * size)};
            RTCGeometry instance = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
            rtcSetGeometryInstancedScene(instance, mesh);
            rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
            rtcCommitGeometry(instance);
            rtcAttachGeometry(scene, instance);
            rtcReleaseGeometry(instance);
        }
    }
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene);
}

bool camera_tiles_make(struct camera_tiles *tiles, RTCDevice device, const struct surface *surface, double base,
                       double size, double half, const struct dpl_log *log)
{
    int repeats = surface && surface->periodic ? (int)fmin(ceil(half / size - 0.5), REACH) : 0;
    *tiles = (struct camera_tiles){NULL, surface, base, size, size * (repeats + 0.5), half};
    if (!surface)
        return true;
    if (!surface->periodic)
        tiles->half = fmin(half, size / 2);
    RTCScene mesh = rtcNewScene(device);
    bool ok = make_mesh(device, mesh, surface, base);
    tiles->scene = mesh;
    if (ok && repeats > 0) {
        tiles->scene = rtcNewScene(device);
        repeat(device, tiles->scene, mesh, size, repeats);
        rtcReleaseScene(mesh);
    }
    return (ok && rtcGetDeviceError(device) == RTC_ERROR_NONE) ||
           base_fail(log, DPL_REASON_LIMIT, "not enough memory for a mesh of %d x %d vertices", surface->columns,
                     surface->rows);
}

void camera_tiles_finish(struct camera_tiles *tiles)
{
    if (tiles->scene)
        rtcReleaseScene(tiles->scene);
    *tiles = (struct camera_tiles){0};
}

/* Numbers of the surface at a place in cells. */
static void look_up(const struct surface *surface, double column, double row, double normal[3])
{
    double texel[3];
    surface_blend(surface, column, row, texel);
    normal[0] = -texel[1];
    normal[1] = 1;
    normal[2] = -texel[2];
    vector3_normalize(normal);
}

static void place_in_cells(const struct camera_tiles *tiles, double x, double z, double place[2])
{
    double spacing = surface_spacing(tiles->surface);
    place[0] = (x + tiles->size / 2) / spacing;
    place[1] = (z + tiles->size / 2) / spacing;
}

static bool meet_plane(const struct camera_tiles *tiles, const double origin[3], const double direction[3], double near,
                       double far, struct camera_tiles_hit *hit)
{
    double distance = (tiles->base - origin[1]) / direction[1];
    if (!(distance > near && distance < far))
        return false;
    double x = origin[0] + direction[0] * distance, z = origin[2] + direction[2] * distance;
    double away = fmax(fabs(x), fabs(z));
    if (away > tiles->half || (tiles->surface && away <= tiles->reach))
        return false; /* beyond the end, or where the mesh is */
    *hit = (struct camera_tiles_hit){distance, {0, 1, 0}, {0, 1, 0}};
    if (tiles->surface) {
        double place[2];
        place_in_cells(tiles, x, z, place);
        look_up(tiles->surface, place[0], place[1], hit->normal);
    }
    return true;
}

/* The first meeting with the mesh that does not lie beyond the end. */
static bool trace_mesh(const struct camera_tiles *tiles, const double origin[3], const double direction[3], double near,
                       double far, struct RTCRayHit *ray)
{
    for (int i = 0; i < CLIPPED; i++) {
        struct RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        *ray = (struct RTCRayHit){.ray = camera_ray_of(origin, direction, near, far)};
        ray->hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(tiles->scene, &context, ray);
        if (ray->hit.geomID == RTC_INVALID_GEOMETRY_ID)
            return false;
        double distance = (double)ray->ray.tfar;
        if (fabs(origin[0] + direction[0] * distance) <= tiles->half &&
            fabs(origin[2] + direction[2] * distance) <= tiles->half)
            return true;
        near = distance + 1e-4 + 1e-6 * distance;
    }
    return false;
}

static bool meet_mesh(const struct camera_tiles *tiles, const double origin[3], const double direction[3], double near,
                      double far, struct camera_tiles_hit *hit)
{
    struct RTCRayHit ray;
    if (!trace_mesh(tiles, origin, direction, near, far, &ray))
        return false;
    const struct surface *surface = tiles->surface;
    int cells_x = surface->columns - (surface->periodic ? 0 : 1), cells_z = surface->rows - (surface->periodic ? 0 : 1);
    hit->distance = (double)ray.ray.tfar;
    look_up(surface, (double)ray.hit.u * cells_x, (double)ray.hit.v * cells_z, hit->normal);
    const double face[3] = {(double)ray.hit.Ng_x, (double)ray.hit.Ng_y, (double)ray.hit.Ng_z};
    vector3_scale(face, face[1] < 0 ? -1 : 1, hit->face);
    vector3_normalize(hit->face);
    return true;
}

bool camera_tiles_meet(const struct camera_tiles *tiles, const double origin[3], const double direction[3], double near,
                       double far, struct camera_tiles_hit *hit)
{
    far = fmin(far, CAMERA_FARTHEST);
    bool met = tiles->scene && meet_mesh(tiles, origin, direction, near, far, hit);
    return meet_plane(tiles, origin, direction, near, met ? hit->distance : far, hit) || met;
}

bool camera_tiles_block(const struct camera_tiles *tiles, const double origin[3], const double direction[3],
                        double near, double far)
{
    struct camera_tiles_hit hit;
    far = fmin(far, CAMERA_FARTHEST);
    if (meet_plane(tiles, origin, direction, near, far, &hit))
        return true;
    if (!tiles->scene || tiles->half < tiles->reach)
        return tiles->scene && meet_mesh(tiles, origin, direction, near, far, &hit);
    struct RTCRay ray = camera_ray_of(origin, direction, near, far);
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(tiles->scene, &context, &ray);
    return ray.tfar < 0;
}

double camera_tiles_height(const struct camera_tiles *tiles, double x, double z)
{
    double place[2], texel[3];
    if (!tiles->surface)
        return 0;
    place_in_cells(tiles, x, z, place);
    surface_blend(tiles->surface, place[0], place[1], texel);
    return texel[0];
}
