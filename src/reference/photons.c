#include "reference/photons.h"

#include "base/log.h"
#include "base/random.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define STRATA_MAX 2048 /* a side of the tile */
#define HALVES 2
#define BATCH 256         /* points of the water at a time */
#define PARTS 0x1p20      /* of a photon of weight 1, in the sums */
#define WEIGHT_MAX 0x1p16 /* of one photon: 2^43 photons of weight 1 fill a sum */

size_t photons_sum_count(const struct photons *photons)
{
    return (size_t)HALVES * (size_t)photons->receiver_count * (size_t)photons->side * (size_t)photons->side * 3;
}

static struct ray_window window_of(const struct photons_task *task, int receiver)
{
    double size = task->setup->size;
    return task->windows ? task->windows[receiver] : (struct ray_window){-size / 2, -size / 2, size};
}

/* Mean weights of flat water, of which a window larger than the tile needs more. */
static void measure_flat(struct photons *photons, const struct photons_task *task)
{
    for (int r = 0; r < task->receiver_count; r++) {
        ray_flat_mean(&photons->rays, &photons->disc, task->receivers[r], photons->flat[r]);
        for (int c = 0; c < 3; c++)
            photons->flat[r][c] *= pow(window_of(task, r).side / task->setup->size, 2);
    }
}

bool photons_begin(struct photons *photons, const struct photons_task *task, const struct dpl_log *log)
{
    if (photons->side != task->side || photons->receiver_count != task->receiver_count)
        photons_finish(photons);
    uint64_t *sums = photons->sums;
    *photons = (struct photons){
        .fingerprint = photons_fingerprint(task),
        .side = task->side,
        .receiver_count = task->receiver_count,
        .strata = 2 * task->side < STRATA_MAX ? 2 * task->side : STRATA_MAX,
        .disc = optics_sun_disc(task->sun),
    };
    photons->sums =
        sums ? sums : base_allocate(log, photons_sum_count(photons), sizeof *photons->sums, "photon counts");
    if (!photons->sums) {
        photons_finish(photons);
        return false;
    }
    memset(photons->sums, 0, photons_sum_count(photons) * sizeof *photons->sums);
    ray_medium_start(&photons->rays, task->medium, &photons->disc);
    measure_flat(photons, task);
    return true;
}

void photons_finish(struct photons *photons)
{
    free(photons->sums);
    *photons = (struct photons){0};
}

double photons_per_texel(const struct photons *photons)
{
    return HALVES * pow((double)photons->strata / photons->side, 2);
}

/* The dimension-th number, 0 to 1 without 1, of a stratum's photon in a pass. The sequence in four dimensions steps by
 * powers of 1/φ, φ^5 = φ + 1; all of it is arithmetic modulo 1, in parts of 2^64. */
static double draw(uint64_t stratum, uint64_t pass, int dimension)
{
    static const uint64_t steps[4] = {0xdb4f0b9175ae2165u, 0xbbe0563303a4615fu, 0xa0f2ec75a1fe1575u,
                                      0x89e182857d9ed689u};
    uint64_t start = random_mix((4 * stratum + (uint64_t)dimension + 1) * 0x9e3779b97f4a7c15u);
    return (double)((start + pass * steps[dimension]) >> 11) * 0x1p-53;
}

/* The texel along one side of the map that starts at `start` and is `side` wide; -1 beyond it. */
static int texel_at(const struct photons_task *task, double position, double start, double side)
{
    double place = (position - start) / side;
    if (task->model->shape(task->setup).periodic)
        place -= floor(place);
    if (!(place >= 0 && place <= 1))
        return -1;
    int texel = (int)(place * task->side);
    return texel < task->side ? texel : task->side - 1;
}

static void land(const struct photons *photons, const struct photons_task *task, const struct ray_point *point,
                 const struct ray *ray, int receiver, int color_count, uint64_t *sums)
{
    struct ray_hit hit;
    if (!ray_meet(ray, point, task->receivers[receiver], &hit))
        return;
    struct ray_window window = window_of(task, receiver);
    int i = texel_at(task, hit.x, window.x, window.side), j = texel_at(task, hit.z, window.z, window.side);
    if (i < 0 || j < 0)
        return;
    uint64_t *texel = sums + (((size_t)receiver * (size_t)task->side + (size_t)j) * (size_t)task->side + (size_t)i) * 3;
    for (int c = ray->color; c < ray->color + color_count; c++) {
        double weight = ray_weight(&photons->rays, ray, &hit, task->receivers[receiver], c);
        uint64_t parts = (uint64_t)(fmin(weight, WEIGHT_MAX) * PARTS + 0.5);
#pragma omp atomic
        texel[c] += parts;
    }
}

