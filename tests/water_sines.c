/* The sum of sine waves against its formula, written out a second time, and against the theory of water waves. */
#include "support.h"
#include "water.h"

#include "base/sine.h"
#include "scene/scene.h"

#include <math.h>

#define GRAVITY 9.81

struct fixture {
    const struct water_model *model;
    struct wave waves[WATER_WAVES_MAX];
    struct water_setup setup;
    struct surface surface;
};

static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    for (int i = 0; water_models[i]; i++)
        if (!strcmp(water_models[i]->name, "sines"))
            fixture->model = water_models[i];
    fixture->setup = (struct water_setup){.size = 4, .depth = 1, .mesh = 20, .waves = fixture->waves};
    *state = fixture;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *fixture = *state;
    surface_finish(&fixture->surface);
    free(fixture);
    return 0;
}

static double height(const struct fixture *fixture, double time, double x, double z)
{
    double out[3];
    sample_water(fixture->model, &fixture->setup, time, x, z, out);
    return out[0];
}

static void evaluate(struct fixture *fixture, double time)
{
    assert_true(water_evaluate(fixture->model, &fixture->setup, time, &fixture->surface, NULL));
}

/* h = Σ A cos(2π (cx x + cz z) / L - 2π t / period + phase), x and z from -L/2. */
static void heights_are_those_of_the_formula(void **state)
{
    struct fixture *fixture = *state;
    const struct wave waves[] = {{{3, 1}, 0.01, 40, 1.7, 0}, {{-2, 5}, 0.03, -90, 0.6, 0}, {{0, 1}, 0.2, 180, 13, 0}};
    memcpy(fixture->waves, waves, sizeof waves);
    fixture->setup.wave_count = 3;
    for (double time = 0; time < 20; time += 3.7) {
        evaluate(fixture, time);
        for (int j = 0; j < 20; j++) {
            for (int i = 0; i < 20; i++) {
                double x = -2 + i * 0.2, z = -2 + j * 0.2, wanted = 0;
                for (int w = 0; w < 3; w++)
                    wanted +=
                        waves[w].amplitude * cos(2 * M_PI * (waves[w].cycles[0] * x + waves[w].cycles[1] * z) / 4 -
                                                 2 * M_PI * time / waves[w].period + waves[w].phase * M_PI / 180);
                assert_true(fabs(height(fixture, time, x, z) - wanted) < 1e-12);
                assert_true(fabs((double)fixture->surface.texels[(j * 20 + i) * 3] - wanted) < 1e-7);
            }
        }
    }
}

/* Waves of every kind, short and long, as many as there may be. */
static double fill_waves(struct fixture *fixture, int count)
{
    uint64_t random = 7;
    double sum = 0;
    for (int w = 0; w < count; w++) {
        int across = (int)(support_random(&random) % 513) - 256, along = (int)(support_random(&random) % 513) - 256;
        fixture->waves[w] = (struct wave){{w ? across : 0, w ? along : 0},
                                          support_random_unit(&random) * 0.1,
                                          support_random_unit(&random) * 720 - 360,
                                          0.1 + support_random_unit(&random) * 9,
                                          0};
        sum += fixture->waves[w].amplitude;
    }
    fixture->setup.wave_count = count;
    return sum;
}

/* Height and slopes by the formula. */
static void formula(const struct fixture *fixture, double time, double x, double z, double out[3])
{
    out[0] = out[1] = out[2] = 0;
    for (int w = 0; w < fixture->setup.wave_count; w++) {
        const struct wave *wave = fixture->waves + w;
        double size = fixture->setup.size, kx = 2 * M_PI * wave->cycles[0] / size,
               kz = 2 * M_PI * wave->cycles[1] / size;
        double angle = kx * x + kz * z - 2 * M_PI * time / wave->period + wave->phase * M_PI / 180;
        out[0] += wave->amplitude * cos(angle);
        out[1] -= wave->amplitude * kx * sin(angle);
        out[2] -= wave->amplitude * kz * sin(angle);
    }
}

