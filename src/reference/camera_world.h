/* reference/camera_world.h: what light meets on the way to a picture, as plain numbers: for who traces it.
 *
 * All of it belongs to the caller and outlives what is made from it. Metres; unit vectors; linear red green blue. */
#ifndef REFERENCE_CAMERA_WORLD_H
#define REFERENCE_CAMERA_WORLD_H

#include "optics/sky.h"
#include "optics/water_types.h"
#include "water/surface.h"

/* Triangles, and a floor. Both throw light back in all directions alike (Lambert 1760), on the side that is lit. */
struct camera_solids {
    int vertex_count, triangle_count;
    const float *positions, *normals; /* vertex_count × 3 */
    const unsigned *indices;          /* triangle_count × 3 */
    const bool *casts;                /* of each triangle: it throws shadows in the sun; NULL: all do */
    /* Reflectance of a triangle where its second and third vertices weigh u and v. */
    void (*reflectance)(const void *user, int triangle, double u, double v, double out[3]);

    double floor;                 /* m: half a side of the square that it fills at -depth; 0: none */
    const struct surface *relief; /* heights above -depth; NULL: flat */
    void (*floor_reflectance)(const void *user, double x, double z, double out[3]);
    const void *user;
};

/* Water from its surface down to -depth. */
struct camera_water {
    double half; /* m: half a side of the block that it fills, INFINITY: it has no end; 0: there is none */
    const struct surface *surface; /* NULL: at rest */
    double ior[3];
    double roughness; /* root mean square of slopes that the surface's grid is too coarse for */
    struct optics_water optics;
};

struct camera_world {
    double size, depth; /* m, of the tile */
    struct camera_solids solids;
    struct camera_water water;
    const struct optics_sky *sky;
    struct optics_disc sun;
};

#endif
