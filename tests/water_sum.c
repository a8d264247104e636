/* The sum of two models against each of them alone. */
#include "support.h"
#include "water.h"

#include "scene/scene.h"

#include <math.h>

/* One scene's water: a sum, or one of its parts. */
static void start(struct water *water, const char *model, const char *text, double time)
{
    *water = (struct water){.scene = support_scene(text, NULL)};
    support_set(water->scene, "water.model", "%s", model);
    water_move(water, time);
}

/* Models of all kinds of grids, and what the sum's grid then is. */
static const struct {
    const char *first, *second, *more;
    int side;
    bool periodic;
} cases[] = {
    {"sines", "ocean", "[ocean]\nresolution = 32\ncascades = 1\n", 40, true},
    {"sines", "fbm", "", 40, false},
    {"fbm", "collard", "[collard]\ncells = 39\n", 40, false},
    {"collard", "sines", "[collard]\ncells = 70\nwave = preset-3\n", 71, false},
    {"sines", "fbm", "[wave.2]\ncycles = -1 4\nsteepness = 0.7\n", 40, false},
    {"ocean", "ripples", "[ocean]\nchoppiness = 0.5\n[ripples]\nside = 64\n", 64, false},
    {"sines", "collard", "[collard]\ncells = 70\n[wave.2]\ncycles = -1 4\nsteepness = 0.7\n", 71, false},
};

static void check_point(const struct water *sum, const struct water *first, const struct water *second, double x,
                        double z)
{
    const double time = 1.1;
    struct water_point both = sample_point(sum->model, &sum->setup, time, x, z);
    struct water_point a = sample_point(first->model, &first->setup, time, x, z);
    struct water_point b = sample_point(second->model, &second->setup, time, x + a.shift[0], z + a.shift[1]);
    assert_true(fabs(both.height - a.height - b.height) < 1e-12 && fabs(both.area - a.area) < 1e-12);
    for (int c = 0; c < 2; c++) {
        assert_true(fabs(both.slope[c] - a.slope[c] - b.slope[c]) < 1e-12);
        assert_true(fabs(both.shift[c] - a.shift[c]) < 1e-12);
    }
}

static void the_second_rides_on_the_first(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char text[512];
        struct water sum, first, second;
        snprintf(text, sizeof text,
                 "[caustics]\nmesh = 40\n[wave.1]\ncycles = 3 1\namplitude = 0.05\n[sum]\nfirst = %s\nsecond = %s\n%s",
                 cases[k].first, cases[k].second, cases[k].more);
        start(&sum, "sum", text, 1.1);
        start(&first, cases[k].first, text, 1.1);
        start(&second, cases[k].second, text, 1.1);
        assert_int_equal(sum.surface.columns, cases[k].side);
        assert_int_equal(sum.surface.periodic, cases[k].periodic);
        assert_int_equal(sum.surface.shifts != NULL, first.surface.shifts != NULL);
        for (int i = 0; i < 600; i++) /* more than one block of points, one by one */
            check_point(&sum, &first, &second, i * 0.00667 - 2, sin(i) * 2);
        water_finish(&sum);
        water_finish(&first);
        water_finish(&second);
    }
}

/* All points at once are those one by one. */
static void many_points_are_each_of_them(void **state)
{
    (void)state;
    enum { COUNT = 700 };
    static double x[COUNT], z[COUNT], out[6][COUNT];
    struct water sum;
    start(&sum, "sum",
          "[caustics]\nmesh = 9\n[wave.1]\ncycles = 2 1\nsteepness = 0.9\n[sum]\nfirst = sines\nsecond = fbm\n", 2);
    for (int i = 0; i < COUNT; i++) {
        x[i] = i * 0.003;
        z[i] = cos(i);
    }
    struct water_points points = {COUNT, x, z, out[0], out[1], out[2], out[3], out[4], out[5]};
    water_sample(sum.model, &sum.setup, 2, &points);
    for (int i = 0; i < COUNT; i++) {
        struct water_point point = sample_point(sum.model, &sum.setup, 2, x[i], z[i]);
        assert_true(fabs(point.height - out[0][i]) < 1e-12 && fabs(point.slope[1] - out[2][i]) < 1e-12);
    }
    water_finish(&sum);
}

static void a_choppy_second_and_the_first_again_are_refused(void **state)
{
    (void)state;
    struct support_log log;
    struct water_memory memory = {0};
    struct wave waves[WATER_WAVES_MAX];
    struct dpl_scene *scene = support_scene("[water]\nmodel = sum\n[caustics]\nmesh = 8\n[sum]\nfirst = fbm\n"
                                            "second = sines\n[wave.1]\ncycles = 1 1\nsteepness = 0.1\n",
                                            NULL);
    struct water_setup setup = scene_water_setup(scene, waves);
    setup.memory = &memory;
    assert_false(water_prepare(water_models[scene->medium.model], &setup, 0, support_log_start(&log)));
    EXPECT_ERROR(&log, DPL_REASON_UNSUPPORTED, "sum.second: sines", "accepted");
    support_set(scene, "sum.second", "fbm");
    setup = scene_water_setup(scene, waves);
    setup.memory = &memory;
    assert_false(water_prepare(water_models[scene->medium.model], &setup, 0, &log.log));
    EXPECT_ERROR(&log, DPL_REASON_UNSUPPORTED, "sum.second: as sum.first", "fbm", "accepted");
    water_memory_finish(&memory, NULL);
    dpl_scene_destroy(scene);
}

/* A sum adds up others, and their sections are at work. */
static void parts_are_the_other_models(void **state)
{
    (void)state;
    struct support_log log;
    struct dpl_scene *scene = support_scene("[water]\nmodel = sum\n[wave.1]\ncycles = 1 1\n[sum]\nfirst = collard\n"
                                            "second = sines\n",
                                            support_log_start(&log));
    assert_false(dpl_scene_set(scene, "sum.first", "sum"));
    EXPECT_ERROR(&log, DPL_REASON_CHOICE, "sum.first", "collard");
    for (int i = 0; dpl_scene_section(scene, i).name; i++) {
        struct dpl_section section = dpl_scene_section(scene, i);
        bool part = !strcmp(section.name, "collard") || !strcmp(section.name, "sum") || !strcmp(section.name, "wave.1");
        if (part || !strcmp(section.name, "fbm") || !strcmp(section.name, "heightfield"))
            assert_int_equal(section.active, part);
    }
    dpl_scene_destroy(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_second_rides_on_the_first),
        cmocka_unit_test(many_points_are_each_of_them),
        cmocka_unit_test(a_choppy_second_and_the_first_again_are_refused),
        cmocka_unit_test(parts_are_the_other_models),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
