/* The objects of a scene as triangles: what every shape keeps to, where copies stand, and when a world is made anew. */
#include "world.h"

#include "scene/shape.h"
#include "scene/world_builder.h"

static void subtract(const float a[3], const float b[3], double out[3])
{
    for (int c = 0; c < 3; c++)
        out[c] = (double)a[c] - (double)b[c];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* A triangle's normal, as long as twice its area, outwards where it is counter-clockwise. */
static void normal_of(const struct world *world, int triangle, double out[3])
{
    const unsigned *corners = world->indices + 3 * triangle;
    const float *a = world->vertices[corners[0]].position;
    double u[3], v[3];
    subtract(world->vertices[corners[1]].position, a, u);
    subtract(world->vertices[corners[2]].position, a, v);
    for (int c = 0; c < 3; c++)
        out[c] = u[(c + 1) % 3] * v[(c + 2) % 3] - u[(c + 2) % 3] * v[(c + 1) % 3];
}

static void check_vertices(const struct world *world)
{
    for (int v = 0; v < world->vertex_count; v++) {
        const struct world_vertex *vertex = world->vertices + v;
        const double normal[3] = {vertex->normal[0], vertex->normal[1], vertex->normal[2]};
        expect_near(dot(normal, normal), 1, 1e-5);
        for (int c = 0; c < 3; c++) {
            double reach = vertex->sway;
            assert_true(vertex->position[c] - reach >= world->low[c] - 1e-6);
            assert_true(vertex->position[c] + reach <= world->high[c] + 1e-6);
            assert_true(vertex->color[c] > 0 && vertex->color[c] <= 1);
        }
        assert_true(isfinite(vertex->place[0]) && isfinite(vertex->place[1]) && vertex->sway >= 0);
    }
}

/* Triangles have an area, lie the way that their vertices' normals say, and belong to one part each. */
static void check_triangles(const struct world *world)
{
    int next = 0;
    for (int p = 0; p < world->part_count; p++) {
        assert_int_equal(world->parts[p].first, next);
        assert_true(world->parts[p].count > 0);
        next += world->parts[p].count;
    }
    assert_int_equal(next, world->index_count);
    for (int t = 0; t < world->index_count / 3; t++) {
        double across[3], sum = 0;
        for (int k = 0; k < 3; k++)
            assert_true(world->indices[3 * t + k] < (unsigned)world->vertex_count);
        normal_of(world, t, across);
        assert_true(dot(across, across) > 1e-18);
        for (int k = 0; k < 3; k++)
            for (int c = 0; c < 3; c++)
                sum += across[c] * (double)world->vertices[world->indices[3 * t + k]].normal[c];
        assert_true(sum > 0);
    }
}

/* m³ enclosed, where the triangles are closed and seen from outside; negative where they are inside out. */
static double volume_of(const struct world *world)
{
    double volume = 0;
    for (int t = 0; t < world->index_count / 3; t++) {
        double across[3];
        const float *a = world->vertices[world->indices[3 * t]].position;
        normal_of(world, t, across);
        volume += dot((const double[3]){a[0], a[1], a[2]}, across) / 6;
    }
    return volume;
}

/* Least and most that a shape fills of the box around it; 0: it is not closed. */
static const struct {
    const char *shape;
    double least, most;
} solids[] = {
    {"box", 0.999999, 1.000001}, {"sphere", 0.515, 0.5236}, {"pole", 0.6, 0.7854},
    {"rock", 0.35, 0.8},         {"pebbles", 0.35, 0.85},   {"seaweed", 0, 0},
};
enum { SOLIDS = sizeof solids / sizeof *solids };

static void shapes_are_whole(void **state)
{
    struct fixture *fixture = *state;
    for (int s = 0; s < SOLIDS; s++) {
        support_set(fixture->scene, "object.a.shape", "%s", solids[s].shape);
        support_set(fixture->scene, "object.a.size", "0.8 1.2 0.6");
        for (int seed = 1; seed < 4; seed++) {
            support_set(fixture->scene, "object.a.seed", "%d", seed);
            build(fixture);
            check_vertices(&fixture->world);
            check_triangles(&fixture->world);
            double share = volume_of(&fixture->world) / (0.8 * 1.2 * 0.6);
            if (solids[s].most > 0 && (share < solids[s].least || share > solids[s].most))
                fail_msg("%s fills %g of its box", solids[s].shape, share);
        }
    }
}

/* As large as is asked for, and standing on the floor. */
static void shapes_have_their_size(void **state)
{
    static const double size[3] = {0.8, 1.2, 0.6};
    struct fixture *fixture = *state;
    support_set(fixture->scene, "scene.depth", "2");
    support_set(fixture->scene, "current.strength", "0");
    support_set(fixture->scene, "object.a.position", "3 0.25 -1");
    for (int s = 0; s < SOLIDS; s++) {
        support_set(fixture->scene, "object.a.shape", "%s", solids[s].shape);
        support_set(fixture->scene, "object.a.size", "0.8 1.2 0.6");
        build(fixture);
        const struct world *world = &fixture->world;
        double tolerance = solids[s].most > 0 ? 1e-5 : 0.2;
        expect_near(world->low[1], -2 + 0.25, 1e-6);
        for (int c = 0; c < 3; c++)
            assert_true(fabs(world->high[c] - world->low[c] - size[c]) < tolerance * size[c] || solids[s].most == 0);
        expect_near(world->high[1] - world->low[1], size[1], 1e-5);
        assert_true(fabs((world->low[0] + world->high[0]) / 2 - 3) < 0.15);
        assert_true(fabs((world->low[2] + world->high[2]) / 2 + 1) < 0.15);
    }
}

/* Where light is known at vertices, no edge is long. */
static void boxes_are_divided(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "object.a.size", "8 2 0.1");
    build(fixture);
    for (int i = 0; i < fixture->world.index_count; i++) {
        double edge[3];
        int next = i % 3 == 2 ? i - 2 : i + 1;
        subtract(fixture->world.vertices[fixture->world.indices[i]].position,
                 fixture->world.vertices[fixture->world.indices[next]].position, edge);
        assert_true(dot(edge, edge) < 2 * 0.2501 * 0.2501);
    }
}

