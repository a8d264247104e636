/* A sum of sine waves, each with whole cycles across the tile: periodic in space, and in time where the scene loops.
 *
 *     h = Σ A cos(2π (cx x + cz z) / L - 2π t / period + phase)
 *
 * Without a period of its own a wave has that of the linear dispersion relation of water of finite depth,
 * ω² = g k tanh(k depth) (Airy 1845). Slopes are exact derivatives.
 *
 * A wave of steepness s also moves the points towards its crests (Gerstner 1802; Fournier & Reeves 1986), by
 *
 *     D = -Σ (s / k²) k⃗ sin θ,   k⃗: wave vector, θ: the angle above
 *
 * where s = k A are the circular orbits of deep water, and s = 1 is a cusp (the Q of Finch 2004, GPU Gems, ch. 1). A
 * point's neighbourhood is stretched by J = 1 - Σ (s / k²) k⃗ k⃗ᵀ cos θ; the slopes of the surface where the point is
 * now are J⁻¹ times those over the points at rest, and its area is det J, which is not below 0 while Σ s ≤ 1: larger
 * sums are scaled back to 1. */
#include "base/sine.h"
#include "base/vector.h"
#include "water/water.h"

#include <math.h>

#define PERIOD_MIN 0.001 /* s; keeps time / period finite */
#define AREA_MIN 1e-4    /* det J at which the slopes of a cusp end */

const struct dpl_param water_wave_params[] = {
    PARAM_INTS(struct wave, cycles, 2, -256, 256, "", "whole waves across the tile, along x and along z", 1, 0),
    PARAM_FLOAT(struct wave, amplitude, 0.01, 0, 100, "m", "height of a crest above the rest surface"),
    PARAM_FLOAT(struct wave, phase, 0, -360, 360, "degrees", "phase at the middle of the tile at time 0"),
    PARAM_FLOAT(struct wave, period, 0, 0, 1e4, "s", "time of one oscillation; 0 = from the dispersion relation"),
    PARAM_FLOAT(
        struct wave, steepness, 0, 0, 1, "",
        "0 = a sine, 1 = crests as sharp as can be, which need a fine mesh; where all waves' sum exceeds 1 they are "
        "scaled back to 1"),
    PARAM_END,
};

static double period_of(const struct wave *wave, const struct water_setup *setup)
{
    double k = 2 * M_PI * hypot(wave->cycles[0], wave->cycles[1]) / setup->size;
    double period = wave->period;
    if (period == 0 && k > 0)
        period = 2 * M_PI / sqrt(WATER_GRAVITY * k * tanh(k * setup->depth));
    if (period > 0 && setup->loop > 0)
        period = setup->loop / fmax(1, round(setup->loop / period));
    return period > 0 ? fmax(period, PERIOD_MIN) : 0;
}

/* Phase at the middle of the tile in turns, 0 to 1, so that it stays exact when time is long. */
static double phase_at(const struct wave *wave, const struct water_setup *setup, double time)
{
    double period = period_of(wave, setup);
    double turns = wave->phase / 360 - (period > 0 ? time / period : 0);
    return turns - floor(turns);
}

static double steepness_of(const struct wave *wave)
{
    return wave->cycles[0] || wave->cycles[1] ? wave->steepness : 0;
}

static double steepness_sum(const struct water_setup *setup)
{
    double sum = 0;
    for (int w = 0; w < setup->wave_count; w++)
        sum += steepness_of(setup->waves + w);
    return sum;
}

static struct water_shape shape(const struct water_setup *setup)
{
    return (struct water_shape){.side = setup->mesh, .periodic = true, .choppy = steepness_sum(setup) > 0};
}

/* s / k² of a wave, m², where the steepnesses of all sum up to `sum`. */
static double curl_of(const struct wave *wave, const struct water_setup *setup, double sum)
{
    double k = 2 * M_PI * hypot(wave->cycles[0], wave->cycles[1]) / setup->size;
    return k > 0 ? wave->steepness / fmax(sum, 1) / (k * k) : 0;
}