/* Any number of points, so also those that fill no vector, no block and more than one. */
static void points_are_those_of_the_formula(void **state)
{
    enum { MOST = 1100 };
    static const int counts[] = {0, 1, 2, 3, 5, 8, 31, 511, 512, 513, MOST};
    static double x[MOST], z[MOST], out[3][MOST + 1], shift[2][MOST], area[MOST];
    struct fixture *fixture = *state;
    uint64_t random = 9;
    for (int i = 0; i < MOST; i++) {
        x[i] = (support_random_unit(&random) - 0.5) * 12;
        z[i] = (support_random_unit(&random) - 0.5) * 12;
    }
    for (size_t k = 0; k < sizeof counts / sizeof *counts; k++) {
        int count = counts[k];
        double sum = fill_waves(fixture, k % 2 ? WATER_WAVES_MAX : (int)k);
        struct water_points points = {count, x, z, out[0], out[1], out[2], shift[0], shift[1], area};
        out[0][count] = out[1][count] = out[2][count] = 123;
        water_sample(fixture->model, &fixture->setup, 3.3, &points);
        assert_true(out[0][count] == 123 && out[1][count] == 123 && out[2][count] == 123);
        for (int i = 0; i < count; i++) {
            double wanted[3];
            formula(fixture, 3.3, x[i], z[i], wanted);
            for (int c = 0; c < 3; c++) /* angles up to 10^4 in double precision */
                assert_true(fabs(out[c][i] - wanted[c]) <= 1e-11 * sum * (c ? 2 * M_PI * 256 / 4 : 1));
            assert_true(shift[0][i] == 0 && shift[1][i] == 0 && area[i] == 1);
        }
    }
}

/* Grids of any number of columns, within a millionth of the sum of amplitudes. */
static void grids_of_any_side_are_those_of_the_formula(void **state)
{
    static const int sides[] = {2, 3, 7, 15, 16, 17, 31, 100};
    struct fixture *fixture = *state;
    double sum = fill_waves(fixture, WATER_WAVES_MAX);
    for (size_t k = 0; k < sizeof sides / sizeof *sides; k++) {
        int side = fixture->setup.mesh = sides[k];
        evaluate(fixture, 3.3);
        for (int i = 0; i < side * side; i++) {
            double wanted[3];
            formula(fixture, 3.3, 4.0 * (i % side) / side - 2, 4.0 * (i / side) / side - 2, wanted);
            for (int c = 0; c < 3; c++)
                assert_true(fabs((double)fixture->surface.texels[3 * i + c] - wanted[c]) <=
                            1e-6 * sum * (c ? 2 * M_PI * 256 / 4 : 1));
        }
    }
}

/* At quarter turns, next to them, and far out. */
static void sine_cosine_is_that_of_the_library(void **state)
{
    (void)state;
    for (int i = -4000; i <= 4000; i++) {
        for (int place = 0; place < 4; place++) {
            double turns = i * 0.0009765625 * (place < 2 ? 1 : 65536) + (place % 2 ? 1e-9 : 0), sine, cosine;
            sine_cosine(turns, &sine, &cosine);
            assert_true(fabs(sine - sin(2 * M_PI * (turns - rint(turns)))) < 1e-13);
            assert_true(fabs(cosine - cos(2 * M_PI * (turns - rint(turns)))) < 1e-13);
        }
    }
}

/* A wave with positive cycles runs towards +x: its crest, at x = 0 at first, is there half a period later. */
static void crests_run_the_way_of_the_cycles(void **state)
{
    struct fixture *fixture = *state;
    fixture->waves[0] = (struct wave){{1, 0}, 0.1, 0, 2, 0};
    fixture->setup.wave_count = 1;
    assert_true(fabs(height(fixture, 0, 0, 1.23) - 0.1) < 1e-12);
    assert_true(fabs(height(fixture, 0.5, 1, 1.23) - 0.1) < 1e-12);
    assert_true(fabs(height(fixture, 0.5, -1, 1.23) + 0.1) < 1e-12);
    fixture->waves[0].cycles[0] = 0;
    fixture->waves[0].cycles[1] = 1;
    assert_true(fabs(height(fixture, 0.5, 1.23, 1) - 0.1) < 1e-12);
}

static void no_waves_and_no_amplitude_are_flat(void **state)
{
    struct fixture *fixture = *state;
    for (int count = 0; count < 2; count++) {
        fixture->waves[0] = (struct wave){{3, 2}, 0, 50, 0, 0};
        fixture->setup.wave_count = count;
        evaluate(fixture, 1.5);
        for (int i = 0; i < 20 * 20 * 3; i++)
            assert_true(fixture->surface.texels[i] == 0);
    }
}

/* The height at the middle over time is A cos(2π t / period). */
static void expect_period(struct fixture *fixture, double period, double tolerance)
{
    for (int i = 0; i < 40; i++) {
        double time = period * i / 16;
        assert_true(fabs(height(fixture, time, 0, 0) - 0.1 * cos(2 * M_PI * i / 16)) <= 0.1 * tolerance);
    }
}

