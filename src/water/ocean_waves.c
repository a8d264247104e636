/* The waves of `ocean`, from random amplitudes to the surface's spline coefficients. */
#include "water/ocean.h"

#include "base/log.h"
#include "base/random.h"
#include "base/sine.h"
#include "base/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define RATIO 4 /* of the next cascade's wave numbers to this one's */

int ocean_cells(const struct ocean_state *state, int cascade)
{
    return state->side << 2 * cascade; /* RATIO^cascade times */
}

/* Whole waves along an axis of a cascade, for the index-th entry of a Fourier transform. */
static int cycles_at(int index, int modes)
{
    return index < modes / 2 ? index : index - modes;
}

/* Two independent normal numbers of a wave, the same whatever else there is (Box & Muller 1958). */
static void draw_normals(int seed, int cascade, int x, int z, double normals[2])
{
    const int most = OCEAN_SIDE_MAX; /* more than there are cycles, of either sign */
    uint64_t wave = (uint64_t)seed * OCEAN_CASCADES_MAX + (uint64_t)cascade;
    wave = wave * (uint64_t)(most * most) + (uint64_t)((x + most / 2) * most + z + most / 2);
    double uniform[2], sine, cosine;
    for (uint64_t i = 0; i < 2; i++)
        uniform[i] = ((double)(random_mix((2 * wave + i + 1) * 0x9e3779b97f4a7c15u) >> 11) + 0.5) * 0x1p-53;
    double radius = sqrt(-2 * log(uniform[0]));
    sine_cosine(uniform[1], &sine, &cosine);
    normals[0] = radius * cosine;
    normals[1] = radius * sine;
}

/* What a cubic B-spline makes of a wave, at its vertices: coefficients are greater by that (Unser 1999). */
static double spline_response(int cycles, int side)
{
    return (2 + cos(2 * M_PI * cycles / side)) / 3;
}

/* Turns in a unit of the clock; whole ones where that is a loop, and then at least one. */
static double turns_at(double k, const struct water_setup *setup)
{
    double turns = ocean_frequency(k, setup->depth, NULL) / (2 * M_PI);
    return setup->loop > 0 ? fmax(1, round(turns * setup->loop)) : turns;
}

/* A row of a cascade's waves. A cascade leaves to the one before it what that has, and all waves have four vertices
 * at least. */
static void make_row(struct ocean_state *state, const struct water_setup *setup, int cascade, int row)
{
    const struct ocean *ocean = setup->params;
    int modes = state->modes, most = modes / 2, least = cascade > 0 ? most / RATIO : 1, z = cycles_at(row, modes);
    double step = 2 * M_PI / setup->size * ocean_cells(state, cascade) / state->side; /* between wave numbers, 1/m */
    size_t first = ((size_t)cascade * (size_t)modes + (size_t)row) * (size_t)modes;
    for (int i = 0; i < modes; i++) {
        int x = cycles_at(i, modes), square = x * x + z * z;
        float *amplitude = state->amplitudes[first + (size_t)i];
        amplitude[0] = amplitude[1] = 0;
        state->turns[first + (size_t)i] = 0;
        if (square < least * least || square >= most * most)
            continue;
        double normals[2],
            scale = ocean->amplitude * step * sqrt(ocean_density(ocean, setup->depth, x * step, z * step));
        scale /= spline_response(x, state->side) * spline_response(z, state->side);
        draw_normals(setup->seed, cascade, x, z, normals);
        for (int part = 0; part < 2; part++)
            amplitude[part] = (float)(scale * normals[part]);
        state->turns[first + (size_t)i] = turns_at(sqrt(square) * step, setup);
    }
}

static bool resize(struct ocean_state *state, int side, int cascades, bool choppy, const struct dpl_log *log)
{
    int tiles = choppy ? cascades : 1;
    if (state->fft && state->side == side && state->cascades == cascades && state->tiles == tiles &&
        choppy == (state->choppiness > 0))
        return true;
    ocean_waves_finish(state);
    state->side = side;
    state->modes = side / 2;
    state->cascades = cascades;
    state->tiles = tiles;
    state->pairs = choppy ? 2 * cascades : (cascades + 1) / 2;
    size_t entries = (size_t)state->modes * (size_t)state->modes, waves = entries * (size_t)cascades;
    size_t cells = (size_t)side * (size_t)side * (size_t)state->pairs;
    state->amplitudes = base_allocate(log, waves, sizeof *state->amplitudes, "ocean");
    state->turns = base_allocate(log, waves, sizeof *state->turns, "ocean");
    state->moved = base_allocate(log, entries, sizeof *state->moved, "ocean");
    state->spectrum = base_allocate(log, entries * (size_t)tiles * 4, sizeof *state->spectrum, "ocean");
    state->grids = base_allocate(log, cells, sizeof *state->grids, "ocean");
    state->fft = fft_create(side, true, log);
    if (state->amplitudes && state->turns && state->moved && state->spectrum && state->grids && state->fft)
        return true;
    ocean_waves_finish(state);
    return false;
}

void ocean_waves_finish(struct ocean_state *state)
{
    free(state->amplitudes);
    free(state->turns);
    free(state->moved);
    free(state->spectrum);
    free(state->grids);
    fft_destroy(state->fft);
    state->amplitudes = state->moved = state->grids = NULL;
    state->turns = NULL;
    state->spectrum = NULL;
    state->fft = NULL;
}

