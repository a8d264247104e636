#include "reference/camera_flight.h"

#include "reference/camera_crossing.h"
#include "reference/camera_medium.h"
#include "reference/camera_sun.h"

#define FEW 0.25       /* share of its light below which a photon may end */
#define ABOVE 100.0    /* m: no water is higher */
#define REFLECTED 0.25 /* share of photons that are reflected where they first meet water */
#define SIDES 0.25     /* share that goes to the sides of a block of water */
#define STOPPED 0.5    /* share that ends at what throws no shadow; the others go on behind it */

static struct photon photon_of(const double place[3], const double vector[3], const double flux[3])
{
    struct photon photon;
    for (int c = 0; c < 3; c++) {
        photon.position[c] = (float)place[c];
        photon.vector[c] = (float)vector[c];
        photon.flux[c] = (float)flux[c];
    }
    return photon;
}

/* Where the sun shines on the water from above: false where it does not. */
static bool start_on_top(struct camera_flight *flight, const double to_sun[3], double u, double v,
                         struct camera_hit *hit)
{
    static const double down[3] = {0, -1, 0};
    const struct camera_scene *scene = flight->scene;
    double xz[2], density = camera_aim_place(flight->aim, u, v, xz);
    const double above[3] = {xz[0], ABOVE, xz[1]};
    struct camera_tiles_hit top;
    if (!camera_tiles_meet(&scene->water, above, down, 0, 2 * ABOVE, &top))
        return false;
    *hit = (struct camera_hit){.what = CAMERA_WATER, .position = {xz[0], ABOVE - top.distance, xz[1]}};
    vector3_copy(top.normal, hit->normal);
    vector3_copy(top.face, hit->face);
    double cosine = vector3_dot(to_sun, top.face);
    vector3_scale(scene->world.sky->sun, fmax(cosine, 0) / (top.face[1] * density), flight->flux);
    return cosine > 0;
}

/* Where the sun shines on the sides of a block of water. */
static bool start_on_side(struct camera_flight *flight, const double to_sun[3], double u, double v,
                          struct camera_hit *hit)
{
    const struct camera_world *world = &flight->scene->world;
    double share = fabs(to_sun[0]) / (fabs(to_sun[0]) + fabs(to_sun[2])), half = flight->scene->water.half;
    int across = u < share ? 0 : 2;
    u = across == 0 ? u / share : (u - share) / (1 - share);
    *hit = (struct camera_hit){.what = CAMERA_WATER};
    hit->normal[across] = hit->face[across] = copysign(1, to_sun[across]);
    hit->position[across] = half * hit->face[across];
    hit->position[2 - across] = (2 * u - 1) * half;
    double height = world->depth + camera_tiles_height(&flight->scene->water, hit->position[0], hit->position[2]);
    hit->position[1] = v * height - world->depth;
    share = across == 0 ? share : 1 - share;
    vector3_scale(world->sky->sun, fabs(to_sun[across]) * 2 * half * height / share, flight->flux);
    return height > 0;
}

static bool sunlit(const struct camera_flight *flight, const struct camera_hit *hit, const double to_sun[3])
{
    struct camera_hit wave;
    return camera_scene_lit(flight->scene, hit, to_sun) &&
           !camera_scene_water(flight->scene, hit->position, to_sun, CAMERA_FARTHEST, &wave);
}

/* Lets a photon into the water, or throws it back. Where colours part, one of them goes on and stands for three. */
static void cross(struct camera_flight *flight, const struct camera_hit *hit, double least)
{
    const struct camera_water *water = &flight->scene->world.water;
    if (flight->color < 0 && water->ior[0] != water->ior[2]) {
        flight->color = (int)(draws_next(&flight->draws) * 3);
        for (int c = 0; c < 3; c++)
            flight->flux[c] *= c == flight->color ? 3 : 0;
    }
    double ior = water->ior[flight->color < 0 ? 1 : flight->color];
    struct camera_crossing crossing = camera_crossing(hit, flight->direction, ior);
    double chance = fmax(crossing.reflectance, least);
    bool reflects = draws_next(&flight->draws) < chance;
    double scale = reflects ? crossing.reflectance / chance : (1 - crossing.reflectance) / (1 - chance);
    vector3_scale(flight->flux, scale, flight->flux);
    flight->wet = crossing.wet == reflects;
    vector3_copy(hit->position, flight->place);
    vector3_copy(reflects ? crossing.reflected : crossing.refracted, flight->direction);
}