/* A pole of 2 m that lies towards +x, and is then turned towards +z. */
static void objects_are_tilted_and_then_turned(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "object.a.shape", "pole");
    support_set(fixture->scene, "object.a.size", "0.1 2 0.1");
    support_set(fixture->scene, "object.a.on_floor", "no");
    support_set(fixture->scene, "object.a.tilt", "90");
    build(fixture);
    expect_near(fixture->world.high[0], 2, 1e-5);
    expect_near(fixture->world.low[0], 0, 1e-5);
    expect_near(fixture->world.low[1], -0.05, 1e-3);
    support_set(fixture->scene, "object.a.turn", "90");
    build(fixture);
    expect_near(fixture->world.high[2], 2, 1e-5);
    expect_near(fixture->world.high[0], 0.05, 1e-3);
    check_triangles(&fixture->world);
}

/* A leaning pole comes above a level by a part of it, but its triangles lie all along; a box below is not counted. */
static void what_comes_above_a_level_is_boxed(void **state)
{
    struct fixture *fixture = *state;
    double low[3], high[3];
    support_set(fixture->scene, "object.a.shape", "pole");
    support_set(fixture->scene, "object.a.size", "0.1 2 0.1");
    support_set(fixture->scene, "object.a.on_floor", "no");
    support_set(fixture->scene, "object.a.position", "0 -1 0");
    support_set(fixture->scene, "object.a.tilt", "45");
    support_set(fixture->scene, "object.b.size", "1 1 1");
    support_set(fixture->scene, "object.b.on_floor", "no");
    support_set(fixture->scene, "object.b.position", "9 -2 0");
    build(fixture);
    world_box(&fixture->world, 0, -0.5, low, high);
    expect_near(high[1], fixture->world.high[1], 1e-6);
    assert_true(low[0] < 0.5 && low[1] < -0.5 && high[0] < 1.5);
    expect_near(fixture->world.high[0], 9.5, 1e-5);
    world_box(&fixture->world, 0, 3, low, high);
    assert_true(low[0] > high[0]);
}

/* The side of a box that faces its own +x: turned by 30 degrees towards +z; tilted down by 20 first. */
static void sides_face_where_they_are_turned(void **state)
{
    struct fixture *fixture = *state;
    const double turn = 30 * M_PI / 180, tilt = 20 * M_PI / 180;
    const double wanted[3] = {cos(turn) * cos(tilt), -sin(tilt), sin(turn) * cos(tilt)};
    double nearest = -1;
    support_set(fixture->scene, "object.a.turn", "30");
    support_set(fixture->scene, "object.a.tilt", "20");
    build(fixture);
    check_vertices(&fixture->world);
    check_triangles(&fixture->world);
    for (int v = 0; v < fixture->world.vertex_count; v++) {
        const float *normal = fixture->world.vertices[v].normal;
        nearest = fmax(nearest, dot((const double[3]){normal[0], normal[1], normal[2]}, wanted));
    }
    expect_near(nearest, 1, 1e-6);
}

