/* The floor's relief, what sways above it, and the patterns that things are laid with. */
#include "world.h"

#include "scene/scene.h"

static void a_flat_floor_has_no_relief(void **state)
{
    struct fixture *fixture = *state;
    double floor[3] = {1, 1, 1};
    build(fixture);
    assert_int_equal(fixture->world.relief_side, 0);
    world_floor(&fixture->world, 4, 1, 2, floor);
    for (int c = 0; c < 3; c++)
        expect_near(floor[c], 0, 0);
}

static double floor_at(const struct world *world, double x, double z)
{
    double floor[3];
    world_floor(world, 4, x, z, floor);
    return floor[0];
}

/* At a vertex its own height; slopes are those of the heights; beyond the tile it goes on as it began. */
static void the_floor_is_interpolated(void **state)
{
    struct fixture *fixture = *state;
    const struct world *world = &fixture->world;
    uint64_t random = 3;
    support_set(fixture->scene, "floor.relief_height", "0.05");
    build(fixture);
    const int side = world->relief_side;
    assert_int_equal(side, 256);
    for (int i = 0; i < 200; i++) {
        int column = (int)(support_random(&random) % (unsigned)side),
            row = (int)(support_random(&random) % (unsigned)side);
        double x = 4.0 * column / side - 2, z = 4.0 * row / side - 2, floor[3];
        expect_near(floor_at(world, x, z), world->relief[row * side + column], 1e-7);
        x += support_random_unit(&random);
        z += support_random_unit(&random);
        const double step = 1e-5;
        world_floor(world, 4, x, z, floor);
        expect_near(floor[1], (floor_at(world, x + step, z) - floor_at(world, x - step, z)) / (2 * step), 1e-3);
        expect_near(floor[2], (floor_at(world, x, z + step) - floor_at(world, x, z - step)) / (2 * step), 1e-3);
        expect_near(floor_at(world, x + 4, z - 8), floor[0], 1e-9);
    }
}

/* How often heights along a line cross their mean, and how long the sides are that rise and fall. */
static int count_crests(const struct world *world, double turn, double length, double *rising)
{
    const double step = 0.002;
    int crests = 0, rises = 0, steps = (int)(length / step);
    for (int line = 0; line < 40; line++) {
        double x = 0.1 * line, z = -0.07 * line, before = floor_at(world, x, z), direction = 0;
        for (int i = 0; i < steps; i++) {
            x += step * cos(turn);
            z += step * sin(turn);
            double height = floor_at(world, x, z);
            crests += direction > 0 && height < before;
            direction = height - before;
            rises += direction > 0;
            before = height;
        }
    }
    *rising = (double)rises / (40.0 * steps);
    return crests;
}

/* As high and as far apart as the scene says, across the way that it says; one side steeper than the other. */
static void ripples_are_those_of_the_scene(void **state)
{
    static const double lengths[] = {0.15, 0.4};
    struct fixture *fixture = *state;
    support_set(fixture->scene, "floor.relief_height", "0.03");
    for (int i = 0; i < 2; i++) {
        double turn = i ? 0.6 : 2.1, low = INFINITY, high = -INFINITY, mean = 0, rising;
        support_set(fixture->scene, "floor.relief_length", "%.17g", lengths[i]);
        support_set(fixture->scene, "floor.relief_turn", "%.17g", turn * 180 / M_PI);
        build(fixture);
        const struct world *world = &fixture->world;
        const int count = world->relief_side * world->relief_side;
        for (int v = 0; v < count; v++) {
            low = fmin(low, (double)world->relief[v]);
            high = fmax(high, (double)world->relief[v]);
            mean += (double)world->relief[v] / count;
        }
        assert_true(fabs(mean) < 1e-6);
        assert_true(high - low > 0.03 && high - low < 0.09);
        double crests = count_crests(world, turn, 4, &rising) / 40.0, wanted = 4 / lengths[i];
        if (crests < 0.85 * wanted || crests > 1.15 * wanted)
            fail_msg("%g crests, not %g", crests, wanted);
        assert_true(rising > 0.52);
    }
}

