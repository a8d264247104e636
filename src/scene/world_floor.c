/* The relief of the floor.
 *
 * Ripples of sand are crests of one wave whose direction and length vary: the phase of a sum of plane waves that differ
 * a little. Where that sum is 0 its phase has a fork, and so have the crests, as real ones do.
 *
 * 1. The sum, complex, of plane waves that fit the tile.
 * 2. Its phase gives the profile: sharp crests, broad troughs, steeper on one side; where the sum is small it is low.
 * 3. Broad swells are laid below.
 * 4. The mean is taken off, so that the floor stays as deep as the scene says. */
#include "scene/world_floor.h"

#include "base/log.h"
#include "base/random.h"
#include "io/format.h"
#include "water/grid.h"

#include <math.h>
#include <stdlib.h>

#define SIDE_LEAST 256
#define SIDE_MOST 1024
#define SAMPLES 8 /* vertices wanted from crest to crest */

enum { RIPPLES = 20, SWELLS = 10, MODES = RIPPLES + SWELLS };

/* Plane waves that fit the tile. */
struct modes {
    int cycles[MODES][2]; /* whole waves along x and z */
    double phases[MODES]; /* whole waves */
    double weights[MODES];
};

/* Nearly normal, of mean 0 and variance 1: the sum of twelve even numbers. */
static double normal_number(uint64_t counter)
{
    double sum = -6;
    for (uint64_t i = 0; i < 12; i++)
        sum += random_fraction(counter * 12 + i);
    return sum;
}

static void choose_modes(const struct dpl_scene *scene, struct modes *modes)
{
    const double waves = fmin(scene->settings.size / scene->floor.relief_length, SIDE_MOST / 4);
    const uint64_t seed = random_mix((uint64_t)scene->settings.seed + 0x5a4d);
    for (int m = 0; m < MODES; m++) {
        const uint64_t own = seed + 64 * (uint64_t)m;
        double length = waves * (1 + 0.06 * normal_number(own));
        double towards = scene->floor.relief_turn * M_PI / 180 + 0.11 * normal_number(own + 1);
        modes->weights[m] = 1 / sqrt(RIPPLES);
        if (m >= RIPPLES) {
            length = 1 + 3 * random_fraction(own + 2);
            towards = 2 * M_PI * random_fraction(own + 3);
            modes->weights[m] = 0.5 / length;
        }
        modes->cycles[m][0] = (int)lround(length * cos(towards));
        modes->cycles[m][1] = (int)lround(length * sin(towards));
        if (modes->cycles[m][0] == 0 && modes->cycles[m][1] == 0)
            modes->cycles[m][0] = 1;
        modes->phases[m] = random_fraction(own + 4);
    }
}

/* -1 to 1 over a wave: sharp above, broad below, the side towards larger phases steeper. */
static double profile(double phase)
{
    double skewed = phase - 0.45 * cos(phase);
    return 2 * pow(0.5 + 0.5 * cos(skewed), 1.6) - 1;
}

/* Cosine and sine of each mode's waves along one axis: entry (m, i) of MODES × side. */
static void fill_table(const struct modes *modes, int axis, int side, double (*table)[2])
{
    for (int m = 0; m < MODES; m++) {
        for (int i = 0; i < side; i++) {
            double turns = (double)((long long)modes->cycles[m][axis] * i % side) / side;
            double angle = 2 * M_PI * (turns + (axis == 0 ? modes->phases[m] : 0));
            table[m * side + i][0] = cos(angle);
            table[m * side + i][1] = sin(angle);
        }
    }
}

/* Height of one vertex, in those of the ripples. */
static double sand_at(const struct modes *modes, const double (*along_x)[2], const double (*along_z)[2], int side,
                      int i, int j)
{
    double real = 0, imaginary = 0, swell = 0;
    for (int m = 0; m < MODES; m++) {
        const double *x = along_x[m * side + i], *z = along_z[m * side + j];
        double cosine = modes->weights[m] * (x[0] * z[0] - x[1] * z[1]);
        if (m >= RIPPLES) {
            swell += cosine;
            continue;
        }
        real += cosine;
        imaginary += modes->weights[m] * (x[0] * z[1] + x[1] * z[0]);
    }
    double power = real * real + imaginary * imaginary;
    return profile(atan2(imaginary, real)) * sqrt(power / (power + 0.1)) + swell;
}