/* The waves at one time: h = Σ amplitude cos(2π (along_x x + along_z z + phase)). */
struct motion {
    int count;
    bool choppy;
    double curl[WATER_WAVES_MAX];                                                          /* s / k², m² */
    double along_x[WATER_WAVES_MAX], along_z[WATER_WAVES_MAX];                             /* turns a metre */
    double phase[WATER_WAVES_MAX];                                                         /* turns */
    double amplitude[WATER_WAVES_MAX], slope_x[WATER_WAVES_MAX], slope_z[WATER_WAVES_MAX]; /* of cosine, of sine */
};

static void motion_at(struct motion *motion, const struct water_setup *setup, double time)
{
    double sum = steepness_sum(setup);
    motion->count = setup->wave_count;
    motion->choppy = sum > 0;
    for (int w = 0; w < setup->wave_count; w++) {
        const struct wave *wave = setup->waves + w;
        motion->along_x[w] = wave->cycles[0] / setup->size;
        motion->along_z[w] = wave->cycles[1] / setup->size;
        motion->phase[w] = phase_at(wave, setup, time);
        motion->amplitude[w] = wave->amplitude;
        motion->slope_x[w] = -2 * M_PI * motion->along_x[w] * wave->amplitude;
        motion->slope_z[w] = -2 * M_PI * motion->along_z[w] * wave->amplitude;
        motion->curl[w] = curl_of(wave, setup, sum);
    }
}

/* Along a row a wave's angle grows by the same step from column to column: within a chunk of columns its sine and
 * cosine follow from those of the first column, turned by the same angles in every chunk. */
#define CHUNK 16
struct turn {
    float cosine[CHUNK], sine[CHUNK];
};

VECTOR_CLONES static void fill_chunk(const struct motion *motion, const struct turn *turns, double x, double z,
                                     float height[restrict CHUNK], float slope_x[restrict CHUNK],
                                     float slope_z[restrict CHUNK])
{
    double cosines[WATER_WAVES_MAX], sines[WATER_WAVES_MAX];
    for (int w = 0; w < motion->count; w++)
        sine_cosine(motion->along_x[w] * x + motion->along_z[w] * z + motion->phase[w], sines + w, cosines + w);
    for (int i = 0; i < CHUNK; i++)
        height[i] = slope_x[i] = slope_z[i] = 0;
    for (int w = 0; w < motion->count; w++) {
        const struct turn *turn = turns + w;
        float height_cosine = (float)(motion->amplitude[w] * cosines[w]);
        float height_sine = (float)(motion->amplitude[w] * sines[w]);
        float x_cosine = (float)(motion->slope_x[w] * cosines[w]), x_sine = (float)(motion->slope_x[w] * sines[w]);
        float z_cosine = (float)(motion->slope_z[w] * cosines[w]), z_sine = (float)(motion->slope_z[w] * sines[w]);
        for (int i = 0; i < CHUNK; i++) {
            height[i] += height_cosine * turn->cosine[i] - height_sine * turn->sine[i];
            slope_x[i] += x_sine * turn->cosine[i] + x_cosine * turn->sine[i];
            slope_z[i] += z_sine * turn->cosine[i] + z_cosine * turn->sine[i];
        }
    }
}

/* Slopes over the points at rest become those of the surface where the points are now; xx, xz, zz are 1 - J. Returns
 * det J. */
VECTOR_PART double move_slopes(double xx, double xz, double zz, double slopes[2])
{
    double area = (1 - xx) * (1 - zz) - xz * xz, at_rest[2] = {slopes[0], slopes[1]};
    double per_area = 1 / (AREA_MIN + 0.5 * (area - AREA_MIN + fabs(area - AREA_MIN)));
    slopes[0] = ((1 - zz) * at_rest[0] + xz * at_rest[1]) * per_area;
    slopes[1] = ((1 - xx) * at_rest[1] + xz * at_rest[0]) * per_area;
    return area;
}

