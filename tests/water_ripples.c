/* The model `ripples`: its water against a plain second implementation, its energy, waves that travel and are thrown
 * back, drops, the ball, and that a time is the same however it is come to. */
#include "support.h"
#include "water.h"

#include "scene/scene.h"
#include "water/ripples_tank.h"

#include <math.h>

static struct tank make_tank(int side, double size, double damping)
{
    struct tank tank = {0};
    assert_true(tank_resize(&tank, side, NULL));
    tank.spacing = size / (side - 1);
    tank.damping = damping;
    tank.pool = (struct ball_pool){size / 2, 1, 4};
    return tank;
}

static void disturb(struct tank *tank, uint64_t random)
{
    for (int i = 0; i < tank->side * tank->side; i++) {
        tank->heights[i] = (float)(support_random_unit(&random) - 0.5);
        tank->speeds[i] = (float)(support_random_unit(&random) - 0.5);
    }
}

static void make_steps(struct tank *tank, int count)
{
    for (int i = 0; i < count; i++)
        tank_apply(tank, &(struct ripples_event){.kind = RIPPLES_STEP});
}

static void drop_into(struct tank *tank, double x, double z, double radius, double height)
{
    tank_apply(tank, &(struct ripples_event){.kind = RIPPLES_DROP, .drop = {x, z, radius, height}});
}

/* The height of a vertex or, beyond the walls, of the nearest one. */
static double height_at(const struct tank *tank, int i, int j)
{
    int last = tank->side - 1;
    i = i < 0 ? 0 : i > last ? last : i;
    j = j < 0 ? 0 : j > last ? last : j;
    return (double)tank->heights[j * tank->side + i];
}

static void a_step_is_the_formula(void **state)
{
    (void)state;
    enum { SIDE = 13 };
    struct tank tank = make_tank(SIDE, 2, 0.97), before = make_tank(SIDE, 2, 0.97);
    disturb(&tank, 3);
    disturb(&before, 3);
    make_steps(&tank, 1);
    for (int k = 0; k < SIDE * SIDE; k++) {
        int i = k % SIDE, j = k / SIDE;
        double mean = (height_at(&before, i - 1, j) + height_at(&before, i + 1, j) + height_at(&before, i, j - 1) +
                       height_at(&before, i, j + 1)) /
                      4;
        double h = (double)before.heights[k], v = 0.97 * ((double)before.speeds[k] + 2 * (mean - h));
        assert_true(fabs((double)tank.speeds[k] - v) < 1e-6);
        assert_true(fabs((double)tank.heights[k] - (h + v)) < 1e-6);
    }
    tank_finish(&tank);
    tank_finish(&before);
}

/* E of ripples_tank.c; <f, A g> is half the sum of (difference of f) (difference of g) over all pairs of neighbours. */
static double energy(const struct tank *tank)
{
    const double d = tank->damping;
    const int side = tank->side;
    double sum = 0;
    for (int k = 0; k < side * side; k++) {
        double v = (double)tank->speeds[k], h = (double)tank->heights[k] - v;
        sum += v * v + (1 - d) * h * v;
        for (int axis = 0; axis < 2; axis++) {
            if ((axis ? k / side : k % side) == side - 1)
                continue;
            int next = k + (axis ? side : 1);
            double other_v = (double)tank->speeds[next], other_h = (double)tank->heights[next] - other_v;
            sum += d * 0.5 * (h - other_h) * (h + v - other_h - other_v);
        }
    }
    return sum / 2;
}

static void energy_stays_or_is_damped(void **state)
{
    (void)state;
    static const double dampings[] = {1, 0.995, 0.9};
    for (int i = 0; i < 3; i++) {
        struct tank tank = make_tank(64, 2, (double)(float)dampings[i]);
        drop_into(&tank, 0.3, -0.2, 0.1, 0.01);
        drop_into(&tank, -0.9, 0.9, 0.2, -0.02);
        make_steps(&tank, 1);
        double start = energy(&tank);
        assert_true(start > 0);
        for (int steps = 1; steps <= 100; steps++) {
            make_steps(&tank, 1);
            assert_true(fabs(energy(&tank) / start / pow(tank.damping, steps) - 1) < 1e-4);
        }
        tank_finish(&tank);
    }
}

/* A smooth ridge across the tank becomes two, which go apart by √½ cells a step each. */
static void waves_travel_at_their_speed(void **state)
{
    (void)state;
    enum { SIDE = 301, STEPS = 120 };
    struct tank tank = make_tank(SIDE, 3, 1);
    for (int k = 0; k < SIDE * SIDE; k++)
        tank.heights[k] = (float)exp(-pow((k % SIDE - 150) / 12.0, 2));
    make_steps(&tank, STEPS);
    double sum = 0, moment = 0;
    for (int i = 150; i < SIDE; i++) {
        sum += height_at(&tank, i, 77);
        moment += height_at(&tank, i, 77) * (i - 150);
    }
    assert_true(fabs(moment / sum - STEPS * M_SQRT1_2) < 0.5);
    tank_finish(&tank);
}

