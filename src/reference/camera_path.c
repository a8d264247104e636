#include "reference/camera_path.h"

#include "base/vector3.h"
#include "reference/camera_crossing.h"
#include "reference/camera_medium.h"
#include "reference/camera_sun.h"

#include "base/sine.h"
#include "optics/phase.h"

#define PIXELS 1.5          /* pixels over which light is gathered, from the middle on */
#define MEETINGS_MAX 64     /* of anything, for one path */
#define DIFFUSE_SPREAD 0.05 /* m of width that a path gains for each metre behind a solid */

/* A path on its way. */
struct state {
    const struct camera_path *path;
    struct draws *draws;
    double place[3], direction[3], throughput[3], radiance[3];
    double width, spread; /* m, and what it gains a metre: of a pixel there */
    bool wet;
    bool mirrored;      /* nothing but water has been met */
    bool split;         /* water has been met, and the other way followed too */
    int bounces, color; /* the colour that is left after a prism's refraction; -1: all */
};

static void add(struct state *state, const double radiance[3], double scale)
{
    for (int c = 0; c < 3; c++)
        state->radiance[c] += state->throughput[c] * radiance[c] * scale;
}

/* Irradiance of the sun's light at something solid. */
static void sunlight(struct state *state, const struct camera_hit *hit, double irradiance[3])
{
    const struct camera_path *path = state->path;
    struct camera_beam beams[CAMERA_BEAMS_MAX];
    double to_sun[3];
    int count = 0;
    irradiance[0] = irradiance[1] = irradiance[2] = 0;
    camera_sun_place(path->scene, state->draws, to_sun);
    if (!state->wet && vector3_dot(to_sun, hit->normal) > 0 && vector3_dot(to_sun, hit->face) > 0)
        count += camera_sun_direct(path->scene, hit->position, to_sun, beams);
    if (path->photons)
        camera_photons_surface(path->photons, hit->position, hit->normal,
                               fmax(PIXELS * state->width, path->solid_radius), irradiance);
    else
        count += camera_sun_at_rest(path->scene, hit->position, state->wet, to_sun, beams + count);
    for (int i = 0; i < count; i++) {
        double cosine = -vector3_dot(beams[i].direction, hit->normal);
        for (int c = 0; c < 3 && cosine > 0 && vector3_dot(beams[i].direction, hit->face) < 0; c++)
            irradiance[c] += beams[i].irradiance[c] * cosine;
    }
}

/* The sun's light that the water on the next `length` metres scatters into the path. */
static void add_shafts(struct state *state, double length)
{
    const struct camera_path *path = state->path;
    const struct camera_water *water = &path->scene->world.water;
    double distance, place[3], to_sun[3], light[3] = {0, 0, 0};
    double density = camera_medium_place(water, length, draws_next(state->draws), &distance);
    vector3_along(state->place, state->direction, distance, place);
    if (path->photons) {
        double radius = fmax(PIXELS * (state->width + state->spread * distance), path->water_radius);
        camera_photons_volume(path->photons, place, state->direction, radius, light);
    } else {
        struct camera_beam beams[CAMERA_BEAMS_MAX];
        camera_sun_place(path->scene, state->draws, to_sun);
        int count = camera_sun_at_rest(path->scene, place, true, to_sun, beams);
        for (int i = 0; i < count; i++) {
            double cosine = -vector3_dot(beams[i].direction, state->direction);
            double phase = optics_phase(cosine, water->optics.anisotropy);
            for (int c = 0; c < 3; c++)
                light[c] += beams[i].irradiance[c] * phase;
        }
    }
    for (int c = 0; c < 3; c++)
        light[c] *= water->optics.scattering[c] * camera_medium_left(water, c, distance);
    add(state, light, 1 / density);
}

/* Through the water to what was hit. True where the path was scattered before. */
static bool swim(struct state *state, const struct camera_hit *hit)
{
    const struct camera_water *water = &state->path->scene->world.water;
    double distance;
    bool found = state->path->photons && !state->mirrored; /* photons that are scattered go on to where the path was */
    if (vector3_most(water->optics.scattering) > 0 && !found)
        add_shafts(state, hit->distance);
    bool scattered = camera_medium_walk(water, hit->distance, state->draws, state->throughput, &distance);
    state->width += state->spread * distance;
    vector3_along(state->place, state->direction, distance, state->place);
    if (!scattered)
        return false;
    camera_medium_turn(water->optics.anisotropy, state->draws, state->direction);
    state->spread = DIFFUSE_SPREAD;
    state->mirrored = false;
    return true;
}

/* Where colours part, one of them goes on and stands for three. */
static void choose_color(struct state *state)
{
    const struct camera_water *water = &state->path->scene->world.water;
    if (state->color >= 0 || water->ior[0] == water->ior[2])
        return;
    state->color = (int)(draws_next(state->draws) * 3);
    for (int c = 0; c < 3; c++)
        state->throughput[c] *= c == state->color ? 3 : 0;
}

/* Tilts the surface by slopes that its grid is too coarse for: as many as not along x and along z (Box & Muller 1958).
 */
