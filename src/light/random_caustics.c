/* After Stam 1996, "Random Caustics: Natural Textures and Wave Theory Revisited".
 *
 *   1. The surface is a sum of waves on the grid's frequencies f, of random phases, whose power makes heights with the
 *      correlation height² exp(-r²/correlation²). Each goes through a whole number of turns in a loop, that of the
 *      dispersion relation ω² = g k of deep water, rounded. So it repeats in space and in time.
 *   2. A plane wave of light from straight above is late by φ = 2π (n - 1) h/λ under the surface: u = exp(iφ).
 *   3. It travels to the floor: by a Fourier transform, × exp(-iπ (λ/n) depth f²) (Fresnel), and back.
 *   4. The light is |u|², mean 1 since step 3 changes only phases; it is averaged over wavelengths.
 *
 * With real wavelengths (0.5 µm) the grid would have to be as fine as they are; with the shortest that a grid holds,
 * rays are as they would be, but lines have diffraction fringes, wider by far than nature's. An average over as wide a
 * range as that of the eye (1 : 1.75) leaves the first fringe, the line itself. */
#include "light/random_caustics.h"

#include "base/log.h"
#include "base/random.h"
#include "base/sine.h"
#include "base/vector.h"
#include "water/water.h"

#include <math.h>
#include <stdlib.h>

#define COLOR_RANGE 1.75 /* longest wavelength to shortest, of light that the eye sees */

/* The frequency at place i of an axis, in waves across the tile. */
static int frequency(int i, int side)
{
    return i <= side / 2 ? i : i - side;
}

/* Where slopes are three times their RMS along an axis, φ changes by a quarter turn from texel to texel: half of what
 * the grid holds, as |u|² has twice the frequencies of u. */
double random_caustics_wavelength(const struct random_caustics_recipe *recipe)
{
    double slope = sqrt(2) * recipe->height / recipe->correlation;
    double shortest = 4 * (recipe->ior - 1) * 3 * slope * recipe->tile / recipe->side;
    return recipe->wavelength > 0 ? recipe->wavelength : fmax(shortest, 1e-9);
}

/* 0 to 1 without 1: the same for a frequency whatever the grid. */
static float random_phase(int seed, int x, int z)
{
    uint64_t place = (uint64_t)(x + 0x8000) << 16 | (uint64_t)(z + 0x8000);
    return (float)(random_mix(random_mix((uint64_t)seed + 1) + place) >> 40) * 0x1p-24f;
}

/* Step 1, what does not change: waves by their frequency. The mean of a wave's square is half its amplitude's. */
static void make_waves(struct random_caustics *caustics)
{
    const struct random_caustics_recipe *recipe = &caustics->recipe;
    int side = recipe->side;
    double sum = 0, unit = 2 * M_PI / recipe->tile, fall = recipe->correlation * recipe->correlation / 4;
    for (int j = 0, place = 0; j < side; j++) {
        for (int i = 0; i < side; i++, place++) {
            int x = frequency(i, side), z = frequency(j, side);
            double waves = (double)x * x + (double)z * z, k = unit * sqrt(waves);
            /* less that of the longest wave: of very long ones at least that is left */
            double power = waves > 0 ? exp(-fall * unit * unit * (waves - 1)) : 0;
            sum += power;
            caustics->amplitudes[place] = (float)sqrt(power);
            caustics->phases[place] = random_phase(recipe->seed, x, z);
            caustics->turns[place] = (float)fmax(round(sqrt(WATER_GRAVITY * k) / (2 * M_PI) * recipe->loop), 1);
        }
    }
    float scale = sum > 0 ? (float)(recipe->height * sqrt(2 / sum)) : 0;
    for (int place = 0; place < side * side; place++)
        caustics->amplitudes[place] *= scale;
}

