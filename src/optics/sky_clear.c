/* The clear sky. */
#include "optics/sky_parts.h"

#include <math.h>

/* Of light scattered by molecules (Rayleigh 1871). */
static double air_phase(double cosine)
{
    return 3 / (16 * M_PI) * (1 + cosine * cosine);
}

/* Of light scattered by haze (Cornette & Shanks 1992, eq. 8; g as Bruneton & Neyret 2008). */
static double haze_phase(double cosine)
{
    const double g = 0.76, square = g * g, base = 1 + square - 2 * g * cosine;
    return 3 / (8 * M_PI) * (1 - square) * (1 + cosine * cosine) / ((2 + square) * base * sqrt(base));
}

void sky_clear_sun(const struct sky_kept *kept, const double to_sun[3], double sun[3])
{
    double rgb[SPECTRUM_COUNT][3];
    float column[ATMOSPHERE_PARTS];
    spectrum_sunlight(rgb);
    atmosphere_column(&kept->columns, ATMOSPHERE_GROUND, to_sun[1], column);
    sun[0] = sun[1] = sun[2] = 0;
    for (int w = 0; w < SPECTRUM_COUNT; w++) {
        double depth = 0;
        for (int p = 0; p < ATMOSPHERE_PARTS; p++)
            depth += (double)kept->atmosphere.extinction[p][w] * (double)column[p];
        for (int c = 0; c < 3; c++)
            sun[c] += rgb[w][c] * exp(-depth);
    }
    spectrum_fit(sun);
}

/* A row's light goes smoothly from the sun's side to the other and is the same on its left and on its right: few
 * cosines of the angle hold it. Three kinds: what is to be multiplied by each of the two phase functions, and the
 * rest. */
enum { TURNS = 12, KINDS = 3 };
struct row {
    double wave[TURNS][KINDS][3];
};

static void add_to_row(struct row *row, const struct scattering_sum *sum, const double rgb[SPECTRUM_COUNT][3],
                       double turn)
{
    double light[KINDS][3] = {{0}};
    const float *const spectra[KINDS] = {sum->once[ATMOSPHERE_AIR], sum->once[ATMOSPHERE_HAZE], sum->more};
    for (int k = 0; k < KINDS; k++)
        for (int w = 0; w < SPECTRUM_COUNT; w++)
            for (int c = 0; c < 3; c++)
                light[k][c] += (double)spectra[k][w] * rgb[w][c];
    for (int n = 0; n < TURNS; n++)
        for (int k = 0; k < KINDS; k++)
            for (int c = 0; c < 3; c++)
                row->wave[n][k][c] += light[k][c] * cos(n * turn) * (n ? 2.0 : 1.0) / TURNS;
}

/* The light towards a turn from the sun's side. */
static void sum_row(const struct row *row, double turn, double phase[KINDS], double rgb[3])
{
    rgb[0] = rgb[1] = rgb[2] = 0;
    for (int n = 0; n < TURNS; n++) {
        double wave = cos(n * turn);
        for (int k = 0; k < KINDS; k++)
            for (int c = 0; c < 3; c++)
                rgb[c] += row->wave[n][k][c] * wave * phase[k];
    }
    spectrum_fit(rgb);
}

static void draw_row(const struct sky_kept *kept, const double rgb[SPECTRUM_COUNT][3], const double to_sun[3], int j,
                     float *texels)
{
    struct row row = {0};
    double height[3], level = sqrt(to_sun[0] * to_sun[0] + to_sun[2] * to_sun[2]);
    double azimuth = level > 0 ? atan2(to_sun[2], to_sun[0]) : 0;
    const double sun[3] = {level, to_sun[1], 0};
    sky_direction(0, j + 0.5, height);
    for (int n = 0; n < TURNS; n++) {
        struct scattering_sum sum;
        double turn = M_PI * (n + 0.5) / TURNS;
        const double direction[3] = {height[0] * cos(turn), height[1], height[0] * sin(turn)};
        scattering_gather(&kept->scattering, &kept->atmosphere, &kept->columns, direction, sun, &sum);
        add_to_row(&row, &sum, rgb, turn);
    }
    for (int i = 0; i < SKY_COLUMNS; i++) {
        double turn = 2 * M_PI * (i + 0.5) / SKY_COLUMNS - azimuth, light[3];
        double cosine = height[0] * cos(turn) * sun[0] + height[1] * sun[1];
        double phase[KINDS] = {air_phase(cosine), haze_phase(cosine), 1};
        sum_row(&row, turn, phase, light);
        for (int c = 0; c < 3; c++)
            texels[(j * SKY_COLUMNS + i) * 3 + c] = (float)light[c];
    }
}

void sky_clear_draw(const struct sky_kept *kept, const double to_sun[3], float *texels)
{
    double rgb[SPECTRUM_COUNT][3];
    spectrum_sunlight(rgb);
#pragma omp parallel for schedule(dynamic)
    for (int j = 0; j < SKY_HORIZON; j++)
        draw_row(kept, (const double(*)[3])rgb, to_sun, j, texels);
}