static void roughen(struct state *state, struct camera_hit *hit)
{
    double roughness = state->path->scene->world.water.roughness, sine, cosine;
    if (!(roughness > 0) || !(hit->normal[1] > 0))
        return;
    double slope = roughness * sqrt(-log(1 - draws_next(state->draws)));
    sine_cosine(draws_next(state->draws), &sine, &cosine);
    hit->normal[0] += slope * cosine * hit->normal[1];
    hit->normal[2] += slope * sine * hit->normal[1];
    vector3_normalize(hit->normal);
}

/* On along one of the two ways. Radiance in water is more by the square of the index, in as much smaller an angle
 * (Straubel 1903). */
static void take_way(struct state *state, const struct camera_crossing *crossing, double ior, bool reflects,
                     double scale)
{
    scale *= reflects ? 1 : crossing->wet ? ior * ior : 1 / (ior * ior);
    vector3_scale(state->throughput, scale, state->throughput);
    state->wet = crossing->wet == reflects;
    vector3_copy(reflects ? crossing->reflected : crossing->refracted, state->direction);
}

static void follow(struct state *state);

/* Where an eye sees water, both ways are followed; after that one of them by chance. */
static void meet_water(struct state *state, struct camera_hit *hit)
{
    roughen(state, hit);
    choose_color(state);
    double ior = state->path->scene->world.water.ior[state->color < 0 ? 1 : state->color];
    struct camera_crossing crossing = camera_crossing(hit, state->direction, ior);
    if (state->mirrored && !state->split) {
        state->split = true;
        struct state mirrored = *state;
        vector3_scale(mirrored.radiance, 0, mirrored.radiance);
        take_way(&mirrored, &crossing, ior, true, crossing.reflectance);
        follow(&mirrored);
        vector3_along(state->radiance, mirrored.radiance, 1, state->radiance);
        take_way(state, &crossing, ior, false, 1 - crossing.reflectance);
    } else {
        take_way(state, &crossing, ior, draws_next(state->draws) < crossing.reflectance, 1);
    }
}

/* A direction as Lambert's law has it. */
static void leave_solid(struct state *state, const struct camera_hit *hit)
{
    double u = draws_next(state->draws), sine, cosine, radius = sqrt(u);
    sine_cosine(draws_next(state->draws), &sine, &cosine);
    const double local[3] = {radius * cosine, radius * sine, sqrt(1 - u)};
    vector3_turn(hit->normal, local, state->direction);
    vector3_keep_side(hit->face, 1, state->direction);
    state->spread = DIFFUSE_SPREAD;
    state->mirrored = false;
}

static void meet_solid(struct state *state, const struct camera_hit *hit)
{
    double irradiance[3];
    for (int c = 0; c < 3; c++)
        state->throughput[c] *= hit->reflectance[c];
    if (vector3_most(state->throughput) <= 0)
        return;
    sunlight(state, hit, irradiance);
    add(state, irradiance, 1 / M_PI);
    leave_solid(state, hit);
}

static void leave_scene(struct state *state)
{
    const struct camera_path *path = state->path;
    const struct camera_world *world = &path->scene->world;
    double radiance[3], edge = world->sun.radius > 0 ? world->sun.radius : sin(0.2665 * M_PI / 180);
    optics_sky_radiance(world->sky, state->direction, radiance);
    add(state, radiance, 1);
    double cosine = vector3_dot(state->direction, world->sun.middle);
    if (path->sun_seen && state->mirrored && cosine > 0 && 1 - cosine * cosine < edge * edge)
        add(state, world->sky->sun_radiance, 1);
}

/* One way and what is at its end. */
static void step(struct state *state)
{
    struct camera_hit hit = camera_scene_hit(state->path->scene, state->place, state->direction);
    bool scattered = state->wet && swim(state, &hit);
    if (!scattered) {
        state->width += state->wet ? 0 : state->spread * hit.distance; /* swim() has it */
        vector3_copy(hit.position, state->place);
    }
    if (!scattered && hit.what == CAMERA_WATER) {
        meet_water(state, &hit);
        return;
    }
    if (!scattered && hit.what == CAMERA_NOTHING)
        leave_scene(state);
    if ((!scattered && hit.what == CAMERA_NOTHING) || state->bounces++ == state->path->bounces)
        vector3_scale(state->throughput, 0, state->throughput); /* the end */
    else if (!scattered)
        meet_solid(state, &hit);
}

/* Ends paths that carry little, and lets those that go on stand for them. */
static bool goes_on(struct state *state)
{
    double chance = fmin(vector3_most(state->throughput), 0.95);
    if (!(chance > 0) || state->bounces < 2)
        return chance > 0;
    vector3_scale(state->throughput, 1 / chance, state->throughput);
    return draws_next(state->draws) < chance;
}

static void follow(struct state *state)
{
    for (int i = 0; i < MEETINGS_MAX && goes_on(state); i++)
        step(state);
}

void camera_path_radiance(const struct camera_path *path, const double origin[3], const double direction[3], bool wet,
                          struct draws *draws, double radiance[3])
{
    struct state state = {.path = path,
                          .draws = draws,
                          .throughput = {1, 1, 1},
                          .spread = path->spread,
                          .wet = wet,
                          .mirrored = true,
                          .color = -1};
    vector3_copy(origin, state.place);
    vector3_copy(direction, state.direction);
    follow(&state);
    vector3_copy(state.radiance, radiance);
}
