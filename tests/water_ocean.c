/* The model `ocean`: the energy of its waves, how they run, that they repeat, and what choppiness does. */
#include "support.h"
#include "water.h"

#include "scene/scene.h"
#include "water/ocean.h"

#include <complex.h>
#include <math.h>

#define GRAVITY 9.81

static void start(struct water *sea, const char *text)
{
    *sea = (struct water){.scene = support_scene(text, NULL)};
    support_set(sea->scene, "water.model", "ocean");
}

static int vertex_count(const struct water *sea)
{
    return sea->surface.columns * sea->surface.rows;
}

static double mean_square_height(const struct water *sea)
{
    double sum = 0;
    for (int i = 0; i < vertex_count(sea); i++)
        sum += pow((double)sea->surface.texels[3 * i], 2);
    return sum / vertex_count(sea);
}

/* Deep sea, 16 waves of the peak's length along the tile; the shortest waves, 2 m long, are of three times its
 * frequency. */
static const char sea_text[] =
    "[scene]\nsize = 128\ndepth = 200\n[caustics]\nmesh = 128\n[ocean]\nresolution = 64\ncascades = 2\n"
    "smoothing = 0\nwind_speed = 10\nfetch = 5000\nwind_direction = 35\n";
static const double longest = 128, shortest = 2, wind = 10, fetch = 5000;

static double frequency_of(double k, double depth)
{
    return sqrt(GRAVITY * k * tanh(k * depth));
}

/* JONSWAP as a function of frequency, by its five numbers. */
static double jonswap(double frequency)
{
    double peak = 22 * pow(GRAVITY * GRAVITY / (wind * fetch), 1.0 / 3);
    double alpha = 0.076 * pow(wind * wind / (fetch * GRAVITY), 0.22), sigma = frequency > peak ? 0.09 : 0.07;
    double r = exp(-pow(frequency - peak, 2) / (2 * sigma * sigma * peak * peak));
    return alpha * GRAVITY * GRAVITY * pow(frequency, -5) * exp(-1.25 * pow(frequency / peak, -4)) * pow(3.3, r);
}

/* The mean square of the height: the spectrum's integral over the waves that fit the tile, by steps. In shallow water
 * the density by wave number of a wave is that of the same wave in the deep (Bouws et al. 1985). */
static double energy_of(int spectrum, double depth)
{
    double energy = 0, from = 2 * M_PI / longest, to = 2 * M_PI / shortest, length = wind * wind / GRAVITY;
    if (spectrum == 0)
        return 0.0081 / 4 * length * length * (exp(-1 / pow(to * length, 2)) - exp(-1 / pow(from * length, 2)));
    const int steps = 20000;
    double step = (to - from) / steps;
    for (int i = 0; i < steps; i++) {
        double k = from + (i + 0.5) * step, frequency = frequency_of(k, depth);
        double slope = (frequency_of(k + step / 2, depth) - frequency_of(k - step / 2, depth)) / step;
        if (spectrum == 1) {
            energy += jonswap(frequency) * slope * step;
        } else {
            double deep_k = frequency * frequency / GRAVITY, deep_slope = GRAVITY / (2 * frequency);
            energy += jonswap(frequency) * deep_slope * pow(k / deep_k, -3) * step;
        }
    }
    return energy;
}