static bool make_ripples(struct world *world, const struct dpl_scene *scene, const struct dpl_log *log)
{
    const int side = world->relief_side;
    struct modes modes;
    double(*tables)[2] = base_allocate(log, 2 * MODES * (size_t)side, sizeof *tables, "relief");
    if (!tables)
        return false;
    double(*along_z)[2] = tables + MODES * side;
    double mean = 0;
    choose_modes(scene, &modes);
    fill_table(&modes, 0, side, tables);
    fill_table(&modes, 1, side, along_z);
#pragma omp parallel for schedule(static)
    for (int j = 0; j < side; j++)
        for (int i = 0; i < side; i++)
            world->relief[j * side + i] =
                (float)sand_at(&modes, (const double(*)[2])tables, (const double(*)[2])along_z, side, i, j);
    for (int v = 0; v < side * side; v++)
        mean += (double)world->relief[v] / side / side;
    for (int v = 0; v < side * side; v++) /* from trough to crest it is 2 */
        world->relief[v] = (float)(((double)world->relief[v] - mean) * scene->floor.relief_height / 2);
    free(tables);
    return true;
}

static double brightness(const struct dpl_image *image, int x, int y)
{
    x = (x + image->width) % image->width;
    y = (y + image->height) % image->height;
    const float *pixel = image->pixels + 3 * ((size_t)y * (size_t)image->width + (size_t)x);
    return ((double)pixel[0] + (double)pixel[1] + (double)pixel[2]) / 3;
}

/* Bilinear between the middles of pixels; the picture repeats. */
static double picture_at(const struct dpl_image *image, double u, double v)
{
    double x = u * image->width - 0.5, y = v * image->height - 0.5, s = x - floor(x), t = y - floor(y);
    int i = (int)floor(x), j = (int)floor(y);
    return (1 - t) * ((1 - s) * brightness(image, i, j) + s * brightness(image, i + 1, j)) +
           t * ((1 - s) * brightness(image, i, j + 1) + s * brightness(image, i + 1, j + 1));
}

static bool is_brightness(const struct dpl_image *image, const char *path, const struct dpl_log *log)
{
    for (size_t i = 0; i < (size_t)image->width * (size_t)image->height * 3; i++)
        if (!(image->pixels[i] >= 0 && image->pixels[i] <= 1))
            return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: not a brightness: %g (accepted: values from 0 to 1)",
                             path, (double)image->pixels[i]);
    return true;
}

static bool read_heights(struct world *world, const struct dpl_scene *scene, const struct dpl_log *outer)
{
    struct base_named_log named = {.name = "floor.relief_map", .outer = outer};
    const struct dpl_log *log = base_name_log(&named);
    const int side = world->relief_side;
    const char *path = scene->floor.relief_map;
    struct dpl_image *image = io_read(path, log);
    bool ok = image && is_brightness(image, path, log);
    for (int j = 0; j < side && ok; j++)
        for (int i = 0; i < side; i++)
            world->relief[j * side + i] =
                (float)(scene->floor.relief_height * (2 * picture_at(image, (double)i / side, (double)j / side) - 1));
    dpl_image_destroy(image);
    return ok;
}

bool floor_build(struct world *world, const struct dpl_scene *scene, const struct dpl_log *log)
{
    const struct scene_floor *floor = &scene->floor;
    if (floor->relief_height == 0)
        return true;
    int side = floor->relief_map[0] ? SIDE_MOST / 2 : SIDE_LEAST;
    while (!floor->relief_map[0] && side < SIDE_MOST && side < SAMPLES * scene->settings.size / floor->relief_length)
        side *= 2;
    world->relief = base_allocate(log, (size_t)side * (size_t)side, sizeof *world->relief, "relief");
    world->relief_side = side;
    if (!world->relief)
        return false;
    return floor->relief_map[0] ? read_heights(world, scene, log) : make_ripples(world, scene, log);
}

void world_floor(const struct world *world, double tile_size, double x, double z, double height_slopes[3])
{
    const struct height_grid grid = {world->relief_side, true, tile_size, world->relief};
    struct water_points points = {.count = 1,
                                  .x = &x,
                                  .z = &z,
                                  .height = height_slopes,
                                  .slope_x = height_slopes + 1,
                                  .slope_z = height_slopes + 2};
    height_slopes[0] = height_slopes[1] = height_slopes[2] = 0;
    if (world->relief_side > 0)
        grid_sample(&grid, &points);
}
