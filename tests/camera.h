/* tests/camera.h: a world of plain things to trace: a sky of one radiance, a sun, a floor, water at rest, a box. */
#ifndef TESTS_CAMERA_H
#define TESTS_CAMERA_H

#include "support.h"

#include "reference/ambient.h"
#include "reference/camera_path.h"

#include <math.h>

struct place {
    float texels[SKY_ROWS * SKY_COLUMNS * 3];
    struct optics_sky sky;
    struct camera_world world;
    double floor[3]; /* reflectance of the floor, and of solids */
    double solids[3];
    float positions[24 * 3], normals[24 * 3];
    unsigned indices[36];
    struct surface water;
};

/* A mesh of the water, flat; the caller may fill it with waves. */
static inline struct surface *at_rest(struct place *place)
{
    assert_true(surface_resize(&place->water, 512, 512, true, false, place->world.size, NULL));
    return &place->water;
}

static inline void floor_reflectance(const void *user, double x, double z, double out[3])
{
    const struct place *place = user;
    (void)x;
    (void)z;
    for (int c = 0; c < 3; c++)
        out[c] = place->floor[c];
}

static inline void solid_reflectance(const void *user, int triangle, double u, double v, double out[3])
{
    const struct place *place = user;
    (void)triangle;
    assert_true(u >= -1e-6 && v >= -1e-6 && u + v <= 1 + 1e-6);
    for (int c = 0; c < 3; c++)
        out[c] = place->solids[c];
}

/* The whole sky alike, and below the horizon too. */
static inline void shine(struct place *place, double sky, double sun)
{
    for (int i = 0; i < SKY_ROWS * SKY_COLUMNS * 3; i++)
        place->texels[i] = (float)sky;
    for (int c = 0; c < 3; c++) {
        place->sky.sun[c] = sun;
        place->sky.sun_radiance[c] = sun / (M_PI * pow(sin(0.2665 * M_PI / 180), 2));
        place->sky.irradiance[c] = M_PI * sky;
    }
}

static inline int setup(void **state)
{
    struct place *place = calloc(1, sizeof *place);
    place->sky.texels = place->texels;
    place->world = (struct camera_world){
        .size = 4,
        .depth = 1,
        .solids = {.floor = INFINITY,
                   .positions = place->positions,
                   .normals = place->normals,
                   .indices = place->indices,
                   .reflectance = solid_reflectance,
                   .floor_reflectance = floor_reflectance,
                   .user = place},
        .water = {.ior = {1.333, 1.333, 1.333}},
        .sky = &place->sky,
        .sun = optics_sun_disc(&(struct optics_sun){.elevation = 60, .azimuth = 30, .angular_radius = 0.2665}),
    };
    for (int c = 0; c < 3; c++)
        place->floor[c] = place->solids[c] = 0.5;
    *state = place;
    return 0;
}

static inline int teardown(void **state)
{
    struct place *place = *state;
    surface_finish(&place->water);
    free(place);
    return 0;
}

/* A box with its normals inwards or outwards: six sides of two triangles. */
static inline void put_box(struct place *place, const double low[3], const double high[3], bool inwards)
{
    for (int side = 0; side < 6; side++) {
        int axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int k = 0; k < 4; k++) {
            float *position = place->positions + 3 * (4 * side + k), *normal = place->normals + 3 * (4 * side + k);
            position[axis] = (float)(side % 2 ? high[axis] : low[axis]);
            position[u] = (float)(k % 2 ? high[u] : low[u]);
            position[v] = (float)(k / 2 ? high[v] : low[v]);
            normal[axis] = (side % 2 == 1) == inwards ? -1 : 1;
        }
        const unsigned first = 4 * (unsigned)side, corners[6] = {0, 1, 2, 2, 1, 3};
        for (int k = 0; k < 6; k++)
            place->indices[6 * side + k] = first + corners[k];
    }
    place->world.solids.vertex_count = 24;
    place->world.solids.triangle_count = 12;
}

#endif