/* Significant wave heights, 4 × RMS. Amplitudes are random: over 12 seas their mean square is within a few per cent. */
static void heights_have_the_energy_of_their_spectrum(void **state)
{
    static const char *const names[] = {"phillips", "jonswap", "tma", "tma"};
    static const double depths[] = {200, 200, 200, 1.5};
    (void)state;
    for (int k = 0; k < 4; k++) {
        struct water sea;
        double mean = 0;
        start(&sea, sea_text);
        support_set(sea.scene, "ocean.spectrum", "%s", names[k]);
        support_set(sea.scene, "scene.depth", "%g", depths[k]);
        for (int seed = 1; seed <= 12; seed++) {
            support_set(sea.scene, "scene.seed", "%d", seed);
            water_move(&sea, seed * 11);
            mean += mean_square_height(&sea) / 12;
        }
        double height = 4 * sqrt(mean), wanted = 4 * sqrt(energy_of(k < 2 ? k : 2, depths[k]));
        if (fabs(height / wanted - 1) > 0.03)
            fail_msg("%s, %g m deep: significant height %.4f m, not %.4f m", names[k], depths[k], height, wanted);
        if (k == 1) /* the fetch law that the spectrum was fitted with, itself a mean over scattered seas */
            assert_true(fabs(height / (0.0016 * wind * sqrt(fetch / GRAVITY)) - 1) < 0.15);
        water_finish(&sea);
    }
}

/* The wave of so many cycles in one of the numbers that each vertex has: its complex amplitude. */
static double complex wave_of(const float *numbers, int step, int side, int x, int z)
{
    double complex sum = 0;
    for (int j = 0; j < side; j++)
        for (int i = 0; i < side; i++)
            sum += (double)numbers[step * (j * side + i)] * cexp(-2 * I * M_PI * (x * i + z * j) / side);
    return sum / (side * side);
}

/* In heights (0) or slopes (1, 2). */
static double complex wave_in(const struct water *sea, int part, int x, int z)
{
    return wave_of(sea->surface.texels + part, 3, sea->surface.columns, x, z);
}

static void check_course(struct water *sea, int direction, int x, int z)
{
    const double step = 0.05, size = sea->setup.size;
    double k = 2 * M_PI * hypot(x, z) / size, frequency = frequency_of(k, sea->setup.depth);
    water_move(sea, 7);
    double complex height = wave_in(sea, 0, x, z), slope_x = wave_in(sea, 1, x, z), slope_z = wave_in(sea, 2, x, z);
    water_move(sea, 7 + step);
    double turned = carg(wave_in(sea, 0, x, z) / height);
    if (fabs(turned + frequency * step) > 1e-5 * frequency * step)
        fail_msg("wind to %d degrees: turned by %.5f, not %.5f", direction, turned, -frequency * step);
    /* eight vertices a wave: the spline's slope is 0.25 % too small */
    double most = 3e-3 * k * cabs(height);
    assert_true(cabs(slope_x - 2 * I * M_PI * x / size * height) < most);
    assert_true(cabs(slope_z - 2 * I * M_PI * z / size * height) < most);
}

/* With hardly any spreading nothing runs against the wind, and a wave is alone in its place of the transform. */
static void waves_run_with_the_wind_as_fast_as_gravity_has_them(void **state)
{
    static const double depths[] = {0.1, 50};
    (void)state;
    for (int k = 0; k < 8; k++) {
        struct water sea;
        int direction = k / 2 * 90, x = (int)lround(8 * cos(direction * M_PI / 180));
        start(&sea, "[scene]\nsize = 4\n[ocean]\nresolution = 64\ncascades = 1\nspreading = 0.1\nfetch = 100\n"
                    "spectrum = jonswap\n");
        support_set(sea.scene, "ocean.wind_direction", "%d", direction);
        support_set(sea.scene, "scene.depth", "%g", depths[k % 2]);
        water_move(&sea, 0);
        check_course(&sea, direction, x, (int)lround(8 * sin(direction * M_PI / 180)));
        water_finish(&sea);
    }
}

/* The share of a direction at the peak's frequency, below and above it: sech² of the angle times these numbers (Donelan
 * et al. 1985; the last one Banner 1990). */