/* All colours and receivers of one photon. Where colours share a refractive index they share a ray. */
static void trace(const struct photons *photons, const struct photons_task *task, const struct ray_point *point,
                  uint64_t *sums)
{
    int together = photons->rays.ior[0] == photons->rays.ior[2] ? 3 : 1;
    for (int c = 0; c < 3; c += together) {
        struct ray ray = {.kind = RAY_KINDS};
        for (int r = 0; r < task->receiver_count; r++) {
            if (ray.kind != ray_kind_of(task->receivers[r]))
                ray = ray_start(&photons->rays, point, ray_kind_of(task->receivers[r]), c);
            if (ray.weight > 0)
                land(photons, task, point, &ray, r, together, sums);
        }
    }
}

/* Photons through `count` strata of a row from column `from`. */
static void trace_batch(const struct photons *photons, const struct photons_task *task, uint64_t half, int row,
                        int from, int count)
{
    double x[BATCH], z[BATCH], height[BATCH], slope_x[BATCH], slope_z[BATCH], shift_x[BATCH], shift_z[BATCH];
    double area[BATCH], size = task->setup->size, cell = size / photons->strata;
    uint64_t first = ((uint64_t)row * (uint64_t)photons->strata + (uint64_t)from) * HALVES + half;
    for (int i = 0; i < count; i++) {
        x[i] = (from + i + draw(first + HALVES * (uint64_t)i, photons->passes, 0)) * cell - size / 2;
        z[i] = (row + draw(first + HALVES * (uint64_t)i, photons->passes, 1)) * cell - size / 2;
    }
    struct water_points points = {count, x, z, height, slope_x, slope_z, shift_x, shift_z, area};
    water_sample(task->model, task->setup, task->time, &points);
    uint64_t *sums = photons->sums + half * (photons_sum_count(photons) / HALVES);
    for (int i = 0; i < count; i++) {
        uint64_t stratum = first + HALVES * (uint64_t)i;
        struct ray_point point = {x[i] + shift_x[i], z[i] + shift_z[i], height[i], slope_x[i],
                                  slope_z[i],        area[i],           {0}};
        double place[2];
        optics_disc_spread(draw(stratum, photons->passes, 2), draw(stratum, photons->passes, 3), place);
        optics_disc_place(&photons->disc, place, point.to_light);
        trace(photons, task, &point, sums);
    }
}

void photons_pass(struct photons *photons, const struct photons_task *task)
{
#pragma omp parallel for schedule(dynamic)
    for (int row = 0; row < photons->strata; row++)
        for (int from = 0; from < photons->strata; from += BATCH)
            for (uint64_t half = 0; half < HALVES; half++)
                trace_batch(photons, task, half, row, from,
                            photons->strata - from < BATCH ? photons->strata - from : BATCH);
    photons->passes++;
}

void photons_read(const struct photons *photons, int receiver, float *texels)
{
    size_t count = (size_t)photons->side * (size_t)photons->side * 3;
    const uint64_t *first = photons->sums + (size_t)receiver * count;
    const uint64_t *second = first + photons_sum_count(photons) / HALVES;
    double sent = photons_per_texel(photons) * (double)photons->passes * PARTS, scale[3];
    for (int c = 0; c < 3; c++)
        scale[c] = photons->flat[receiver][c] > 0 ? 1 / (sent * photons->flat[receiver][c]) : 0;
    for (size_t i = 0; i < count; i++)
        texels[i] = (float)((double)(first[i] + second[i]) * scale[i % 3]);
}

double photons_noise(const struct photons *photons)
{
    size_t half = photons_sum_count(photons) / HALVES, texels = half / (size_t)photons->receiver_count;
    double difference = 0, sum = 0;
    for (size_t i = 0; i < half; i++) {
        double flat = photons->flat[i / texels][i % 3];
        double first = (double)photons->sums[i], second = (double)photons->sums[half + i];
        double scale = flat > 0 ? 1 / (flat * flat) : 0;
        difference += (first - second) * (first - second) * scale;
        sum += (first + second) * (first + second) * scale;
    }
    return sum > 0 ? sqrt(difference / sum) : 0;
}