/* A tank of twice the side in which each drop falls four times, mirrored by the middles, where there is no wall. */
static void walls_are_mirrors(void **state)
{
    (void)state;
    enum { SIDE = 40 };
    struct tank tank = make_tank(SIDE, SIDE - 1, 1), wide = make_tank(2 * SIDE, 2 * SIDE - 1, 1);
    double middle = (SIDE - 1) / 2.0, x = 29.3, z = 33.1, largest = 0; /* in cells from the first vertex */
    drop_into(&tank, x - middle, z - middle, 5, 1);
    for (int k = 0; k < 4; k++)
        drop_into(&wide, (k % 2 ? 1 : -1) * (SIDE - 0.5 - x), (k / 2 ? 1 : -1) * (SIDE - 0.5 - z), 5, 1);
    make_steps(&tank, 60);
    make_steps(&wide, 60);
    for (int k = 0; k < SIDE * SIDE; k++) {
        double height = height_at(&tank, k % SIDE, k / SIDE);
        assert_true(fabs(height - height_at(&wide, k % SIDE, k / SIDE)) < 1e-5);
        largest = fmax(largest, fabs(height));
    }
    assert_true(largest > 0.02);
    tank_finish(&tank);
    tank_finish(&wide);
}

static void a_drop_has_its_shape_and_volume(void **state)
{
    (void)state;
    enum { SIDE = 128 };
    struct tank tank = make_tank(SIDE, 2, 1);
    const double radius = 0.3, x = 0.21, z = -0.4;
    double volume = 0;
    drop_into(&tank, x, z, radius, 0.01);
    for (int k = 0; k < SIDE * SIDE; k++) {
        double from_x = k % SIDE * tank.spacing - 1 - x, from_z = k / SIDE * tank.spacing - 1 - z;
        double w = fmax(0, 1 - sqrt(from_x * from_x + from_z * from_z) / radius), height = (double)tank.heights[k];
        assert_true(fabs(height - 0.01 * (0.5 - 0.5 * cos(M_PI * w))) < 1e-8);
        volume += height * tank.spacing * tank.spacing;
    }
    double exact = 0.01 * M_PI * radius * radius * (0.5 - 2 / (M_PI * M_PI)); /* its integral over the disc */
    assert_true(fabs(volume / exact - 1) < 1e-3);
    drop_into(&tank, 1, 1, 0.1, 1); /* half outside */
    drop_into(&tank, 5, -7, 0.1, 1);
    assert_true(height_at(&tank, SIDE - 1, SIDE - 1) > 0.99);
    tank_finish(&tank);
}

/* Wallace's volume of a ball over a point, in his units. */
static double wallace_volume(const double ball[4], double x, double z)
{
    double from[3] = {x - ball[0], -ball[1], z - ball[2]};
    double t = sqrt(from[0] * from[0] + from[1] * from[1] + from[2] * from[2]) / ball[3];
    double dy = exp(-pow(t * 1.5, 6)), low = fmin(0, ball[1] - dy);
    double high = fmin(fmax(0, ball[1] + dy), low + 2 * dy);
    return (high - low) * 0.1;
}

static void the_ball_displaces_what_wallace_has_it_displace(void **state)
{
    (void)state;
    enum { SIDE = 65 };
    static const double places[][4] = {{-0.4, -0.75, 0.2, 0.25},
                                       {0.1, -0.1, 0.3, 0.25},
                                       {0.2, 0.15, 0.2, 0.4},
                                       {0.9, 0, -0.95, 0.5},
                                       {0.5, 0, 0.5, 0}};
    const double unit = 3; /* m: half a side of this pool */
    for (int p = 0; p < 4; p++) {
        struct tank tank = make_tank(SIDE, 2 * unit, 1);
        struct ripples_event event = {.kind = RIPPLES_MOVE};
        const double *from = places[p], *to = places[p + 1];
        double largest = 0;
        for (int c = 0; c < 3; c++) {
            event.from.center[c] = from[c] * unit;
            event.to.center[c] = to[c] * unit;
        }
        event.from.radius = from[3] * unit;
        event.to.radius = to[3] * unit;
        tank_apply(&tank, &event);
        for (int k = 0; k < SIDE * SIDE; k++) {
            double x = k % SIDE * tank.spacing / unit - 1, z = k / SIDE * tank.spacing / unit - 1;
            double wanted = wallace_volume(from, x, z) - (to[3] > 0 ? wallace_volume(to, x, z) : 0);
            assert_true(fabs((double)tank.heights[k] - wanted * unit) < 1e-6);
            largest = fmax(largest, fabs(wanted));
        }
        assert_true(largest > 1e-3);
        tank_finish(&tank);
    }
}

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
        cmocka_unit_test(a_step_is_the_formula),
        cmocka_unit_test(energy_stays_or_is_damped),
        cmocka_unit_test(waves_travel_at_their_speed),
        cmocka_unit_test(walls_are_mirrors),
        cmocka_unit_test(a_drop_has_its_shape_and_volume),
        cmocka_unit_test(the_ball_displaces_what_wallace_has_it_displace),
        cmocka_unit_test(a_time_is_the_same_at_any_frame_rate),
        cmocka_unit_test(time_that_goes_back_starts_again),
        cmocka_unit_test(frames_between_steps_are_smooth_and_all_comes_to_rest),
        cmocka_unit_test(the_speed_of_waves_can_be_chosen),
        cmocka_unit_test(the_ball_swims),
        cmocka_unit_test(water_can_be_disturbed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
