/* reference/ray.h: the weights and ways of single rays from the surface to horizontal receivers.
 *
 * A ray's weight is its light in units of what the same patch of flat water would send to the receiver if the whole sun
 * stood at its middle: projected area × Fresnel's share × what the water lets through. Each ray meets the surface
 * once: waves cast no shadow on others, and light that is thrown back does not fall onto the water again. A ray that
 * never comes to its receiver takes its light with it. */
#ifndef REFERENCE_RAY_H
#define REFERENCE_RAY_H

#include "optics/sun.h"
#include "water/water.h"

/* A square of a receiver: its corner of smallest x and z, and its side. */
struct ray_window {
    double x, z, side; /* m */
};

/* What happens to the light there: it enters the water, or is thrown back by it. */
enum ray_kind { RAY_REFRACTED, RAY_REFLECTED, RAY_KINDS };

/* How light comes to a receiver at that height, which is not 0: from below the surface, or from above it. */
enum ray_kind ray_kind_of(double receiver);

/* What is the same for all rays. */
struct ray_medium {
    double ior[3], absorption[3];
    double flat_up;                  /* cosine between the middle of the sun and the flat surface's normal */
    double flat_share[RAY_KINDS][3]; /* of flat water's light, by colour */
    double flat_way[RAY_KINDS][3];   /* m of way for each m of height */
};
void ray_medium_start(struct ray_medium *rays, const struct water_medium *medium, const struct optics_disc *disc);

/* Where light meets the water. */
struct ray_point {
    double x, z, height; /* m */
    double slope_x, slope_z;
    double area;        /* seen from above, to that at rest */
    double to_light[3]; /* unit vector */
};

/* One colour of the light from there on. */
struct ray {
    enum ray_kind kind;
    int color;
    double direction[3]; /* unit vector */
    double weight;       /* before the water takes its part; 0: no light */
};
struct ray ray_start(const struct ray_medium *rays, const struct ray_point *point, enum ray_kind kind, int color);

/* Where a ray meets the receiver at height `receiver`. A surface that stands beyond its receiver (a trough through the
 * floor, a crest through a ceiling) gives its light to the receiver straight above or below. False: never. */
struct ray_hit {
    double x, z, way; /* m */
};
bool ray_meet(const struct ray *ray, const struct ray_point *point, double receiver, struct ray_hit *hit);

/* The ray's weight there in a colour, which may be another than the ray's own if its refractive index is the same. */
double ray_weight(const struct ray_medium *rays, const struct ray *ray, const struct ray_hit *hit, double receiver,
                  int color);

/* The mean weight of flat water's rays from all of the sun, by colour; 1 where the sun is a point. */
void ray_flat_mean(const struct ray_medium *rays, const struct optics_disc *disc, double receiver, double mean[3]);

#endif
