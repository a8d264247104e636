#include "reference/camera_aim.h"

#include "reference/camera_crossing.h"
#include "reference/camera_medium.h"
#include "reference/draws.h"

#include "base/sine.h"
#include "optics/refraction.h"

#include <stdlib.h>

#define SIDE CAMERA_AIM_SIDE
#define SMALL 32.0     /* m: half a side of a block of water that photons are sent to all of */
#define PILOTS 128     /* paths from the eye, across and down the picture */
#define MEETINGS 6     /* that they have */
#define COPIES 4       /* of each way back: waves spread them */
#define SPREAD 0.25    /* m for each metre between water and place */
#define FARTHER 0.25   /* share of the photons that goes to all of the water, less and less away from the square */
#define LEFT_OUT 0.005 /* share of the ways back at either end along x and z that the square leaves out */
#define LEAST 0.01     /* throughput below which a place is hardly seen */

/* Places of the water. */
struct ways {
    int count;
    double (*places)[2];
};

/* Where the sun's light meets flat water on its way to a place. */
static void way_back(const struct camera_scene *scene, const double place[3], bool wet, double out[2])
{
    static const double up[3] = {0, 1, 0};
    const double *to_sun = scene->world.sun.middle;
    double in_water[3], rise = to_sun[1];
    vector3_copy(to_sun, in_water);
    if (wet) {
        optics_refract(to_sun, up, scene->world.water.ior[1], in_water);
        vector3_scale(in_water, -1, in_water);
        rise = in_water[1];
    }
    double length = fabs(place[1]) / rise;
    out[0] = place[0] + in_water[0] * length;
    out[1] = place[2] + in_water[2] * length;
}

static void add_ways(struct ways *ways, const struct camera_scene *scene, const double place[3], bool wet,
                     struct draws *draws)
{
    for (int k = 0; k < COPIES; k++) {
        double *way = ways->places[ways->count++];
        way_back(scene, place, wet, way);
        for (int c = 0; c < 2; c++)
            way[c] += (2 * draws_next(draws) - 1) * SPREAD * fabs(place[1]);
    }
}

/* One path from the eye: where it meets solids, and a place in the water that it goes through. */
static void follow(struct ways *ways, const struct camera_scene *scene, const double origin[3],
                   const double direction_[3], struct draws *draws)
{
    const struct camera_water *water = &scene->world.water;
    double place[3], direction[3], seen = 1;
    bool wet = camera_scene_wet(scene, origin);
    vector3_copy(origin, place);
    vector3_copy(direction_, direction);
    for (int i = 0; i < MEETINGS && seen > LEAST; i++) {
        struct camera_hit hit = camera_scene_hit(scene, place, direction);
        if (wet && vector3_most(water->optics.scattering) > 0) {
            double distance, middle[3];
            camera_medium_place(water, hit.distance, draws_next(draws), &distance);
            vector3_along(place, direction, distance, middle);
            add_ways(ways, scene, middle, true, draws);
        }
        seen *= wet ? camera_medium_most_left(water, hit.distance) : 1;
        if (hit.what == CAMERA_SOLID && seen > LEAST)
            add_ways(ways, scene, hit.position, wet, draws);
        if (hit.what != CAMERA_WATER)
            return;
        vector3_copy(hit.position, place);
        struct camera_crossing crossing = camera_crossing(&hit, direction, water->ior[1]);
        bool reflects = draws_next(draws) < fmax(crossing.reflectance, 0.5); /* what is mirrored is seen too */
        vector3_copy(reflects ? crossing.reflected : crossing.refracted, direction);
        wet = crossing.wet == reflects;
    }
}

static int compare(const void *a, const void *b)
{
    const double *first = a, *second = b;
    return (*first > *second) - (*first < *second);
}

/* The square that holds most of the ways, or all of a small block of water. */
static bool frame_ways(struct camera_aim *aim, const struct camera_scene *scene, const struct ways *ways,
                       const struct dpl_log *log)
{
    double half = scene->water.half, low[2], high[2];
    *aim = (struct camera_aim){.x = -half, .z = -half, .size = 2 * half};
    if (half <= SMALL)
        return true;
    double *sorted = base_allocate(log, (size_t)ways->count + 1, sizeof *sorted, "light of the picture");
    if (!sorted)
        return false;
    for (int c = 0; c < 2; c++) {
        for (int i = 0; i < ways->count; i++)
            sorted[i] = ways->places[i][c];
        qsort(sorted, (size_t)ways->count, sizeof *sorted, compare);
        low[c] = fmax(sorted[(int)(LEFT_OUT * (ways->count - 1))], -half);
        high[c] = fmin(sorted[(int)((1 - LEFT_OUT) * (ways->count - 1))], half);
    }
    free(sorted);
    aim->size = fmax(fmax(high[0] - low[0], high[1] - low[1]), 1e-3);
    aim->x = (low[0] + high[0] - aim->size) / 2;
    aim->z = (low[1] + high[1] - aim->size) / 2;
    return true;
}