static void objects_stand_on_the_relief(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "floor.relief_height", "0.3");
    support_set(fixture->scene, "object.a.position", "0.7 0.2 -1.1");
    build(fixture);
    double height = floor_at(&fixture->world, 0.7, -1.1);
    assert_true(fabs(height) > 1e-3);
    expect_near(fixture->world.low[1], height + 0.2 - 1, 1e-6);
    support_set(fixture->scene, "object.a.on_floor", "no");
    build(fixture);
    expect_near(fixture->world.low[1], 0.2, 1e-6);
}

/* A picture that grows brighter to the right and downwards, from 0. */
static void write_picture(struct fixture *fixture, const char *name, float most)
{
    char path[512];
    struct dpl_image *image = dpl_image_create(8, 16, NULL);
    for (int i = 0; i < 8 * 16 * 3; i++)
        image->pixels[i] = most * (float)(i / 24 + i / 3 % 8) / 22.0f;
    snprintf(path, sizeof path, "%s/%s", fixture->folder, name);
    assert_true(dpl_image_save(image, path, NULL, NULL));
    dpl_image_destroy(image);
    support_set(fixture->scene, "floor.relief_map", "%s", path);
}

static void a_picture_gives_heights(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "floor.relief_height", "0.25");
    write_picture(fixture, "heights.pfm", 1);
    build(fixture);
    for (int row = 0; row < 16; row++) /* the middle of each pixel; row 0 is the smallest z */
        for (int column = 0; column < 8; column++)
            expect_near(floor_at(&fixture->world, (column + 0.5) / 2 - 2, (row + 0.5) / 4 - 2),
                        0.25 * ((row + column) / 11.0 - 1), 0.003);
}

static void wrong_pictures_are_refused(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "floor.relief_height", "0.25");
    write_picture(fixture, "bright.pfm", 2);
    assert_false(world_build(&fixture->world, fixture->scene, &fixture->log.log));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_FORMAT, "floor.relief_map", "bright.pfm", "0 to 1");
    write_picture(fixture, "none.pfm", NAN);
    assert_false(world_build(&fixture->world, fixture->scene, &fixture->log.log));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_FORMAT, "floor.relief_map", "none.pfm", "nan", "0 to 1");
    support_set(fixture->scene, "floor.relief_map", "sand.jpeg");
    assert_false(world_build(&fixture->world, fixture->scene, &fixture->log.log));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_FORMAT, "sand.jpeg", ".png");
    support_set(fixture->scene, "floor.relief_height", "0"); /* not asked for */
    build(fixture);
    assert_int_equal(fixture->world.relief_side, 0);
}

/* Never beyond its reach, mostly along the current, always on the move; of strength 0 not at all. */
static void plants_sway(void **state)
{
    struct fixture *fixture = *state;
    uint64_t random = 11;
    double along = 0, across = 0, farthest = 0;
    support_set(fixture->scene, "current.azimuth", "90");
    support_set(fixture->scene, "current.strength", "2");
    for (int i = 0; i < 4000; i++) {
        struct world_vertex vertex = {.sway = 0.3f};
        float moved[3], later[3];
        for (int c = 0; c < 3; c++)
            vertex.position[c] = (float)(8 * support_random_unit(&random) - 4);
        double time = 100 * support_random_unit(&random);
        world_sway(fixture->scene, &vertex, time, moved);
        world_sway(fixture->scene, &vertex, time + 0.01, later);
        expect_near(moved[1], 0, 0);
        farthest = fmax(farthest, hypot(moved[0], moved[2]));
        along += (double)(moved[2] * moved[2]);
        across += (double)(moved[0] * moved[0]);
        assert_true(hypot(later[0] - moved[0], later[2] - moved[2]) < 0.03);
    }
    assert_true(farthest <= 0.6 && farthest > 0.4);
    assert_true(along > 3 * across && across > 0);
    support_set(fixture->scene, "current.strength", "0");
    float moved[3];
    world_sway(fixture->scene, &(struct world_vertex){.sway = 1}, 1.3, moved);
    assert_true(moved[0] == 0 && moved[1] == 0 && moved[2] == 0);
}