static void directions_spread_as_measured(void **state)
{
    static const double ratios[] = {0.8, 1, 2}, betas[] = {1.953, 2.28, 0.9604};
    struct ocean ocean = {.spectrum = OCEAN_JONSWAP,
                          .wind_speed = wind,
                          .wind_direction = 50,
                          .fetch = fetch,
                          .peak_enhancement = 3.3,
                          .spreading = 1};
    (void)state;
    for (int i = 0; i < 3; i++) {
        double frequency = ratios[i] * 22 * cbrt(GRAVITY * GRAVITY / (wind * fetch));
        double k = frequency * frequency / GRAVITY, turn = 50 * M_PI / 180;
        double along = ocean_density(&ocean, 1000, k * cos(turn), k * sin(turn));
        for (double angle = -3; angle <= 3; angle += 0.5) {
            double density = ocean_density(&ocean, 1000, k * cos(turn + angle), k * sin(turn + angle));
            assert_true(fabs(density / along * pow(cosh(betas[i] * angle), 2) - 1) < 5e-3);
        }
    }
}

static float *copy_of(const struct water *sea)
{
    size_t size = (size_t)vertex_count(sea) * 3 * sizeof(float);
    float *copy = malloc(size);
    memcpy(copy, sea->surface.texels, size);
    return copy;
}

static bool same_bytes(const struct water *sea, const float *texels)
{
    return memcmp(texels, sea->surface.texels, (size_t)vertex_count(sea) * 3 * sizeof *texels) == 0;
}

static void a_loop_ends_where_it_began(void **state)
{
    struct water sea;
    (void)state;
    start(&sea, "[scene]\nloop = 7.3\n[ocean]\nresolution = 32\nchoppiness = 0.5\n");
    water_move(&sea, 0);
    float *before = copy_of(&sea);
    water_move(&sea, 3.65);
    assert_false(same_bytes(&sea, before));
    for (int loops = 1; loops <= 1000; loops *= 10) {
        water_move(&sea, 7.3 * loops);
        assert_true(same_bytes(&sea, before));
    }
    free(before);
    water_finish(&sea);
}

static void every_number_changes_the_sea_and_back(void **state)
{
    static const char *const changes[][3] = {
        {"scene.seed", "2", "1"},       {"scene.depth", "0.2", "1"},
        {"scene.loop", "3", "0"},       {"ocean.spectrum", "jonswap", "tma"},
        {"ocean.wind_speed", "6", "5"}, {"ocean.wind_direction", "5", "0"},
        {"ocean.fetch", "300", "200"},  {"ocean.peak_enhancement", "1", "3.3"},
        {"ocean.spreading", "2", "1"},  {"ocean.smoothing", "0", "0.05"},
        {"ocean.amplitude", "2", "1"},  {"ocean.choppiness", "0.5", "0"},
        {"ocean.cascades", "1", "2"},   {"ocean.resolution", "64", "32"},
        {"scene.size", "5", "4"},
    };
    struct water sea;
    (void)state;
    start(&sea, "[caustics]\nmesh = 40\n[ocean]\nresolution = 32\nspectrum = tma\n");
    water_move(&sea, 1);
    float *before = copy_of(&sea);
    for (size_t i = 0; i < sizeof changes / sizeof *changes; i++) {
        support_set(sea.scene, changes[i][0], "%s", changes[i][1]);
        water_move(&sea, 1);
        if (same_bytes(&sea, before))
            fail_msg("%s changes nothing", changes[i][0]);
        support_set(sea.scene, changes[i][0], "%s", changes[i][2]);
        water_move(&sea, 1);
        assert_true(same_bytes(&sea, before));
    }
    free(before);
    water_finish(&sea);
}

/* A program's own lock without a name is one for the whole process: it may be held around any call. */
static void no_lock_is_taken(void **state)
{
    struct water sea;
    (void)state;
    start(&sea, "[caustics]\nmesh = 40\n[ocean]\nresolution = 32\n");
#pragma omp critical
    water_move(&sea, 1);
    assert_true(mean_square_height(&sea) > 0);
    water_finish(&sea);
}