static void copies_stand_in_their_disc(void **state)
{
    struct fixture *fixture = *state;
    const struct world *world = &fixture->world;
    support_set(fixture->scene, "object.a.shape", "sphere");
    support_set(fixture->scene, "object.a.size", "0.1 0.1 0.1");
    support_set(fixture->scene, "object.a.position", "5 0 -4");
    build(fixture);
    int vertices = world->vertex_count;
    support_set(fixture->scene, "object.a.count", "200");
    support_set(fixture->scene, "object.a.spread", "2");
    build(fixture);
    assert_int_equal(world->vertex_count, 200 * vertices);
    assert_int_equal(world->part_count, 1);
    double mean[2] = {0}, squared = 0;
    for (int k = 0; k < 200; k++) {
        const float *bottom = world->vertices[k * vertices].position;
        double x = (double)bottom[0] - 5, z = (double)bottom[2] + 4;
        assert_true(hypot(x, z) < 2.1);
        mean[0] += x / 200;
        mean[1] += z / 200;
        squared += (x * x + z * z) / 200;
    }
    assert_true(fabs(mean[0]) < 0.1 && fabs(mean[1]) < 0.1);
    assert_true(fabs(squared - 2) < 0.2); /* half of the radius squared where all places are alike */
}

/* Every value that shapes the world gives another fingerprint; the same values give the same bytes. */
static void worlds_are_made_anew_where_something_changed(void **state)
{
    static const char *const changes[][2] = {
        {"object.a.seed", "9"},         {"object.a.turn", "9"},    {"object.a.color", "0.1 0.2 0.3"},
        {"scene.depth", "3"},           {"object.b.count", "2"},   {"floor.relief_height", "0.1"},
        {"floor.relief_length", "0.3"}, {"scene.seed", "4"},       {"scene.size", "6"},
        {"object.a.casts", "no"},       {"current.strength", "2"}, {"floor.relief_turn", "3"},
    };
    struct fixture *fixture = *state;
    struct world again = {0};
    uint64_t before = 0;
    support_set(fixture->scene, "object.a.shape", "rock");
    support_set(fixture->scene, "object.a.size", "0.3 0.2 0.3"); /* few triangles */
    support_set(fixture->scene, "object.b.shape", "seaweed");
    for (size_t i = 0; i < sizeof changes / sizeof *changes; i++) {
        support_set(fixture->scene, changes[i][0], "%s", changes[i][1]);
        build(fixture);
        if (fixture->world.fingerprint == before)
            fail_msg("%s changes nothing", changes[i][0]);
        before = fixture->world.fingerprint;
        const struct world_vertex *kept = fixture->world.vertices;
        support_set(fixture->scene, "sun.azimuth", "%d", (int)i);
        build(fixture);
        assert_ptr_equal(fixture->world.vertices, kept);
        world_finish(&again);
        assert_true(world_build(&again, fixture->scene, &fixture->log.log));
        assert_int_equal(again.vertex_count, fixture->world.vertex_count);
        assert_memory_equal(again.vertices, kept, (size_t)again.vertex_count * sizeof *kept);
        assert_memory_equal(again.indices, fixture->world.indices, (size_t)again.index_count * sizeof *again.indices);
    }
    world_finish(&again);
}

/* Another seed is another rock. */
static void seeds_differ(void **state)
{
    struct fixture *fixture = *state;
    static const char *const shapes[] = {"rock", "pebbles", "seaweed"};
    for (int s = 0; s < 3; s++) {
        struct world other = {0};
        support_set(fixture->scene, "object.a.shape", "%s", shapes[s]);
        support_set(fixture->scene, "object.a.size", "0.3 0.2 0.3");
        support_set(fixture->scene, "object.a.seed", "1");
        build(fixture);
        support_set(fixture->scene, "object.a.seed", "2");
        assert_true(world_build(&other, fixture->scene, &fixture->log.log));
        size_t both = (size_t)(other.vertex_count < fixture->world.vertex_count ? other.vertex_count
                                                                                : fixture->world.vertex_count);
        assert_true(memcmp(other.vertices, fixture->world.vertices, both * sizeof *other.vertices) != 0);
        world_finish(&other);
    }
}

/* Nor are two rocks of the same values the same one, but for the place. */
static void objects_differ(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "object.a.shape", "rock");
    support_set(fixture->scene, "object.b.shape", "rock");
    build(fixture);
    size_t half = (size_t)fixture->world.vertex_count / 2;
    assert_true(memcmp(fixture->world.vertices, fixture->world.vertices + half, half * sizeof(struct world_vertex)) !=
                0);
}

