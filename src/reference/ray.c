#include "reference/ray.h"

#include "optics/refraction.h"

#include <math.h>

#define FLATTEST 1e-6 /* vertical part of a direction below which a ray leaves the scene */

enum ray_kind ray_kind_of(double receiver)
{
    return receiver < 0 ? RAY_REFRACTED : RAY_REFLECTED;
}

/* The share of the light that goes on that way. */
static double share_of(enum ray_kind kind, double cosine, double ior)
{
    double reflectance = optics_fresnel_reflectance(cosine, ior);
    return kind == RAY_REFLECTED ? reflectance : 1 - reflectance;
}

static void turn(enum ray_kind kind, const double to_light[3], const double normal[3], double ior, double out[3])
{
    if (kind == RAY_REFLECTED)
        optics_reflect(to_light, normal, out);
    else
        optics_refract(to_light, normal, ior, out);
}

void ray_medium_start(struct ray_medium *rays, const struct water_medium *medium, const struct optics_disc *disc)
{
    static const double up[3] = {0, 1, 0};
    struct optics_water water = water_optics(medium);
    water_refractive_indices(medium, rays->ior);
    rays->flat_up = disc->middle[1];
    for (int c = 0; c < 3; c++) {
        rays->absorption[c] = water.absorption[c];
        for (int kind = 0; kind < RAY_KINDS; kind++) {
            double direction[3];
            turn((enum ray_kind)kind, disc->middle, up, rays->ior[c], direction);
            rays->flat_share[kind][c] = share_of((enum ray_kind)kind, rays->flat_up, rays->ior[c]);
            rays->flat_way[kind][c] = 1 / fabs(direction[1]);
        }
    }
}

struct ray ray_start(const struct ray_medium *rays, const struct ray_point *point, enum ray_kind kind, int color)
{
    struct ray ray = {.kind = kind, .color = color};
    double length = sqrt(1 + point->slope_x * point->slope_x + point->slope_z * point->slope_z);
    double normal[3] = {-point->slope_x / length, 1 / length, -point->slope_z / length};
    double cosine = point->to_light[0] * normal[0] + point->to_light[1] * normal[1] + point->to_light[2] * normal[2];
    double flat = rays->flat_share[kind][color];
    if (!(cosine > 0) || point->to_light[1] <= 0 || point->area <= 0 || flat <= 0)
        return ray; /* turned away from the light, below the horizon, folded over, or nothing is thrown back at all */
    cosine = fmin(cosine, 1);
    turn(kind, point->to_light, normal, rays->ior[color], ray.direction);
    ray.weight = cosine * length / rays->flat_up * point->area * share_of(kind, cosine, rays->ior[color]) / flat;
    return ray;
}

bool ray_meet(const struct ray *ray, const struct ray_point *point, double receiver, struct ray_hit *hit)
{
    bool down = ray->kind == RAY_REFRACTED;
    double rise = down ? -ray->direction[1] : ray->direction[1]; /* towards the receiver */
    double height = down ? point->height - receiver : receiver - point->height;
    if (!(rise > FLATTEST))
        return false;
    hit->way = fmax(height, 0) / rise;
    hit->x = point->x + ray->direction[0] * hit->way;
    hit->z = point->z + ray->direction[2] * hit->way;
    return true;
}

double ray_weight(const struct ray_medium *rays, const struct ray *ray, const struct ray_hit *hit, double receiver,
                  int color)
{
    if (ray->kind == RAY_REFLECTED)
        return ray->weight; /* air absorbs nothing */
    double longer = hit->way - fabs(receiver) * rays->flat_way[RAY_REFRACTED][color];
    return ray->weight * optics_transmittance(rays->absorption[color], longer);
}

void ray_flat_mean(const struct ray_medium *rays, const struct optics_disc *disc, double receiver, double mean[3])
{
    const int places = 64; /* a side: the mean over the disc to 1e-5 and better */
    mean[0] = mean[1] = mean[2] = 0;
    for (int k = 0; k < places * places; k++) {
        struct ray_point point = {.area = 1};
        double place[2];
        optics_disc_spread((k % places + 0.5) / places, (k / places + 0.5) / places, place);
        optics_disc_place(disc, place, point.to_light);
        for (int c = 0; c < 3; c++) {
            struct ray ray = ray_start(rays, &point, ray_kind_of(receiver), c);
            struct ray_hit hit;
            if (ray.weight > 0 && ray_meet(&ray, &point, receiver, &hit))
                mean[c] += ray_weight(rays, &ray, &hit, receiver, c) / (places * places);
        }
    }
}