VECTOR_CLONES static void shift_chunk(const struct motion *motion, const struct turn *turns, double x, double z,
                                      float slope_x[restrict CHUNK], float slope_z[restrict CHUNK],
                                      float shift_x[restrict CHUNK], float shift_z[restrict CHUNK])
{
    float xx[CHUNK] = {0}, xz[CHUNK] = {0}, zz[CHUNK] = {0};
    for (int i = 0; i < CHUNK; i++)
        shift_x[i] = shift_z[i] = 0;
    for (int w = 0; w < motion->count; w++) {
        double sine, cosine, kx = 2 * M_PI * motion->along_x[w], kz = 2 * M_PI * motion->along_z[w];
        sine_cosine(motion->along_x[w] * x + motion->along_z[w] * z + motion->phase[w], &sine, &cosine);
        float first_sine = (float)(motion->curl[w] * sine), first_cosine = (float)(motion->curl[w] * cosine);
        float along_x = (float)kx, along_z = (float)kz;
        for (int i = 0; i < CHUNK; i++) {
            float curl_sine = first_sine * turns[w].cosine[i] + first_cosine * turns[w].sine[i];
            float curl_cosine = first_cosine * turns[w].cosine[i] - first_sine * turns[w].sine[i];
            shift_x[i] -= along_x * curl_sine;
            shift_z[i] -= along_z * curl_sine;
            xx[i] += along_x * along_x * curl_cosine;
            xz[i] += along_x * along_z * curl_cosine;
            zz[i] += along_z * along_z * curl_cosine;
        }
    }
    for (int i = 0; i < CHUNK; i++) {
        double slopes[2] = {slope_x[i], slope_z[i]};
        move_slopes(xx[i], xz[i], zz[i], slopes);
        slope_x[i] = (float)slopes[0];
        slope_z[i] = (float)slopes[1];
    }
}

static void fill_row(const struct motion *motion, const struct turn *turns, struct surface *surface, int row)
{
    double spacing = surface_spacing(surface), half = surface->size / 2;
    size_t first = (size_t)row * (size_t)surface->columns;
    float *texel = surface->texels + first * 3, *shift = motion->choppy ? surface->shifts + first * 2 : NULL;
    for (int start = 0; start < surface->columns; start += CHUNK) {
        float height[CHUNK], slope_x[CHUNK], slope_z[CHUNK], shift_x[CHUNK], shift_z[CHUNK];
        double x = start * spacing - half, z = row * spacing - half;
        fill_chunk(motion, turns, x, z, height, slope_x, slope_z);
        if (shift)
            shift_chunk(motion, turns, x, z, slope_x, slope_z, shift_x, shift_z);
        for (int i = 0; i < CHUNK && start + i < surface->columns; i++, texel += 3) {
            texel[0] = height[i];
            texel[1] = slope_x[i];
            texel[2] = slope_z[i];
        }
        for (int i = 0; i < CHUNK && start + i < surface->columns && shift; i++, shift += 2) {
            shift[0] = shift_x[i];
            shift[1] = shift_z[i];
        }
    }
}

static void evaluate(void *state, const struct water_setup *setup, double time, struct surface *surface)
{
    (void)state;
    struct motion motion;
    struct turn turns[WATER_WAVES_MAX];
    motion_at(&motion, setup, time);
    for (int w = 0; w < motion.count; w++) {
        for (int i = 0; i < CHUNK; i++) {
            double sine, cosine;
            sine_cosine(motion.along_x[w] * surface_spacing(surface) * i, &sine, &cosine);
            turns[w].cosine[i] = (float)cosine;
            turns[w].sine[i] = (float)sine;
        }
    }
#pragma omp parallel for
    for (int j = 0; j < surface->rows; j++)
        fill_row(&motion, turns, surface, j);
}

VECTOR_CLONES static void add_wave(const struct motion *motion, int w, int count, const double *restrict x,
                                   const double *restrict z, double *restrict height, double *restrict slope_x,
                                   double *restrict slope_z)
{
    double along_x = motion->along_x[w], along_z = motion->along_z[w], phase = motion->phase[w];
    double amplitude = motion->amplitude[w], per_x = motion->slope_x[w], per_z = motion->slope_z[w];
    for (int i = 0; i < count; i++) {
        double sine, cosine;
        sine_cosine(along_x * x[i] + along_z * z[i] + phase, &sine, &cosine);
        height[i] += amplitude * cosine;
        slope_x[i] += per_x * sine;
        slope_z[i] += per_z * sine;
    }
}

