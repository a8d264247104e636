/* The model `ripples` over time: a time is the same however it is come to, its waves' speed, the ball that swims, and
 * what a hand does. */
#include "support.h"
#include "water.h"

#include "scene/scene.h"

#include <math.h>

/* A scene and its water. */
struct pool {
    struct dpl_scene *scene;
    struct wave waves[WATER_WAVES_MAX];
    struct water_setup setup;
    struct water_memory memory;
    struct surface surface;
};

static const struct water_model *model_of(const struct pool *pool)
{
    return water_models[pool->scene->medium.model];
}

static void ready(struct pool *pool, double time)
{
    pool->setup = scene_water_setup(pool->scene, pool->waves);
    pool->setup.memory = &pool->memory;
    assert_true(water_prepare(model_of(pool), &pool->setup, time, NULL));
}

static void go(struct pool *pool, double time)
{
    ready(pool, time);
    assert_true(water_evaluate(model_of(pool), &pool->setup, time, &pool->surface, NULL));
}

static void start(struct pool *pool, const char *text)
{
    *pool = (struct pool){.scene = support_scene(text, NULL)};
}

static void finish(struct pool *pool)
{
    surface_finish(&pool->surface);
    water_memory_finish(&pool->memory, NULL);
    dpl_scene_destroy(pool->scene);
}

static void assert_same(const struct pool *a, const struct pool *b)
{
    size_t count = (size_t)a->surface.columns * (size_t)a->surface.rows;
    double here[3], there[3];
    assert_int_equal(a->surface.columns, b->surface.columns);
    assert_memory_equal(a->surface.texels, b->surface.texels, count * 3 * sizeof(float));
    water_sphere_center(model_of(a), &a->setup, here);
    water_sphere_center(model_of(b), &b->setup, there);
    assert_memory_equal(here, there, sizeof here);
}

#define POOL "[scene]\nsize = 2\n[water]\nmodel = ripples\n[ripples]\nside = 32\n"
#define LIVELY POOL "damping = 0.9\nrain = 25\n[sphere]\nradius = 0.25\nposition = -0.4 -0.75 0.2\ngravity = on\n"

/* With that damping a wave lives 263 steps, so that its water changes twice in 6 s. */
static void a_time_is_the_same_at_any_frame_rate(void **state)
{
    (void)state;
    struct pool films[3], still;
    for (int i = 0; i < 3; i++)
        start(films + i, LIVELY);
    for (int second = 1; second <= 6; second++) {
        static const int rates[] = {24, 60, 7};
        for (int i = 0; i < 3; i++)
            for (int frame = 1; frame <= rates[i]; frame++)
                go(films + i, second - 1 + (double)frame / rates[i]);
        start(&still, LIVELY);
        go(&still, second);
        for (int i = 0; i < 3; i++)
            assert_same(films + i, &still);
        finish(&still);
    }
    for (int i = 0; i < 3; i++)
        finish(films + i);
}

static void time_that_goes_back_starts_again(void **state)
{
    (void)state;
    struct pool pool, fresh;
    start(&pool, LIVELY);
    start(&fresh, LIVELY);
    go(&pool, 3);
    go(&pool, 0.5);
    go(&fresh, 0.5);
    assert_same(&pool, &fresh);
    support_set(pool.scene, "ripples.drop_height", "0.02");
    support_set(fresh.scene, "ripples.drop_height", "0.02");
    go(&pool, 0.7);
    go(&fresh, 0.2);
    go(&fresh, 0.7);
    assert_same(&pool, &fresh);
    support_set(pool.scene, "scene.seed", "7");
    go(&pool, 0.7);
    size_t count = (size_t)pool.surface.columns * (size_t)pool.surface.rows;
    assert_memory_not_equal(pool.surface.texels, fresh.surface.texels, count * 3 * sizeof(float));
    finish(&pool);
    finish(&fresh);
}

/* Between two steps, heights are their mean by time; after many lives there is nothing left but the level. */
static void frames_between_steps_are_smooth_and_all_comes_to_rest(void **state)
{
    (void)state;
    struct pool before, between, after;
    start(&before, POOL);
    start(&between, POOL);
    start(&after, POOL);
    go(&before, 30.0 / 120);
    go(&between, 30.25 / 120);
    go(&after, 31.0 / 120);
    for (int k = 0; k < 32 * 32; k++) {
        double wanted = 0.75 * (double)before.surface.texels[3 * k] + 0.25 * (double)after.surface.texels[3 * k];
        assert_true(fabs((double)between.surface.texels[3 * k] - wanted) < 1e-8);
    }
    go(&after, 1e9);
    for (int k = 0; k < 32 * 32; k++) {
        assert_true(fabs((double)after.surface.texels[3 * k]) < 1e-4);
        assert_true(after.surface.texels[3 * k + 1] == 0 && after.surface.texels[3 * k + 2] == 0);
    }
    finish(&before);
    finish(&between);
    finish(&after);
}