bool random_caustics_begin(struct random_caustics *caustics, const struct random_caustics_recipe *recipe,
                           const struct dpl_log *log)
{
    size_t count = (size_t)recipe->side * (size_t)recipe->side;
    if (caustics->recipe.side != recipe->side) {
        random_caustics_finish(caustics);
        caustics->forward = fft_create(recipe->side, false, log);
        caustics->inverse = caustics->forward ? fft_create(recipe->side, true, log) : NULL;
        caustics->grid = caustics->inverse ? base_allocate(log, count, sizeof *caustics->grid, "random waves") : NULL;
        caustics->heights = caustics->grid ? base_allocate(log, count, 4 * sizeof(float), "random waves") : NULL;
        if (!caustics->heights) {
            random_caustics_finish(caustics);
            return false;
        }
        caustics->amplitudes = caustics->heights + count;
        caustics->phases = caustics->amplitudes + count;
        caustics->turns = caustics->phases + count;
    }
    caustics->recipe = *recipe;
    make_waves(caustics);
    return true;
}

void random_caustics_heights(struct random_caustics *caustics, int frame)
{
    int count = caustics->recipe.side * caustics->recipe.side;
    double part = (double)frame / caustics->recipe.frames;
#pragma omp parallel for
    for (int i = 0; i < count; i++) {
        double sine, cosine;
        sine_cosine((double)caustics->phases[i] - (double)caustics->turns[i] * part, &sine, &cosine);
        caustics->grid[i][0] = caustics->amplitudes[i] * (float)cosine;
        caustics->grid[i][1] = caustics->amplitudes[i] * (float)sine;
    }
    fft_run(caustics->inverse, caustics->grid);
#pragma omp parallel for
    for (int i = 0; i < count; i++)
        caustics->heights[i] = caustics->grid[i][0];
}

/* A row of step 2; `turns` a metre of height. */
VECTOR_CLONES static void delay(const float *restrict heights, double turns, int count, float (*restrict row)[2])
{
    for (int i = 0; i < count; i++) {
        double sine, cosine;
        sine_cosine(turns * (double)heights[i], &sine, &cosine);
        row[i][0] = (float)cosine;
        row[i][1] = (float)sine;
    }
}

/* A row of step 3, whose frequency along the other axis is z: × exp(-iπ `reach` f²) / count, f in waves a tile. */
static void travel(double reach, int z, int side, float (*row)[2])
{
    float scale = 1.0f / ((float)side * (float)side);
    for (int i = 0; i < side; i++) {
        double sine, cosine, x = frequency(i, side);
        sine_cosine(-reach / 2 * (x * x + (double)z * z), &sine, &cosine);
        float real = row[i][0], imaginary = row[i][1], c = (float)cosine * scale, s = (float)sine * scale;
        row[i][0] = real * c - imaginary * s;
        row[i][1] = real * s + imaginary * c;
    }
}

static void add_color(struct random_caustics *caustics, double wavelength, float share, float *light)
{
    const struct random_caustics_recipe *recipe = &caustics->recipe;
    int side = recipe->side;
    double turns = (recipe->ior - 1) / wavelength;
    double reach = wavelength / recipe->ior * recipe->depth / (recipe->tile * recipe->tile);
    float(*grid)[2] = caustics->grid;
#pragma omp parallel for
    for (int j = 0; j < side; j++)
        delay(caustics->heights + (size_t)j * (size_t)side, turns, side, grid + (size_t)j * (size_t)side);
    fft_run(caustics->forward, grid);
#pragma omp parallel for
    for (int j = 0; j < side; j++)
        travel(reach, frequency(j, side), side, grid + (size_t)j * (size_t)side);
    fft_run(caustics->inverse, grid);
#pragma omp parallel for
    for (int i = 0; i < side * side; i++)
        light[i] += share * (grid[i][0] * grid[i][0] + grid[i][1] * grid[i][1]);
}

void random_caustics_light(struct random_caustics *caustics, int frame, float *light)
{
    const struct random_caustics_recipe *recipe = &caustics->recipe;
    double shortest = random_caustics_wavelength(recipe);
    random_caustics_heights(caustics, frame);
    for (int i = 0; i < recipe->side * recipe->side; i++)
        light[i] = 0;
    for (int k = 0; k < recipe->colors; k++)
        add_color(caustics, shortest * pow(COLOR_RANGE, (double)k / recipe->colors), 1.0f / (float)recipe->colors,
                  light);
}

void random_caustics_finish(struct random_caustics *caustics)
{
    fft_destroy(caustics->forward);
    fft_destroy(caustics->inverse);
    free(caustics->grid);
    free(caustics->heights);
    *caustics = (struct random_caustics){0};
}