/* Adds how points move, and how what is next to them is stretched: 1 - J. */
VECTOR_CLONES static void add_shift(const struct motion *motion, int w, int count, const double *restrict x,
                                    const double *restrict z, double *restrict shift_x, double *restrict shift_z,
                                    double *restrict xx, double *restrict xz, double *restrict zz)
{
    double along_x = motion->along_x[w], along_z = motion->along_z[w], phase = motion->phase[w];
    double curl = motion->curl[w], kx = 2 * M_PI * along_x, kz = 2 * M_PI * along_z;
    for (int i = 0; i < count; i++) {
        double sine, cosine;
        sine_cosine(along_x * x[i] + along_z * z[i] + phase, &sine, &cosine);
        shift_x[i] -= curl * kx * sine;
        shift_z[i] -= curl * kz * sine;
        xx[i] += curl * kx * kx * cosine;
        xz[i] += curl * kx * kz * cosine;
        zz[i] += curl * kz * kz * cosine;
    }
}

#define BLOCK 512 /* points, which stay in the cache from wave to wave */

/* Moves points whose heights and slopes are those at rest. */
static void shift_points(const struct motion *motion, int from, int count, struct water_points *points)
{
    double xx[BLOCK] = {0}, xz[BLOCK] = {0}, zz[BLOCK] = {0};
    for (int i = from; i < from + count; i++)
        points->shift_x[i] = points->shift_z[i] = 0;
    for (int w = 0; w < motion->count; w++)
        add_shift(motion, w, count, points->x + from, points->z + from, points->shift_x + from, points->shift_z + from,
                  xx, xz, zz);
    for (int i = 0; i < count; i++) {
        double slopes[2] = {points->slope_x[from + i], points->slope_z[from + i]};
        points->area[from + i] = move_slopes(xx[i], xz[i], zz[i], slopes);
        points->slope_x[from + i] = slopes[0];
        points->slope_z[from + i] = slopes[1];
    }
}

static void sample(const void *state, const struct water_setup *setup, double time, struct water_points *points)
{
    (void)state;
    struct motion motion;
    motion_at(&motion, setup, time);
    for (int from = 0; from < points->count; from += BLOCK) {
        int count = points->count - from < BLOCK ? points->count - from : BLOCK;
        for (int i = from; i < from + count; i++)
            points->height[i] = points->slope_x[i] = points->slope_z[i] = 0;
        for (int w = 0; w < motion.count; w++)
            add_wave(&motion, w, count, points->x + from, points->z + from, points->height + from,
                     points->slope_x + from, points->slope_z + from);
        if (motion.choppy)
            shift_points(&motion, from, count, points);
    }
}

/* The first vec4 is (number of waves, 1 where they are choppy). A wave is a vec4: wave numbers along x and z (1/m),
 * amplitude (m), phase now. Past the room for all waves every vec4 holds s / k² (m²) of four. */
static int constants(const struct water_setup *setup, double time, float constants[WATER_CONSTANTS_MAX][4])
{
    double sum = steepness_sum(setup);
    constants[0][0] = (float)setup->wave_count;
    constants[0][1] = sum > 0;
    for (int w = 0; w < setup->wave_count; w++) {
        const struct wave *wave = setup->waves + w;
        constants[w + 1][0] = (float)(2 * M_PI * wave->cycles[0] / setup->size);
        constants[w + 1][1] = (float)(2 * M_PI * wave->cycles[1] / setup->size);
        constants[w + 1][2] = (float)wave->amplitude;
        constants[w + 1][3] = (float)(2 * M_PI * phase_at(wave, setup, time));
        constants[1 + WATER_WAVES_MAX + w / 4][w % 4] = (float)curl_of(wave, setup, sum);
    }
    return 1 + (sum > 0 ? WATER_WAVES_MAX + (setup->wave_count + 3) / 4 : setup->wave_count);
}

const struct water_model water_sines = {
    .name = "sines",
    .summary = "a list of sine waves, [wave.1] to [wave.64], steep ones too; exact slopes, periodic, loops",
    .source = "Airy 1845; Gerstner 1802",
    .shape = shape,
    .evaluate = evaluate,
    .sample = sample,
    .shader = "water/sines.glsl",
    .constants = constants,
};
