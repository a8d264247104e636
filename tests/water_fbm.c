/* The blog's Fourier series against its formula, written out a second time, and its slopes against finite differences
 * of that and against the derivative that the blog prints. */
#include "support.h"
#include "water.h"

#include "scene/scene.h"

#include <math.h>

#define AMPLITUDE 0.02
#define SCALE 0.7
#define TERMS 5
#define RATE 2.5

struct fixture {
    struct dpl_scene *scene;
    const struct water_model *model;
    struct water_setup setup;
};

static void set_up(struct fixture *fixture, double loop)
{
    fixture->scene = support_scene("[water]\nmodel = fbm\n[caustics]\nmesh = 20\n", NULL);
    support_set(fixture->scene, "scene.loop", "%.17g", loop);
    support_set(fixture->scene, "fbm.amplitude", "%.17g", AMPLITUDE);
    support_set(fixture->scene, "fbm.scale", "%.17g", SCALE);
    support_set(fixture->scene, "fbm.terms", "%d", TERMS);
    support_set(fixture->scene, "fbm.rate", "%.17g", RATE);
    fixture->model = water_models[fixture->scene->medium.model];
    fixture->setup = scene_water_setup(fixture->scene, NULL);
}

static double formula(double x, double y, double phase)
{
    double sum = 0;
    for (int j = 1; j <= TERMS; j++)
        sum -= sqrt(x * x + y * y) * AMPLITUDE * cos(phase + pow(2, j) * SCALE * x * y) / pow(2, j);
    return sum;
}

/* The blog's ∂f/∂x, sign and all; its ∂f/∂y is the same with x and y exchanged. */
static double printed(double x, double y, double phase)
{
    double sum = 0, r = sqrt(x * x + y * y);
    for (int j = 1; j <= TERMS; j++) {
        double angle = phase + pow(2, j) * SCALE * x * y;
        sum -= r * AMPLITUDE * sin(angle) * SCALE * y - AMPLITUDE * cos(angle) * x / (pow(2, j) * r);
    }
    return sum;
}

static void check(const struct fixture *fixture, double time, double phase)
{
    const double step = 1e-6;
    for (int i = 0; i < 400; i++) {
        double x = (i % 20 - 9.7) * 0.2, y = (i / 20 - 9.3) * 0.2, out[3];
        sample_water(fixture->model, &fixture->setup, time, x, y, out);
        assert_true(fabs(out[0] - formula(x, y, phase)) < 1e-12);
        double difference_x = (formula(x + step, y, phase) - formula(x - step, y, phase)) / (2 * step);
        double difference_y = (formula(x, y + step, phase) - formula(x, y - step, phase)) / (2 * step);
        assert_true(fabs(out[1] - difference_x) < 1e-7 && fabs(out[2] - difference_y) < 1e-7);
        assert_true(fabs(out[1] + printed(x, y, phase)) < 1e-12 && fabs(out[2] + printed(y, x, phase)) < 1e-12);
    }
}

static void heights_and_slopes_are_those_of_the_formula(void **state)
{
    (void)state;
    struct fixture fixture;
    set_up(&fixture, 0);
    for (double time = 0; time < 30; time += 7.3)
        check(&fixture, time, RATE * time);
    dpl_scene_destroy(fixture.scene);
}

/* 2.5 radians/s are 1.99 turns in 5 s: two; 0.2 in half a second: one, the least that moves. */
static void a_loop_takes_whole_turns(void **state)
{
    (void)state;
    static const double turns[][2] = {{5, 2}, {0.5, 1}};
    for (int i = 0; i < 2; i++) {
        struct fixture fixture;
        set_up(&fixture, turns[i][0]);
        for (int part = 0; part < 4; part++)
            check(&fixture, turns[i][0] * (part / 4.0 + part), 2 * M_PI * turns[i][1] * part / 4);
        dpl_scene_destroy(fixture.scene);
    }
}

static void the_middle_is_level_by_definition(void **state)
{
    (void)state;
    struct fixture fixture;
    double out[3];
    set_up(&fixture, 0);
    sample_water(fixture.model, &fixture.setup, 1.7, 0, 0, out);
    assert_true(out[0] == 0 && out[1] == 0 && out[2] == 0);
    dpl_scene_destroy(fixture.scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(heights_and_slopes_are_those_of_the_formula),
        cmocka_unit_test(a_loop_takes_whole_turns),
        cmocka_unit_test(the_middle_is_level_by_definition),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