static void colors_are_the_shape_s_or_the_object_s(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "object.a.shape", "sphere");
    build(fixture);
    expect_near(fixture->world.vertices[0].color[0], 0.5, 1e-6);
    support_set(fixture->scene, "object.a.color", "0.2 0.3 0.4");
    build(fixture);
    expect_near(fixture->world.vertices[0].color[0], 0.2, 1e-6);
    expect_near(fixture->world.vertices[0].color[2], 0.4, 1e-6);
}

static void materials_are_parts(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "object.a.pattern", "tiles");
    support_set(fixture->scene, "object.a.pattern_size", "0.3");
    support_set(fixture->scene, "object.b.pattern", "planks");
    support_set(fixture->scene, "object.b.casts", "no");
    support_set(fixture->scene, "object.c.shape", "seaweed");
    support_set(fixture->scene, "object.c.count", "3");
    build(fixture);
    const struct world_part *parts = fixture->world.parts;
    assert_int_equal(fixture->world.part_count, 3);
    assert_int_equal(parts[0].pattern, WORLD_TILES);
    expect_near(parts[0].pattern_size, 0.3, 0);
    assert_true(parts[0].casts && !parts[0].two_sided);
    assert_int_equal(parts[1].pattern, WORLD_PLANKS);
    assert_true(!parts[1].casts && parts[2].casts && parts[2].two_sided);
}

static void no_objects_are_a_world_too(void **state)
{
    struct fixture *fixture = *state;
    build(fixture);
    assert_int_equal(fixture->world.vertex_count, 0);
    assert_true(fixture->world.low[0] > fixture->world.high[0]);
    assert_true(fixture->world.fingerprint != 0);
}

/* Too much is said once, and what comes after it does no harm. */
static void too_many_vertices_are_refused(void **state)
{
    struct fixture *fixture = *state;
    const struct world_vertex vertex = {0};
    struct world_builder builder = {.log = &fixture->log.log, .name = "object.big"};
    builder.vertex_count = builder.vertex_room = WORLD_VERTICES_MAX;
    builder_vertex(&builder, &vertex);
    builder_vertex(&builder, &vertex);
    builder_triangle(&builder, 0, 1, 2);
    builder_smooth(&builder, 0, 0);
    assert_false(builder_ok(&builder));
    EXPECT_ERROR(&fixture->log, DPL_REASON_LIMIT, "object.big", "4000001", "4000000");
    builder_finish(&builder);
}

/* One that cannot be made leaves the one before. */
static void a_world_stays_where_the_next_cannot_be_made(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "object.a.turn", "1");
    build(fixture);
    const struct world before = fixture->world;
    support_set(fixture->scene, "floor.relief_height", "1");
    support_set(fixture->scene, "floor.relief_map", "/nowhere/sand.png");
    assert_false(world_build(&fixture->world, fixture->scene, &fixture->log.log));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_READ, "/nowhere/sand.png");
    assert_memory_equal(&fixture->world, &before, sizeof before);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(shapes_are_whole, setup, teardown),
        cmocka_unit_test_setup_teardown(shapes_have_their_size, setup, teardown),
        cmocka_unit_test_setup_teardown(boxes_are_divided, setup, teardown),
        cmocka_unit_test_setup_teardown(what_comes_above_a_level_is_boxed, setup, teardown),
        cmocka_unit_test_setup_teardown(objects_are_tilted_and_then_turned, setup, teardown),
        cmocka_unit_test_setup_teardown(sides_face_where_they_are_turned, setup, teardown),
        cmocka_unit_test_setup_teardown(copies_stand_in_their_disc, setup, teardown),
        cmocka_unit_test_setup_teardown(worlds_are_made_anew_where_something_changed, setup, teardown),
        cmocka_unit_test_setup_teardown(seeds_differ, setup, teardown),
        cmocka_unit_test_setup_teardown(objects_differ, setup, teardown),
        cmocka_unit_test_setup_teardown(colors_are_the_shape_s_or_the_object_s, setup, teardown),
        cmocka_unit_test_setup_teardown(materials_are_parts, setup, teardown),
        cmocka_unit_test_setup_teardown(no_objects_are_a_world_too, setup, teardown),
        cmocka_unit_test_setup_teardown(too_many_vertices_are_refused, setup, teardown),
        cmocka_unit_test_setup_teardown(a_world_stays_where_the_next_cannot_be_made, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