/* Waves of twice the speed are at one second where those of the demo are at two: √(g depth) and a given speed alike. */
static void the_speed_of_waves_can_be_chosen(void **state)
{
    (void)state;
    const double speed = 2.0 / 31 * M_SQRT1_2 * 240;
    struct pool demo, given, deep;
    start(&demo, POOL);
    start(&given, POOL "speed = given\n");
    start(&deep, POOL "speed = depth\n");
    support_set(given.scene, "ripples.wave_speed", "%.17g", speed);
    support_set(deep.scene, "scene.depth", "%.17g", speed * speed / 9.81);
    go(&demo, 2);
    go(&given, 1);
    go(&deep, 1);
    for (int k = 0; k < 32 * 32; k++) {
        assert_true(fabs((double)demo.surface.texels[3 * k] - (double)given.surface.texels[3 * k]) < 1e-9);
        assert_true(fabs((double)demo.surface.texels[3 * k] - (double)deep.surface.texels[3 * k]) < 1e-9);
    }
    finish(&demo);
    finish(&given);
    finish(&deep);
}

/* Weight and buoyancy are equal where 1 / 1.1 of the ball is under water (by its height, as Wallace has it). */
static void the_ball_swims(void **state)
{
    (void)state;
    static const double heights[] = {-0.6, 0.9};
    for (int i = 0; i < 2; i++) {
        struct pool pool;
        double center[3], lowest = 1;
        start(&pool, POOL "drops = 0\n[scene]\ndepth = 0.9\n[sphere]\nradius = 0.25\ngravity = on\n");
        support_set(pool.scene, "sphere.position", "-0.4 %g 0.2", heights[i]);
        for (int frame = 0; frame <= 60 * 60; frame++) {
            ready(&pool, frame / 60.0);
            water_sphere_center(model_of(&pool), &pool.setup, center);
            lowest = fmin(lowest, center[1]);
        }
        assert_true(center[0] == -0.4 && center[2] == 0.2);
        assert_true(fabs(center[1] - 0.25 * (1 - 2 / 1.1)) < 0.03);
        assert_true(lowest >= 0.25 - 0.9);
        finish(&pool);
    }
}

static double ball_height(struct pool *pool, double time)
{
    double center[3];
    ready(pool, time);
    water_sphere_center(model_of(pool), &pool->setup, center);
    return center[1];
}

/* Switched off in its fall, gravity leaves the ball where it is; switched on again, it takes it from rest. */
static void a_ball_without_gravity_rests_where_it_is(void **state)
{
    (void)state;
    const double tick = 1 / 60.0;
    struct pool pool;
    start(&pool, POOL "drops = 0\n[sphere]\nradius = 0.1\nposition = 0 0.9 0\ngravity = on\n");
    double first = ball_height(&pool, 0), second = ball_height(&pool, 0.2), third = ball_height(&pool, 0.2 + tick);
    assert_true(second < first);
    support_set(pool.scene, "sphere.gravity", "off");
    assert_true(ball_height(&pool, 1) == third);
    support_set(pool.scene, "sphere.gravity", "on");
    double fallen = third - ball_height(&pool, 1 + tick);
    assert_true(fallen > 0 && fallen < (second - third) / 4);
    finish(&pool);
}

/* What others do: a drop, the ball put elsewhere and back. */
static void water_can_be_disturbed(void **state)
{
    (void)state;
    const struct water_drop drop = {0.5, -0.25, 0.2, 0.03};
    struct pool pool;
    double out[3], center[3];
    start(&pool, POOL "drops = 0\n[sphere]\nradius = 0.25\nposition = 0 -0.05 0\n");
    go(&pool, 1);
    pool.setup.drops = &drop;
    pool.setup.drop_count = 1;
    assert_true(water_prepare(model_of(&pool), &pool.setup, 1, NULL));
    sample_water(model_of(&pool), &pool.setup, 1, 0.5, -0.25, out);
    assert_true(fabs(out[0] - 0.03) < 0.002);
    support_set(pool.scene, "sphere.position", "-0.5 -0.05 -0.5");
    go(&pool, 1);
    sample_water(model_of(&pool), &pool.setup, 1, -0.5, -0.5, out);
    assert_true(out[0] < -0.1);
    sample_water(model_of(&pool), &pool.setup, 1, 0, 0, out);
    assert_true(out[0] > 0.1);
    water_sphere_center(model_of(&pool), &pool.setup, center);
    assert_true(center[0] == -0.5 && center[1] == -0.05);
    support_set(pool.scene, "sphere.position", "0 -0.05 0");
    go(&pool, 1);
    sample_water(model_of(&pool), &pool.setup, 1, 0, 0, out);
    assert_true(fabs(out[0]) < 1e-6);
    go(&pool, 1.2); /* the drop has gone */
    sample_water(model_of(&pool), &pool.setup, 1.2, 0.5, -0.25, out);
    assert_true(fabs(out[0]) < 0.02);
    pool.setup.drops = &drop;
    pool.setup.drop_count = 1;
    assert_true(water_prepare(model_of(&pool), &pool.setup, 0.7, NULL)); /* again from 0: it falls at 0.7 s */
    sample_water(model_of(&pool), &pool.setup, 0.7, 0.5, -0.25, out);
    assert_true(fabs(out[0] - 0.03) < 0.002);
    finish(&pool);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_time_is_the_same_at_any_frame_rate),
        cmocka_unit_test(time_that_goes_back_starts_again),
        cmocka_unit_test(frames_between_steps_are_smooth_and_all_comes_to_rest),
        cmocka_unit_test(the_speed_of_waves_can_be_chosen),
        cmocka_unit_test(the_ball_swims),
        cmocka_unit_test(a_ball_without_gravity_rests_where_it_is),
        cmocka_unit_test(water_can_be_disturbed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
