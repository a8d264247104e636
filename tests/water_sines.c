/* The sum of sine waves against its formula, written out a second time, and against the theory of water waves. */
#include "support.h"
#include "water.h"

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
    const struct wave waves[] = {{{3, 1}, 0.01, 40, 1.7}, {{-2, 5}, 0.03, -90, 0.6}, {{0, 1}, 0.2, 180, 13}};
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

/* A wave with positive cycles runs towards +x: its crest, at x = 0 at first, is there half a period later. */
static void crests_run_the_way_of_the_cycles(void **state)
{
    struct fixture *fixture = *state;
    fixture->waves[0] = (struct wave){{1, 0}, 0.1, 0, 2};
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
        fixture->waves[0] = (struct wave){{3, 2}, 0, 50, 0};
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
        fixture->waves[0] = (struct wave){{3 * cycles, 4 * cycles}, 0.1, 0, 0};
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
    fixture->waves[0] = (struct wave){{3, 4}, 0.1, 0, 7.25};
    fixture->setup.wave_count = 1;
    expect_period(fixture, 7.25, 1e-9);
}

static void waves_without_a_length_stand_still(void **state)
{
    struct fixture *fixture = *state;
    fixture->waves[0] = (struct wave){{0, 0}, 0.1, 60, 0};
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
        fixture->waves[0] = (struct wave){{3, 4}, 0.1, 0, cases[i][1]};
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
                          w % 2 ? support_random_unit(&random) * 9 : 0};
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