/* Turns a row of waves on by the clock. */
VECTOR_CLONES static void move_row(int count, double clock, const float (*restrict amplitudes)[2],
                                   const double *restrict turns, float (*restrict moved)[2])
{
    for (int i = 0; i < count; i++) {
        double sine, cosine;
        sine_cosine(-turns[i] * clock, &sine, &cosine);
        float c = (float)cosine, s = (float)sine;
        moved[i][0] = amplitudes[i][0] * c - amplitudes[i][1] * s;
        moved[i][1] = amplitudes[i][0] * s + amplitudes[i][1] * c;
    }
}

/* Adds a row of a cascade to the spectra of the fields. Heights are H(k) = (A(k) + A*(-k)) / 2, so that they are real;
 * shifts are i k/|k| times that, which brings crests together; a pair of fields a, b is a + i b. */
static void add_row(struct ocean_state *state, int cascade, int row)
{
    int modes = state->modes, z = cycles_at(row, modes);
    bool choppy = state->choppiness > 0;
    const float(*here)[2] = state->moved + (size_t)row * (size_t)modes;
    const float(*there)[2] = state->moved + (size_t)(-row & (modes - 1)) * (size_t)modes;
    size_t tile_row = (size_t)(choppy ? cascade * modes + row : row);
    float *out = state->spectrum + tile_row * (size_t)modes * 4;
    for (int i = 0; i < modes; i++, out += 4) {
        const float *opposite = there[-i & (modes - 1)];
        float real = 0.5f * (here[i][0] + opposite[0]), imaginary = 0.5f * (here[i][1] - opposite[1]);
        int x = cycles_at(i, modes);
        if (choppy) {
            float scale = (float)(state->choppiness / fmax(sqrt(x * x + z * z), 1));
            float along_x = scale * (float)x, along_z = scale * (float)z;
            out[0] = real * (1 - along_x);
            out[1] = imaginary * (1 - along_x);
            out[2] = -imaginary * along_z;
            out[3] = real * along_z;
        } else {
            float *pair = out + cascade / 2 * 2;
            pair[0] += cascade % 2 ? -imaginary : real;
            pair[1] += cascade % 2 ? real : imaginary;
        }
    }
}

/* Makes `spectrum` that of the clock. */
static void move_waves(struct ocean_state *state)
{
    int modes = state->modes;
    size_t entries = (size_t)modes * (size_t)modes;
    memset(state->spectrum, 0, entries * (size_t)state->tiles * 4 * sizeof *state->spectrum);
    for (int cascade = 0; cascade < state->cascades; cascade++) {
        size_t first = (size_t)cascade * entries;
#pragma omp parallel for
        for (int row = 0; row < modes; row++) {
            size_t from = (size_t)row * (size_t)modes;
            move_row(modes, state->clock, (const float(*)[2])(state->amplitudes + first + from),
                     state->turns + first + from, state->moved + from);
        }
#pragma omp parallel for
        for (int row = 0; row < modes; row++)
            add_row(state, cascade, row);
    }
}

/* Copies a pair's spectrum to the grid, with zeros for the waves of less than four vertices. */
static void place_pair(const struct ocean_state *state, int pair, float (*grid)[2])
{
    int modes = state->modes, side = state->side;
    memset(grid, 0, (size_t)side * (size_t)side * sizeof *grid);
    const float *from = state->spectrum + (size_t)(pair / 2) * (size_t)modes * (size_t)modes * 4 + pair % 2 * 2;
    for (int j = 0; j < modes; j++) {
        float(*row)[2] = grid + (size_t)(cycles_at(j, modes) & (side - 1)) * (size_t)side;
        for (int i = 0; i < modes; i++, from += 4)
            memcpy(row[cycles_at(i, modes) & (side - 1)], from, sizeof *row);
    }
}

/* Makes `grids` those of the spectrum. */
static void transform_waves(struct ocean_state *state)
{
    for (int pair = 0; pair < state->pairs; pair++) {
        float(*grid)[2] = state->grids + (size_t)pair * (size_t)state->side * (size_t)state->side;
        place_pair(state, pair, grid);
        fft_run(state->fft, grid);
    }
}

bool ocean_waves_prepare(struct ocean_state *state, const struct water_setup *setup, double time,
                         const struct dpl_log *log)
{
    const struct ocean *ocean = setup->params;
    const double numbers[OCEAN_NUMBERS] = {
        ocean->spectrum,  ocean->wind_speed, ocean->wind_direction, ocean->fetch,     ocean->peak_enhancement,
        ocean->spreading, ocean->amplitude,  ocean->choppiness,     ocean->smoothing, ocean->resolution,
        ocean->cascades,  setup->size,       setup->depth,          setup->loop,      setup->seed,
    };
    bool same = state->fft && memcmp(numbers, state->numbers, sizeof numbers) == 0;
    double clock = setup->loop > 0 ? time / setup->loop : time;
    if (!same) {
        if (!resize(state, 32 << ocean->resolution, ocean->cascades, ocean->choppiness > 0, log))
            return false;
        memcpy(state->numbers, numbers, sizeof numbers);
        state->size = setup->size;
        state->choppiness = ocean->choppiness;
#pragma omp parallel for
        for (int row = 0; row < state->cascades * state->modes; row++)
            make_row(state, setup, row / state->modes, row % state->modes);
    }
    if (same && clock == state->clock)
        return true;
    state->clock = clock;
    move_waves(state);
    transform_waves(state);
    return true;
}