static int cell_at(double place, double start, double size)
{
    double cell = floor((place - start) / size * SIDE);
    return cell >= 0 && cell < SIDE ? (int)cell : -1;
}

static void count_ways(struct camera_aim *aim, const struct ways *ways)
{
    double total = 0, even;
    for (int i = 0; i < ways->count; i++) {
        int column = cell_at(ways->places[i][0], aim->x, aim->size);
        int row = cell_at(ways->places[i][1], aim->z, aim->size);
        if (column < 0 || row < 0)
            continue;
        aim->cells[row][column + 1]++;
        total++;
    }
    even = total > 0 ? 0 : 1;
    total = total > 0 ? total : SIDE * SIDE;
    for (int row = 0; row < SIDE; row++) {
        for (int column = 0; column < SIDE; column++)
            aim->cells[row][column + 1] = aim->cells[row][column] + (aim->cells[row][column + 1] + even) / total;
        aim->rows[row + 1] = aim->rows[row] + aim->cells[row][SIDE];
    }
}

bool camera_aim_make(struct camera_aim *aim, const struct camera_scene *scene, const struct camera_sight *view,
                     const struct dpl_log *log)
{
    struct ways ways = {0, base_allocate(log, (size_t)PILOTS * PILOTS * MEETINGS * 2 * COPIES, sizeof *ways.places,
                                         "light of the picture")};
    if (!ways.places)
        return false;
    for (int i = 0; i < PILOTS * PILOTS; i++) {
        struct draws draws = {.path = (uint64_t)i};
        double direction[3], column = i % PILOTS + draws_next(&draws), row = i / PILOTS + draws_next(&draws);
        camera_sight_ray(view, column * view->width / PILOTS, row * view->height / PILOTS, direction);
        follow(&ways, scene, view->eye, direction, &draws);
    }
    bool ok = frame_ways(aim, scene, &ways, log);
    if (ok)
        count_ways(aim, &ways);
    free(ways.places);
    return ok;
}

/* The step of a rising sum that holds `value`, and how far in it that lies. */
static int find_step(const double sums[SIDE + 1], double value, double *inside)
{
    int low = 0, high = SIDE;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (sums[middle] <= value)
            low = middle;
        else
            high = middle;
    }
    *inside = fmin((value - sums[low]) / (sums[high] - sums[low]), 1);
    return low;
}

/* Shares of the photons for each square metre: of those that go to the square, and of those that go anywhere, half of
 * them within √3/2 of a side from its middle. */
static double density_at(const struct camera_aim *aim, const double place[2])
{
    double cell = aim->size / SIDE, scale = aim->size / 2, density = 0;
    int column = cell_at(place[0], aim->x, aim->size), row = cell_at(place[1], aim->z, aim->size);
    if (column >= 0 && row >= 0)
        density = (aim->cells[row][column + 1] - aim->cells[row][column]) / (aim->rows[SIDE] * cell * cell);
    double x = (place[0] - aim->x) / scale - 1, z = (place[1] - aim->z) / scale - 1;
    double farther = pow(1 + x * x + z * z, -1.5) / (2 * M_PI * scale * scale);
    return (1 - FARTHER) * density + FARTHER * farther;
}

double camera_aim_place(const struct camera_aim *aim, double u, double v, double place[2])
{
    double cell = aim->size / SIDE, scale = aim->size / 2;
    if (v < FARTHER) {
        double left = 1 - v / FARTHER, away = scale * sqrt(1 / (left * left) - 1), sine, cosine;
        sine_cosine(u, &sine, &cosine);
        place[0] = aim->x + scale + away * cosine;
        place[1] = aim->z + scale + away * sine;
    } else {
        double in_row, in_column;
        int row = find_step(aim->rows, (v - FARTHER) / (1 - FARTHER) * aim->rows[SIDE], &in_row);
        int column = find_step(aim->cells[row], u * aim->cells[row][SIDE], &in_column);
        place[0] = aim->x + (column + in_column) * cell;
        place[1] = aim->z + (row + in_row) * cell;
    }
    return density_at(aim, place);
}