static void periods_follow_the_dispersion_relation(void **state)
{
    struct fixture *fixture = *state;
    fixture->setup.wave_count = 1;
    for (int cycles = 1; cycles <= 64; cycles *= 2) {
        fixture->waves[0] = (struct wave){{3 * cycles, 4 * cycles}, 0.1, 0, 0, 0};
        double length = 4.0 / (5 * cycles), k = 2 * M_PI / length;
        fixture->setup.depth = 1000; /* deep: length = g period² / 2π */
        expect_period(fixture, sqrt(2 * M_PI * length / GRAVITY), 1e-9);
        fixture->setup.depth = length / 1000; /* shallow: speed √(g depth), less by (k depth)²/6 = 7e-6 */
        expect_period(fixture, length / sqrt(GRAVITY * fixture->setup.depth), 2.5 * 2 * M_PI * 7e-6);
        fixture->setup.depth = length / 10;
        expect_period(fixture, 2 * M_PI / sqrt(GRAVITY * k * tanh(k * fixture->setup.depth)), 1e-9);
    }
}

static void a_period_of_its_own_goes_first(void **state)
{
    struct fixture *fixture = *state;
    fixture->waves[0] = (struct wave){{3, 4}, 0.1, 0, 7.25, 0};
    fixture->setup.wave_count = 1;
    expect_period(fixture, 7.25, 1e-9);
}

static void waves_without_a_length_stand_still(void **state)
{
    struct fixture *fixture = *state;
    fixture->waves[0] = (struct wave){{0, 0}, 0.1, 60, 0, 0};
    fixture->setup.wave_count = 1;
    assert_true(fabs(height(fixture, 0, 1, 1) - 0.05) < 1e-12);
    assert_true(fabs(height(fixture, 9, -1, 0) - 0.05) < 1e-12);
    fixture->waves[0].cycles[0] = 1;
    fixture->setup.depth = 0; /* as slow as can be */
    assert_true(fabs(height(fixture, 9, 0, 0) - 0.05) < 1e-12);
}

/* With a loop the period becomes loop / max(1, round(loop / period)). */
static void a_loop_bends_periods_to_whole_parts(void **state)
{
    static const double cases[][3] = {/* loop, period, becomes */
                                      {10, 3, 10.0 / 3},
                                      {10, 4.1, 5},
                                      {10, 100, 10},
                                      {10, 20.1, 10},
                                      {2, 0.3, 2.0 / 7}};
    struct fixture *fixture = *state;
    fixture->setup.wave_count = 1;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        fixture->setup.loop = cases[i][0];
        fixture->waves[0] = (struct wave){{3, 4}, 0.1, 0, cases[i][1], 0};
        expect_period(fixture, cases[i][2], 1e-9);
    }
}

static void a_loop_has_no_seam(void **state)
{
    struct fixture *fixture = *state;
    uint64_t random = 3;
    for (int w = 0; w < WATER_WAVES_MAX; w++)
        fixture->waves[w] =
            (struct wave){{(int)(support_random(&random) % 41) - 20, (int)(support_random(&random) % 41)},
                          support_random_unit(&random) * 0.01,
                          support_random_unit(&random) * 360,
                          w % 2 ? support_random_unit(&random) * 9 : 0,
                          0};
    fixture->setup.wave_count = WATER_WAVES_MAX;
    fixture->setup.loop = 6.7;
    struct surface first = {0};
    for (double time = 0; time < 6.7; time += 0.9) {
        assert_true(water_evaluate(fixture->model, &fixture->setup, time, &first, NULL));
        for (int loops = 1; loops < 1001; loops += 333) {
            evaluate(fixture, time + 6.7 * loops);
            /* heights are sums of 64 amplitudes up to 0.01 in single precision, slopes up to 60 times that */
            for (int i = 0; i < 20 * 20 * 3; i++)
                assert_true(fabsf(first.texels[i] - fixture->surface.texels[i]) < (i % 3 ? 6e-6f : 1e-7f));
        }
    }
    surface_finish(&first);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(heights_are_those_of_the_formula, setup, teardown),
        cmocka_unit_test_setup_teardown(points_are_those_of_the_formula, setup, teardown),
        cmocka_unit_test_setup_teardown(grids_of_any_side_are_those_of_the_formula, setup, teardown),
        cmocka_unit_test(sine_cosine_is_that_of_the_library),
        cmocka_unit_test_setup_teardown(crests_run_the_way_of_the_cycles, setup, teardown),
        cmocka_unit_test_setup_teardown(no_waves_and_no_amplitude_are_flat, setup, teardown),
        cmocka_unit_test_setup_teardown(periods_follow_the_dispersion_relation, setup, teardown),
        cmocka_unit_test_setup_teardown(a_period_of_its_own_goes_first, setup, teardown),
        cmocka_unit_test_setup_teardown(waves_without_a_length_stand_still, setup, teardown),
        cmocka_unit_test_setup_teardown(a_loop_bends_periods_to_whole_parts, setup, teardown),
        cmocka_unit_test_setup_teardown(a_loop_has_no_seam, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