static void sway_loops_with_the_scene(void **state)
{
    struct fixture *fixture = *state;
    const struct world_vertex vertex = {.position = {1, -0.5f, 2}, .sway = 0.2f};
    for (int loops = 0; loops < 2; loops++) {
        double most = 0;
        support_set(fixture->scene, "scene.loop", "%d", 7 * loops);
        for (double time = 0; time < 7; time += 0.3) {
            float first[3], second[3];
            world_sway(fixture->scene, &vertex, time, first);
            world_sway(fixture->scene, &vertex, time + 7, second);
            most = fmax(most, hypot(first[0] - second[0], first[2] - second[2]));
        }
        assert_true(loops ? most < 1e-5 : most > 0.05);
    }
}

static bool is_joint(const struct world_part *part, double along, double across)
{
    const float color[3] = {0.9f, 0.8f, 0.7f}, place[2] = {(float)along, (float)across};
    float seen[3];
    world_color(part, color, place, seen);
    bool joint = seen[0] == 0.25f && seen[1] == 0.5f && seen[2] == 0.125f;
    assert_true(joint || fabs((double)(seen[0] / seen[1]) - 0.9 / 0.8) < 1e-5 || seen[0] == 1);
    return joint;
}

/* Joints lie where tiles of that size meet; blocks are twice as long, every other row is half a block along. */
static void joints_lie_between_tiles(void **state)
{
    (void)state;
    struct world_part part = {.pattern = WORLD_TILES, .pattern_size = 0.2, .joint = {0.25, 0.5, 0.125}};
    for (int i = -6; i < 6; i++) {
        for (int j = -6; j < 6; j++) {
            assert_true(is_joint(&part, 0.2 * i + 0.001, 0.2 * j + 0.1));
            assert_true(is_joint(&part, 0.2 * i + 0.1, 0.2 * j - 0.001));
            assert_false(is_joint(&part, 0.2 * i + 0.1, 0.2 * j + 0.1));
            assert_false(is_joint(&part, 0.2 * i + 0.01, 0.2 * j + 0.01));
        }
    }
    part.pattern = WORLD_BLOCKS;
    for (int i = -6; i < 6; i++) {
        for (int j = -6; j < 6; j++) {
            bool shifted = j & 1;
            assert_int_equal(is_joint(&part, 0.4 * i, 0.2 * j + 0.1), !shifted);
            assert_int_equal(is_joint(&part, 0.4 * i + 0.2, 0.2 * j + 0.1), shifted);
        }
    }
    part.pattern = WORLD_PLAIN;
    assert_false(is_joint(&part, 0, 0));
}

/* Share of joints, and shades that differ from board to board but not in one. */
static void planks_are_long_and_differ(void **state)
{
    const struct world_part part = {.pattern = WORLD_PLANKS, .pattern_size = 0.1, .joint = {0.25, 0.5, 0.125}};
    const float color[3] = {0.5f, 0.4f, 0.3f};
    float least = 1, most = 0;
    int joints = 0;
    (void)state;
    for (int row = 0; row < 100; row++) {
        int changes = 0;
        float before = 0;
        for (int i = 0; i < 1400; i++) { /* ten boards */
            float seen[3];
            world_color(&part, color, (const float[2]){(float)i * 0.01f + 0.003f, (float)row * 0.1f + 0.05f}, seen);
            bool joint = seen[0] == 0.25f;
            joints += joint;
            changes += !joint && seen[0] != before;
            before = joint ? before : seen[0];
            least = joint ? least : fminf(least, seen[0]);
            most = fmaxf(most, seen[0]);
        }
        assert_true(changes == 10 || changes == 11);
    }
    assert_true(least < 0.44f && most > 0.56f && least >= 0.42f && most <= 0.58f);
    assert_true(joints > 50 && joints < 400);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_flat_floor_has_no_relief, setup, teardown),
        cmocka_unit_test_setup_teardown(the_floor_is_interpolated, setup, teardown),
        cmocka_unit_test_setup_teardown(ripples_are_those_of_the_scene, setup, teardown),
        cmocka_unit_test_setup_teardown(objects_stand_on_the_relief, setup, teardown),
        cmocka_unit_test_setup_teardown(a_picture_gives_heights, setup, teardown),
        cmocka_unit_test_setup_teardown(wrong_pictures_are_refused, setup, teardown),
        cmocka_unit_test_setup_teardown(plants_sway, setup, teardown),
        cmocka_unit_test_setup_teardown(sway_loops_with_the_scene, setup, teardown),
        cmocka_unit_test(joints_lie_between_tiles),
        cmocka_unit_test(planks_are_long_and_differ),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
