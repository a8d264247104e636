/* A sum of sine waves, each with whole cycles across the tile: periodic in space, and in time where the scene loops.
 *
 *     h = Σ A cos(2π (cx x + cz z) / L - 2π t / period + phase)
 *
 * Without a period of its own a wave has that of the linear dispersion relation of water of finite depth,
 * ω² = g k tanh(k depth) (Airy 1845). Slopes are exact derivatives. */
#include "water/water.h"

#include <math.h>

#define GRAVITY 9.81     /* m/s² */
#define PERIOD_MIN 0.001 /* s; keeps time / period finite */

const struct dpl_param water_wave_params[] = {
    PARAM_INTS(struct wave, cycles, 2, -256, 256, "", "whole waves across the tile, along x and along z", 1, 0),
    PARAM_FLOAT(struct wave, amplitude, 0.01, 0, 100, "m", "height of a crest above the rest surface"),
    PARAM_FLOAT(struct wave, phase, 0, -360, 360, "degrees", "phase at the middle of the tile at time 0"),
    PARAM_FLOAT(struct wave, period, 0, 0, 1e4, "s", "time of one oscillation; 0 = from the dispersion relation"),
    PARAM_END,
};

static double period_of(const struct wave *wave, const struct water_setup *setup)
{
    double k = 2 * M_PI * hypot(wave->cycles[0], wave->cycles[1]) / setup->size;
    double period = wave->period;
    if (period == 0 && k > 0)
        period = 2 * M_PI / sqrt(GRAVITY * k * tanh(k * setup->depth));
    if (period > 0 && setup->loop > 0)
        period = setup->loop / fmax(1, round(setup->loop / period));
    return period > 0 ? fmax(period, PERIOD_MIN) : 0;
}

/* Phase at the middle of the tile, radians, in one turn so that it stays exact when time is long. */
static double phase_at(const struct wave *wave, const struct water_setup *setup, double time)
{
    double period = period_of(wave, setup);
    double turns = wave->phase / 360 - (period > 0 ? time / period : 0);
    return 2 * M_PI * (turns - floor(turns));
}

static int grid(const struct water_setup *setup)
{
    return setup->mesh;
}

/* Adds one wave to one row, whose phase at the tile's middle column is `row_phase`. */
static void add_wave_to_row(const struct wave *wave, const struct water_setup *setup, double row_phase, int count,
                            float *row)
{
    float slope_x = (float)(-2 * M_PI * wave->cycles[0] / setup->size * wave->amplitude);
    float slope_z = (float)(-2 * M_PI * wave->cycles[1] / setup->size * wave->amplitude);
    double step = 2 * M_PI * wave->cycles[0] / count;
    for (int i = 0; i < count; i++) {
        double angle = row_phase + step * (i - count / 2.0);
        float cosine = (float)cos(angle), sine = (float)sin(angle);
        row[3 * i] += (float)wave->amplitude * cosine;
        row[3 * i + 1] += slope_x * sine;
        row[3 * i + 2] += slope_z * sine;
    }
}

static void evaluate(const struct water_setup *setup, double time, struct surface *surface)
{
#pragma omp parallel for
    for (int j = 0; j < surface->rows; j++) {
        float *row = surface->texels + (size_t)j * (size_t)surface->columns * 3;
        for (int i = 0; i < surface->columns * 3; i++)
            row[i] = 0;
        for (int w = 0; w < setup->wave_count; w++) {
            const struct wave *wave = setup->waves + w;
            double row_phase =
                phase_at(wave, setup, time) + 2 * M_PI * wave->cycles[1] * (j - surface->rows / 2.0) / surface->rows;
            add_wave_to_row(wave, setup, row_phase, surface->columns, row);
        }
    }
}

static void sample_point(const struct water_setup *setup, double time, double x, double z, double out[3])
{
    out[0] = out[1] = out[2] = 0;
    for (int w = 0; w < setup->wave_count; w++) {
        const struct wave *wave = setup->waves + w;
        double kx = 2 * M_PI * wave->cycles[0] / setup->size, kz = 2 * M_PI * wave->cycles[1] / setup->size;
        double angle = kx * x + kz * z + phase_at(wave, setup, time);
        out[0] += wave->amplitude * cos(angle);
        out[1] -= wave->amplitude * kx * sin(angle);
        out[2] -= wave->amplitude * kz * sin(angle);
    }
}

static void sample(const struct water_setup *setup, double time, struct water_points *points)
{
    for (int i = 0; i < points->count; i++) {
        double out[3];
        sample_point(setup, time, points->x[i], points->z[i], out);
        points->height[i] = out[0];
        points->slope_x[i] = out[1];
        points->slope_z[i] = out[2];
    }
}

/* A wave is a vec4: wave numbers along x and z (1/m), amplitude (m), phase now. The first vec4 holds their number. */
static int constants(const struct water_setup *setup, double time, float constants[WATER_CONSTANTS_MAX][4])
{
    constants[0][0] = (float)setup->wave_count;
    for (int w = 0; w < setup->wave_count; w++) {
        const struct wave *wave = setup->waves + w;
        constants[w + 1][0] = (float)(2 * M_PI * wave->cycles[0] / setup->size);
        constants[w + 1][1] = (float)(2 * M_PI * wave->cycles[1] / setup->size);
        constants[w + 1][2] = (float)wave->amplitude;
        constants[w + 1][3] = (float)phase_at(wave, setup, time);
    }
    return setup->wave_count + 1;
}

const struct water_model water_sines = {
    .name = "sines",
    .summary = "a list of sine waves, [wave.1] to [wave.64]; exact slopes, periodic, loops",
    .source = "Airy 1845",
    .periodic = true,
    .grid = grid,
    .evaluate = evaluate,
    .sample = sample,
    .shader = "water/sines.glsl",
    .constants = constants,
};
