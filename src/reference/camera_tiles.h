/* reference/camera_tiles.h: where rays meet a height over the tile, repeated over a square or without end.
 *
 * Near the middle the height is a mesh of the surface's own grid, its normals interpolated between the vertices. Far
 * from it, where waves are smaller than what an eye tells apart, it is a plane that keeps the normals. */
#ifndef REFERENCE_CAMERA_TILES_H
#define REFERENCE_CAMERA_TILES_H

#include "base/log.h"
#include "water/surface.h"

#include <embree3/rtcore.h>

#define CAMERA_FARTHEST 2e4 /* m: beyond it lies the sky */

/* A ray between two distances, as Embree takes it. */
static inline struct RTCRay camera_ray_of(const double origin[3], const double direction[3], double near, double far)
{
    return (struct RTCRay){
        .org_x = (float)origin[0],
        .org_y = (float)origin[1],
        .org_z = (float)origin[2],
        .dir_x = (float)direction[0],
        .dir_y = (float)direction[1],
        .dir_z = (float)direction[2],
        .tnear = (float)near,
        .tfar = (float)far,
        .mask = ~0u,
    };
}

struct camera_tiles {
    RTCScene scene;                /* NULL: flat */
    const struct surface *surface; /* NULL: flat */
    double base, size;             /* m: height of the flat plane, side of the tile */
    double reach;                  /* m: half a side of the square that has a mesh */
    double half;                   /* m: half a side of all of it; may be INFINITY */
};

struct camera_tiles_hit {
    double distance;  /* m */
    double normal[3]; /* interpolated, upwards */
    double face[3];   /* of the mesh, upwards */
};

bool camera_tiles_make(struct camera_tiles *tiles, RTCDevice device, const struct surface *surface, double base,
                       double size, double half, const struct dpl_log *log);
void camera_tiles_finish(struct camera_tiles *tiles);

/* The first meeting farther than `near` and nearer than `far`. */
bool camera_tiles_meet(const struct camera_tiles *tiles, const double origin[3], const double direction[3], double near,
                       double far, struct camera_tiles_hit *hit);

/* True where anything of it stands in the way. */
bool camera_tiles_block(const struct camera_tiles *tiles, const double origin[3], const double direction[3],
                        double near, double far);

/* Height above the base at a place. Of choppy water: of what rests there. */
double camera_tiles_height(const struct camera_tiles *tiles, double x, double z);

#endif