/* Where short waves have been taken away. */
static void a_finer_grid_has_the_same_waves(void **state)
{
    struct water sea;
    double most = 0, apart = 0;
    (void)state;
    start(&sea, "[caustics]\nmesh = 50\n[ocean]\nfetch = 1000\nsmoothing = 0.2\nresolution = 64\ncascades = 1\n");
    water_move(&sea, 3);
    float *coarse = copy_of(&sea);
    support_set(sea.scene, "ocean.resolution", "256");
    water_move(&sea, 3);
    for (int i = 0; i < vertex_count(&sea); i++) {
        most = fmax(most, fabs((double)coarse[3 * i]));
        apart = fmax(apart, fabs((double)coarse[3 * i] - (double)sea.surface.texels[3 * i]));
    }
    assert_true(apart > 0 && apart < 1e-4 * most);
    free(coarse);
    water_finish(&sea);
}

/* A surface that moves sideways covers what it covered before, and crests are where it draws together. */
static void crests_draw_together(void **state)
{
    enum { POINTS = 40000 };
    static double x[POINTS], z[POINTS], out[6][POINTS];
    struct water_points points = {POINTS, x, z, out[0], out[1], out[2], out[3], out[4], out[5]};
    struct water sea;
    double area = 0, together = 0, change = 0, height = 0;
    (void)state;
    start(&sea, "[ocean]\nresolution = 64\ncascades = 2\nchoppiness = 1\n");
    water_move(&sea, 2);
    for (int i = 0; i < POINTS; i++) {
        x[i] = (i % 200 / 200.0 - 0.5) * sea.setup.size;
        z[i] = (i / 200 / 200.0 - 0.5) * sea.setup.size;
    }
    water_sample(sea.model, &sea.setup, 2, &points);
    for (int i = 0; i < POINTS; i++) {
        area += points.area[i] / POINTS;
        together += points.height[i] * (points.area[i] - 1) / POINTS;
        change += pow(points.area[i] - 1, 2) / POINTS;
        height += pow(points.height[i], 2) / POINTS;
    }
    assert_true(fabs(area - 1) < 1e-4);
    assert_true(together < -0.5 * sqrt(height * change));
    water_finish(&sea);
}

/* A wave's points go round in circles, as in deep water: a quarter of a turn ahead, along the wave. */
static void points_of_a_wave_go_round(void **state)
{
    static const int waves[][2] = {{5, 3}, {4, -6}, {9, 0}, {0, 7}};
    struct water sea;
    (void)state;
    start(&sea, "[caustics]\nmesh = 64\n[ocean]\nresolution = 64\ncascades = 1\nchoppiness = 0.7\nspreading = 5\n");
    water_move(&sea, 2);
    for (int w = 0; w < 4; w++) {
        int x = waves[w][0], z = waves[w][1];
        double complex height = wave_in(&sea, 0, x, z), ahead = 0.7 * I * height / hypot(x, z);
        double complex shift_x = wave_of(sea.surface.shifts, 2, 64, x, z);
        double complex shift_z = wave_of(sea.surface.shifts + 1, 2, 64, x, z);
        assert_true(cabs(shift_x - x * ahead) < 1e-5 * cabs(height));
        assert_true(cabs(shift_z - z * ahead) < 1e-5 * cabs(height));
    }
    water_finish(&sea);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(heights_have_the_energy_of_their_spectrum),
        cmocka_unit_test(directions_spread_as_measured),
        cmocka_unit_test(waves_run_with_the_wind_as_fast_as_gravity_has_them),
        cmocka_unit_test(a_loop_ends_where_it_began),
        cmocka_unit_test(every_number_changes_the_sea_and_back),
        cmocka_unit_test(no_lock_is_taken),
        cmocka_unit_test(a_finer_grid_has_the_same_waves),
        cmocka_unit_test(crests_draw_together),
        cmocka_unit_test(points_of_a_wave_go_round),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