/* Leaves light at a place of the next `length` metres of water. */
static void mark(struct camera_flight *flight, double length)
{
    const struct camera_water *water = &flight->scene->world.water;
    double distance, place[3], flux[3];
    double density = camera_medium_place(water, length, draws_next(&flight->draws), &distance);
    vector3_along(flight->place, flight->direction, distance, place);
    for (int c = 0; c < 3; c++)
        flux[c] = flight->flux[c] * camera_medium_left(water, c, distance) / density;
    flight->marks[flight->marked++] = photon_of(place, flight->direction, flux);
}

/* Through water to what was hit. True where the photon is scattered before. */
static bool swim(struct camera_flight *flight, double length)
{
    const struct camera_water *water = &flight->scene->world.water;
    double distance;
    if (vector3_most(water->optics.scattering) > 0)
        mark(flight, length);
    if (!camera_medium_walk(water, length, &flight->draws, flight->flux, &distance))
        return false;
    vector3_along(flight->place, flight->direction, distance, flight->place);
    camera_medium_turn(water->optics.anisotropy, &flight->draws, flight->direction);
    return true;
}

/* On to whatever comes next. */
static void step(struct camera_flight *flight)
{
    struct camera_hit hit = camera_scene_hit(flight->scene, flight->place, flight->direction);
    if (flight->wet && swim(flight, hit.distance))
        return;
    if (hit.what == CAMERA_WATER) {
        cross(flight, &hit, 0);
        return;
    }
    if (hit.what == CAMERA_SOLID && !hit.casts) {
        bool stops = draws_next(&flight->draws) < STOPPED;
        vector3_scale(flight->flux, 1 / (stops ? STOPPED : 1 - STOPPED), flight->flux);
        if (!stops) {
            vector3_copy(hit.position, flight->place);
            return;
        }
    }
    flight->landed = hit.what == CAMERA_SOLID;
    flight->solid = photon_of(hit.position, hit.normal, flight->flux);
    vector3_scale(flight->flux, 0, flight->flux);
}

/* Ends photons that have lost most of their light, and lets those that go on stand for them. */
static bool goes_on(struct camera_flight *flight, double begun)
{
    double chance = fmin(vector3_most(flight->flux) / (FEW * begun), 1);
    if (!(chance > 0) || chance == 1)
        return chance > 0;
    vector3_scale(flight->flux, 1 / chance, flight->flux);
    return draws_next(&flight->draws) < chance;
}

void camera_fly(struct camera_flight *flight, const struct camera_scene *scene, const struct camera_aim *aim,
                struct draws draws)
{
    *flight = (struct camera_flight){.scene = scene, .aim = aim, .draws = draws, .color = -1};
    double u = draws_next(&flight->draws), v = draws_next(&flight->draws), to_sun[3];
    double sides = isinf(scene->water.half) ? 0 : SIDES;
    struct camera_hit hit;
    camera_sun_place(scene, &flight->draws, to_sun);
    bool side = draws_next(&flight->draws) < sides;
    if (to_sun[1] <= 0 || !(side ? start_on_side : start_on_top)(flight, to_sun, u, v, &hit) ||
        !sunlit(flight, &hit, to_sun))
        return;
    vector3_scale(flight->flux, 1 / (side ? sides : 1 - sides), flight->flux);
    vector3_scale(to_sun, -1, flight->direction);
    double begun = vector3_most(flight->flux);
    cross(flight, &hit, REFLECTED);
    for (int i = 0; i < CAMERA_MEETINGS && goes_on(flight, begun); i++)
        step(flight);
}
