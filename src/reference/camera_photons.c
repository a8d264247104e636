#include "reference/camera_photons.h"

#include "reference/camera_flight.h"

#include "optics/phase.h"

#include <stdlib.h>
#include <string.h>

#define PHOTON 0x70686f746f6eu /* start of the photons' random numbers, not that of a pixel's */
#define BLOCK 4096             /* photons that a thread sends together */
#define MARKS 6                /* ways through water of each photon of a block that there is room for */
#define FLATNESS 0.25          /* of the radius: how far off the plane of a surface photons still lie on it */
#define SAME_SIDE 0.5          /* cosine between normals of what may be one surface */

bool camera_photons_begin(struct camera_photons *photons, const struct camera_scene *scene,
                          const struct camera_sight *view, int count, const struct dpl_log *log)
{
    const struct camera_water *water = &scene->world.water;
    bool scatters = vector3_most(water->optics.scattering) > 0;
    size_t solids = (size_t)count, marks = scatters ? solids * MARKS : 1;
    *photons = (struct camera_photons){.scene = scene, .sent = water->half > 0 ? count : 0};
    photons->solids.photons = base_allocate(log, solids, sizeof *photons->solids.photons, "photons");
    photons->solids.axes = base_allocate(log, solids, 1, "photons");
    photons->water.photons = base_allocate(log, marks, sizeof *photons->water.photons, "photons");
    photons->water.axes = base_allocate(log, marks, 1, "photons");
    photons->blocks = base_allocate(log, solids / BLOCK + 1, sizeof *photons->blocks, "photons");
    if (photons->solids.photons && photons->solids.axes && photons->water.photons && photons->water.axes &&
        photons->blocks && camera_aim_make(&photons->aim, scene, view, log))
        return true;
    camera_photons_finish(photons);
    return false;
}

void camera_photons_finish(struct camera_photons *photons)
{
    free(photons->solids.photons);
    free(photons->solids.axes);
    free(photons->water.photons);
    free(photons->water.axes);
    free(photons->blocks);
    *photons = (struct camera_photons){0};
}

/* What the marks of photons of a block that there was room for carry for those that there was none for. */
static void stand_for_all(struct photon *marks, int count, double scale)
{
    for (int i = 0; i < count && scale > 1; i++)
        for (int c = 0; c < 3; c++)
            marks[i].flux[c] *= (float)scale;
}

/* Sends the photons of a block, and leaves what has come of them at the start of its part of the arrays. */
static void send_block(struct camera_photons *photons, int block, uint64_t pass)
{
    struct camera_block *sent = photons->blocks + block;
    struct photon *solids = photons->solids.photons + (size_t)block * BLOCK;
    struct photon *marks = photons->water.photons + (size_t)block * BLOCK * MARKS;
    int first = block * BLOCK, end = photons->sent < first + BLOCK ? photons->sent : first + BLOCK;
    int room = (end - first) * MARKS, marked = 0;
    *sent = (struct camera_block){0};
    for (int i = first; i < end; i++) {
        struct camera_flight flight;
        struct draws draws = {.start = PHOTON, .path = pass * (uint64_t)photons->sent + (uint64_t)i};
        camera_fly(&flight, photons->scene, &photons->aim, draws);
        if (flight.landed)
            solids[sent->solids++] = flight.solid;
        if (sent->marks + flight.marked > room)
            room = 0;
        for (int k = 0; k < flight.marked && room > 0; k++)
            marks[sent->marks++] = flight.marks[k];
        marked += room > 0;
    }
    stand_for_all(marks, sent->marks, (end - first) / fmax(marked, 1));
}

void camera_photons_send(struct camera_photons *photons, uint64_t pass)
{
    int blocks = (photons->sent + BLOCK - 1) / BLOCK;
#pragma omp parallel for schedule(dynamic)
    for (int block = 0; block < blocks; block++)
        send_block(photons, block, pass);
    struct photon_tree *solids = &photons->solids, *water = &photons->water;
    solids->count = water->count = 0;
    for (int block = 0; block < blocks; block++) {
        const struct camera_block *sent = photons->blocks + block;
        const struct photon *from = solids->photons + (size_t)block * BLOCK;
        memmove(solids->photons + solids->count, from, (size_t)sent->solids * sizeof *from);
        from = water->photons + (size_t)block * BLOCK * MARKS;
        memmove(water->photons + water->count, from, (size_t)sent->marks * sizeof *from);
        solids->count += sent->solids;
        water->count += sent->marks;
    }
    photon_tree_build(solids);
    photon_tree_build(water);
}

/* Light that is gathered around a place. */
struct gathering {
    const double *place, *direction; /* direction: a surface's normal, or of sight */
    double radius, anisotropy;
    double sum[3];
};

static void gather_on_surface(void *user, const struct photon *photon)
{
    struct gathering *gathering = user;
    double off = 0, same = 0;
    for (int c = 0; c < 3; c++) {
        off += ((double)photon->position[c] - gathering->place[c]) * gathering->direction[c];
        same += (double)photon->vector[c] * gathering->direction[c];
    }
    if (fabs(off) > FLATNESS * gathering->radius || same < SAME_SIDE)
        return;
    for (int c = 0; c < 3; c++)
        gathering->sum[c] += (double)photon->flux[c];
}

void camera_photons_surface(const struct camera_photons *photons, const double place[3], const double normal[3],
                            double radius, double irradiance[3])
{
    struct gathering gathering = {.place = place, .direction = normal, .radius = radius};
    photon_tree_visit(&photons->solids, place, radius, gather_on_surface, &gathering);
    vector3_scale(gathering.sum, 1 / (M_PI * radius * radius * fmax(photons->sent, 1)), irradiance);
}

static void gather_in_water(void *user, const struct photon *photon)
{
    struct gathering *gathering = user;
    double cosine = 0;
    for (int c = 0; c < 3; c++)
        cosine -= (double)photon->vector[c] * gathering->direction[c];
    double phase = optics_phase(fmin(fmax(cosine, -1), 1), gathering->anisotropy);
    for (int c = 0; c < 3; c++)
        gathering->sum[c] += (double)photon->flux[c] * phase;
}

/* Share of a ball on one side of a plane that is `distance` radii from its middle, which is on that side. */
static double ball_share(double distance)
{
    double away = fmin(fmax(distance, 0), 1);
    return (1 + away) * (1 + away) * (2 - away) / 4;
}

/* How much of a ball is in the water: between the surface and the floor as they are straight above and below. */
static double wet_share(const struct camera_scene *scene, const double place[3], double radius)
{
    double above = camera_tiles_height(&scene->water, place[0], place[2]) - place[1];
    double below = place[1] + scene->world.depth - camera_tiles_height(&scene->floor, place[0], place[2]);
    return ball_share(above / radius) * (scene->world.solids.floor > 0 ? ball_share(below / radius) : 1);
}

void camera_photons_volume(const struct camera_photons *photons, const double place[3], const double direction[3],
                           double radius, double radiance[3])
{
    double anisotropy = photons->scene->world.water.optics.anisotropy;
    struct gathering gathering = {.place = place, .direction = direction, .radius = radius, .anisotropy = anisotropy};
    photon_tree_visit(&photons->water, place, radius, gather_in_water, &gathering);
    double ball = 4 * M_PI / 3 * pow(radius, 3) * wet_share(photons->scene, place, radius);
    vector3_scale(gathering.sum, 1 / (ball * fmax(photons->sent, 1)), radiance);
}
