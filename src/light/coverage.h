/* light/coverage.h: what the parts of the technique `coverage` share.
 *
 *     surface ─→ rays ─→ cells (on one receiver) ─→ fill (a point sun's light) ─→ footprints (the sun's disc) ─→ map
 *
 * On a receiver, lengths are counted in texels of the fine map, which has `fineness` texels a side in each of the
 * map's. */
#ifndef LIGHT_COVERAGE_H
#define LIGHT_COVERAGE_H

#include "light/coverage_gpu.h"
#include "light/light.h"

#include <stddef.h>

#define COVERAGE_BLOCK 16    /* cells of a row that are filled or skipped together */
#define COVERAGE_KINDS_MAX 9 /* along either axis */
#define COVERAGE_FINENESS_MAX 8

/* Section [coverage]. */
struct coverage {
    int fineness;   /* 0: as much as caustics.error asks for */
    int footprints; /* likewise */
};

/* What flat water does with the light from the middle of the sun. */
struct coverage_flat {
    bool upwards; /* light that is thrown back, not let in */
    double ior;
    double sun[3];  /* unit vector towards the sun */
    double u, v, q; /* as in struct coverage_rays */
    double share;   /* of the light that goes on */
};
struct coverage_flat coverage_flat_water(const double sun[3], double ior, bool upwards);

/* u, v and q of the light from a direction where the surface has those slopes; false where none arrives. */
bool coverage_ray(const double sun[3], double ior, bool upwards, const double slopes[2], double uvq[3]);

/* The light that goes on from a surface's vertices: what leaves height h at (x, z) meets the receiver at height y at
 * (x + u (y - h), z + v (y - h)) after q (y - h) metres. Arrays of rows × columns vertices, with the repeated edge of a
 * periodic surface. */
struct coverage_rays {
    int columns, rows;
    float *u, *v, *q;
    float *weight; /* flux through a patch of surface, in units of flat water's, before absorption */
};
bool coverage_rays_trace(struct coverage_rays *rays, const struct surface *surface, const struct coverage_flat *flat,
                         const struct dpl_log *log);
void coverage_rays_finish(struct coverage_rays *rays);

/* A kind of light is what one footprint of the sun's disc smears. Kinds stand on a grid over the surface's slopes,
 * along the sun's azimuth and across it; light between them belongs to its neighbours by shares. */
struct coverage_kinds {
    int count[2];
    double offset[2], per_slope[2][2]; /* place = offset + per_slope[0] slope_x + per_slope[1] slope_z */
};

/* Red, green, blue, and the kind: both places in one number. */
typedef float coverage_light __attribute__((vector_size(16)));

/* kind = steps of the first place + COVERAGE_KIND_ROW × steps of the second. */
#define COVERAGE_KIND_STEPS 128.0f
#define COVERAGE_KIND_ROW 4096.0f

/* Kinds of triangles that are not filled. */
#define COVERAGE_DARK (-1.0f)
#define COVERAGE_POINT (-2.0f) /* less the kind proper: the image has no area, and the colours are its flux */

/* The images of the surface's cells on one receiver. */
struct coverage_cells {
    int columns, rows; /* of cells */
    bool periodic;
    double spacing;          /* of flat water's vertices */
    double origin[2];        /* x and z of flat water's first vertex */
    float *moved[2];         /* (rows + 1) × (columns + 1): x and z of vertices, from where flat water has them */
    float *exact[2];         /* likewise, before they are balanced */
    float *light[3];         /* likewise: weight with absorption, red green blue */
    float *kind[2];          /* likewise: places among the kinds */
    coverage_light *density; /* (rows + 2) × (columns + 2) × 2: light a texel of each cell's triangles, negative where
                                the image is turned over, with a dark rim */
    struct coverage_block {
        float least_z, most_z, least_kind[2], most_kind[2];
    } * blocks; /* (rows + 1) × blocks_across: what a stretch of a row of vertices, its neighbours to the left and right
                   included, reaches over */
    int blocks_across;
    double *spread; /* rows × 3: flux of images too wide to be filled; a periodic surface spreads it over the map */
};

struct coverage_receiver {
    double height; /* m */
    int side;      /* fine texels a side */
    struct ray_window window;
};
bool coverage_cells_place(struct coverage_cells *cells, const struct coverage_rays *rays, const struct surface *surface,
                          const struct coverage_flat *flat, const double absorption[3],
                          const struct coverage_receiver *receiver, const struct coverage_kinds *kinds,
                          const struct dpl_log *log);
void coverage_cells_finish(struct coverage_cells *cells);

/* The light of one kind on rows first … first + count - 1 of the fine map and `margin` columns on either side. Rows and
 * columns beyond the map repeat it where the surface is periodic. `room` is coverage_fill_room() bytes, aligned to 32;
 * the light goes to `out`: for each row a line of red, one of green and one of blue. Threads may fill other rows at the
 * same time. */
size_t coverage_fill_room(int side, int margin, int count);
void coverage_fill(const struct coverage_cells *cells, int side, int margin, const int kind[2], int first, int count,
                   void *room, float *out);

/* The share of a uniform ellipse of that covariance, xx, xz, zz in square texels, in each of the (2 reach + 1)² texels
 * around its middle. */
void coverage_ellipse(const double covariance[3], int reach, double *cells);

/* The weight of fine texel (x, z), counted from the first of a texel of the map, for that texel: the mean of the
 * ellipses around its own fine texels. */
double coverage_ellipse_weight(const double *cells, int reach, int fineness, int x, int z);

/* A footprint of the sun's disc: for a texel of the map, the sum over taps of value × the running sum of the light from
 * the left end of row z of the fine map up to column x. Rows and columns are counted from the texel's first. */
struct coverage_tap {
    int x, z;
    float value;
};
struct coverage_footprint {
    int kind[2];
    double level; /* mean light of the kind */
    int reach;    /* fine texels that it reaches over beyond the texel's own */
    int count, room;
    struct coverage_tap *taps;
};

/* Where ellipses are drawn. */
struct coverage_raster {
    double *cells;
    size_t room;
};

/* The footprint of a uniform ellipse of that covariance, xx, xz, zz in square fine texels. Keeps kind and level. */
bool coverage_footprint_make(struct coverage_footprint *footprint, const double covariance[3], int fineness,
                             struct coverage_raster *raster, const struct dpl_log *log);
void coverage_footprint_finish(struct coverage_footprint *footprint);

/* The mean footprint's covariance in square metres; false where no light arrives. */
bool coverage_mean_footprint(const struct light_input *input, const struct light_samples *samples,
                             const struct coverage_flat *flat, double receiver, double covariance[3]);

/* A footprint of a smaller radius, in texels of the map, is a point. */
#define COVERAGE_RADIUS_MIN 0.02

/* Texels to compute along each side of one of the map, 1 to `most`, for an error of at most `error`. What smearing
 * whole texels adds was measured: most where the disc's radius is a texel, less the finer they are, and little where
 * crests do not focus yet. */
int coverage_choose_fineness(const struct light_samples *samples, const struct coverage_flat *flat, double receiver,
                             double radius, double error, int most);

/* How finely a receiver is computed, and the footprints of its kinds. All zero: none yet. */
struct coverage_plan {
    int side; /* texels of what is computed: the map's, or fewer where the sun's disc blurs it so far that they do */
    int fineness;
    struct coverage_kinds kinds;
    int count; /* of footprints; 1 without taps: a point sun */
    struct coverage_footprint footprints[COVERAGE_KINDS_MAX * COVERAGE_KINDS_MAX];
    int reach; /* the widest's */
    struct coverage_raster raster;
};
bool coverage_plan_make(struct coverage_plan *plan, const struct light_input *input,
                        const struct light_samples *samples, const struct coverage_flat *flat, int slice, int side);
void coverage_plan_finish(struct coverage_plan *plan);

/* Room for bands of rows, one for each thread. All zero: none yet. */
struct coverage_bands {
    int threads;
    size_t sums_size, light_size, sorted_size, out_size; /* a thread's */
    void *sums;
    float *light, *sorted, *out;
};
/* Fills and smears: the map of one receiver. `color` is the one that is written, -1 all. */
bool coverage_bands_trace(struct coverage_bands *bands, const struct coverage_cells *cells,
                          const struct coverage_plan *plan, int color, struct light_map *map, int slice,
                          const struct dpl_log *log);
void coverage_bands_finish(struct coverage_bands *bands);

/* A slice of a map from one with fewer texels, by straight lines between these. */
void coverage_enlarge(const struct light_map *small, int color, bool periodic, struct light_map *map, int slice);

#endif
