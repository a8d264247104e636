/* Shapes that are built, and those that enclose: they fit their size, are seen from the side that they are meant to be
 * seen from, are divided finely, and let light through where they are open and nowhere else. */
#include "world.h"

static const struct world *build_shape(struct fixture *fixture, const char *shape, const double size[3])
{
    support_set(fixture->scene, "object.a.shape", "%s", shape);
    support_set(fixture->scene, "object.a.on_floor", "no");
    support_set(fixture->scene, "object.a.size", "%g %g %g", size[0], size[1], size[2]);
    build(fixture);
    return &fixture->world;
}

/* The corners of a triangle, and its normal times twice its area. */
static void corners_of(const struct world *world, int triangle, double p[3][3], double normal[3])
{
    for (int k = 0; k < 3; k++)
        for (int c = 0; c < 3; c++)
            p[k][c] = (double)world->vertices[world->indices[3 * triangle + k]].position[c];
    for (int c = 0; c < 3; c++) {
        int d = (c + 1) % 3, e = (c + 2) % 3;
        normal[c] = (p[1][d] - p[0][d]) * (p[2][e] - p[0][e]) - (p[1][e] - p[0][e]) * (p[2][d] - p[0][d]);
    }
}

/* What a ray meets. */
struct crossing {
    int count; /* of triangles */
    int sides; /* sum of +1 for each that it meets from the front, -1 from behind */
    int first; /* +1 or -1, of the nearest */
};

static struct crossing cross_ray(const struct world *world, const double from[3], const double way[3])
{
    struct crossing crossing = {0};
    double nearest = INFINITY;
    for (int t = 0; t < world->index_count / 3; t++) {
        double p[3][3], normal[3], volume[3], along = 0, facing = 0;
        corners_of(world, t, p, normal);
        for (int k = 0; k < 3; k++) { /* of the tetrahedra between the ray and the triangle's sides */
            double a[3], b[3];
            volume[k] = 0;
            for (int c = 0; c < 3; c++) {
                a[c] = p[k][c] - from[c];
                b[c] = p[(k + 1) % 3][c] - from[c];
            }
            for (int c = 0; c < 3; c++)
                volume[k] += way[c] * (a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3]);
        }
        for (int c = 0; c < 3; c++) {
            along += normal[c] * (p[0][c] - from[c]);
            facing += normal[c] * way[c];
        }
        bool inside =
            (volume[0] > 0 && volume[1] > 0 && volume[2] > 0) || (volume[0] < 0 && volume[1] < 0 && volume[2] < 0);
        if (inside && along / facing > 0) {
            int side = facing < 0 ? 1 : -1;
            crossing.count++;
            crossing.sides += side;
            crossing.first = along / facing < nearest ? side : crossing.first;
            nearest = fmin(nearest, along / facing);
        }
    }
    return crossing;
}

static const struct {
    const char *shape;
    double size[3];
    double beyond[2][3]; /* m that it reaches beyond its size, low and high */
    double longest;      /* m, of a triangle's sides */
    double wrong;        /* share of triangles that may lie across their vertices' normals: folds of rock */
} shapes[] = {
    {"basin", {8, 1.7, 12}, {{2.86, 0.02, 2.86}, {2.86, 0, 2.86}}, 0.36, 0},
    {"steps", {2, 1.2, 1.6}, {{0}}, 0.36, 0},
    {"ladder", {0.6, 1.8, 0.5}, {{0.03, 0, 0.03}, {0.03, 0, 0.03}}, 0.36, 0},
    {"hall", {12, 5, 16}, {{0.02, 0.02, 0.02}, {0.31, 0.02, 0.02}}, 0.36, 0},
    {"cave", {14, 10, 16}, {{0}}, 1.2, 0.002},
    {"quay", {12, 4, 3}, {{0}, {0, 0.46, 0}}, 0.36, 0},
    {"hull", {6, 1.6, 2.1}, {{0.02, 0.02, 0.02}, {0.02, 0.02, 0.02}}, 0.36, 0},
    {"tank", {1.2, 0.6, 0.5}, {{0.13, 0.73, 0.13}, {0.13, 0, 0.13}}, 0.36, 0},
};
enum { SHAPES = sizeof shapes / sizeof *shapes };

static void check_vertices(const struct world *world, int s)
{
    for (int v = 0; v < world->vertex_count; v++) {
        const struct world_vertex *vertex = world->vertices + v;
        double length = 0;
        for (int c = 0; c < 3; c++) {
            double low = c == 1 ? 0 : -shapes[s].size[c] / 2, at = (double)vertex->position[c];
            length += (double)vertex->normal[c] * (double)vertex->normal[c];
            if (!(at >= low - shapes[s].beyond[0][c] - 1e-5 &&
                  at <= low + shapes[s].size[c] + shapes[s].beyond[1][c] + 1e-5))
                fail_msg("%s: reaches %g along %c", shapes[s].shape, at, 'x' + c);
            assert_true(vertex->color[c] > 0 && vertex->color[c] <= 1);
        }
        assert_true(fabs(length - 1) < 1e-4);
    }
}

static void check_triangles(const struct world *world, int s)
{
    int wrong = 0;
    for (int t = 0; t < world->index_count / 3; t++) {
        double p[3][3], normal[3], sum = 0;
        corners_of(world, t, p, normal);
        if (!(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2] > 1e-18))
            fail_msg("%s: a triangle without area at %g %g %g", shapes[s].shape, p[0][0], p[0][1], p[0][2]);
        for (int k = 0; k < 3; k++) {
            double side = 0;
            for (int c = 0; c < 3; c++) {
                side += (p[k][c] - p[(k + 1) % 3][c]) * (p[k][c] - p[(k + 1) % 3][c]);
                sum += normal[c] * (double)world->vertices[world->indices[3 * t + k]].normal[c];
            }
            if (sqrt(side) > shapes[s].longest)
                fail_msg("%s: a side of %g m", shapes[s].shape, sqrt(side));
        }
        wrong += sum <= 0;
    }
    if (wrong > shapes[s].wrong * world->index_count / 3)
        fail_msg("%s: %d triangles lie the wrong way", shapes[s].shape, wrong);
}

static void shapes_fit_their_size(void **state)
{
    struct fixture *fixture = *state;
    for (int s = 0; s < SHAPES; s++) {
        const struct world *world = build_shape(fixture, shapes[s].shape, shapes[s].size);
        assert_true(world->index_count > 0);
        check_vertices(world, s);
        check_triangles(world, s);
        for (int c = 0; c < 3; c++) { /* and fill it */
            double least = shapes[s].size[c] * (c == 1 && !strcmp(shapes[s].shape, "cave") ? 0.75 : 0.9);
            assert_true(world->high[c] - world->low[c] > least);
        }
    }
}

/* The smallest size and a very large one: however it looks, it is made of numbers. */
static void any_size_is_built(void **state)
{
    static const double sizes[][3] = {{0.001, 0.001, 0.001}, {25, 8, 25}, {20, 0.01, 0.01}, {0.01, 5, 0.01}};
    struct fixture *fixture = *state;
    for (int s = 0; s < SHAPES; s++)
        for (int i = 0; i < 4; i++) {
            const struct world *world = build_shape(fixture, shapes[s].shape, sizes[i]);
            for (int v = 0; v < world->vertex_count; v++) {
                double length = 0;
                for (int c = 0; c < 3; c++) {
                    length += (double)world->vertices[v].normal[c] * (double)world->vertices[v].normal[c];
                    assert_true(isfinite(world->vertices[v].position[c]) && isfinite(world->vertices[v].color[c]));
                }
                if (!(fabs(length - 1) < 1e-3))
                    fail_msg("%s: size %d: a normal of length %g", shapes[s].shape, i, sqrt(length));
            }
        }
}

/* A ray meets so many triangles at least, the first from the front. */
static void expect_seen(const struct world *world, const double from[3], const double way[3], int least,
                        const char *what)
{
    const struct crossing crossing = cross_ray(world, from, way);
    if (crossing.count < least || crossing.first != 1)
        fail_msg("%s: %d triangles, the first from %d", what, crossing.count, crossing.first);
}

static void a_basin_faces_its_water(void **state)
{
    const struct world *world = build_shape(*state, "basin", (const double[3]){8, 1.7, 12});
    for (int i = 0; i < 40; i++) {
        double angle = 2 * M_PI * (i + 0.37) / 40, height = 0.05 + 1.6 * i / 40;
        expect_seen(world, (const double[3]){0.1, height, 0.2}, (const double[3]){cos(angle), 0.003, sin(angle)}, 1,
                    "wall");
        const double out[2] = {4 + 2.8 * fabs(cos(i)), 6 + 2.8 * fabs(sin(i))};
        const double deck[3] = {i & 1 ? out[0] : -out[0], 3, i & 2 ? out[1] : -out[1]};
        expect_seen(world, deck, (const double[3]){0.001, -1, 0.0013}, 1, "deck");
    }
    assert_int_equal(cross_ray(world, (const double[3]){1, 3, 1}, (const double[3]){0.1, -1, 0.1}).count, 0);
}

/* Sun comes in by the windows, and by nothing else. */
static void a_hall_is_open_at_its_windows(void **state)
{
    const struct world *world = build_shape(*state, "hall", (const double[3]){12, 5, 16});
    uint64_t random = 9;
    int through = 0;
    for (int i = 0; i < 60; i++) {
        double angle = M_PI / 2 + M_PI * support_random_unit(&random), rise = support_random_unit(&random);
        expect_seen(world, (const double[3]){0.3, 1, -0.2}, (const double[3]){cos(angle), rise, sin(angle)}, 1, "wall");
        expect_seen(world, (const double[3]){0.3, 1, -0.2}, (const double[3]){rise - 0.5, 1, cos(angle)}, 1, "ceiling");
        const double inside[3] = {5, 0.6 + 3.4 * support_random_unit(&random), 15.8 * (rise - 0.5)};
        through += cross_ray(world, inside, (const double[3]){1, 0.01, 0.013}).count == 0;
    }
    assert_in_range(through, 60 * 0.45, 60 * 0.8);
}

static void a_cave_is_open_at_its_mouth(void **state)
{
    const struct world *world = build_shape(*state, "cave", (const double[3]){14, 10, 16});
    for (int i = 0; i < 40; i++) {
        double angle = M_PI * (i + 0.5) / 40, back = -0.3 + 0.6 * (i % 7) / 7;
        const double from[3] = {-2, 1.5, 0.1}, way[3] = {back, sin(angle), cos(angle)};
        expect_seen(world, from, way, 1, "vault");
        if (i % 4 == 0)
            expect_seen(world, from, (const double[3]){-1, 0.5 * sin(angle), 0.5 * cos(angle)}, 1, "back");
    }
    assert_int_equal(cross_ray(world, (const double[3]){-2, 1.5, 0.1}, (const double[3]){1, 0.02, 0.01}).count, 0);
    assert_true(world->index_count / 3 > 50000 && world->index_count / 3 < 80000);
}

/* A ray that comes from outside meets a front first, and behind it the back of the other side. */
static void solids_are_closed(void **state)
{
    static const struct {
        const char *shape;
        double size[3];
    } solids[] = {{"ladder", {0.6, 1.8, 0.5}}, {"tank", {1.2, 0.6, 0.5}}};
    struct fixture *fixture = *state;
    uint64_t random = 4;
    for (int s = 0; s < 2; s++) {
        const struct world *world = build_shape(fixture, solids[s].shape, solids[s].size);
        for (int i = 0; i < 300; i++) {
            double from[3], way[3];
            for (int c = 0; c < 3; c++) {
                from[c] = 20 * (support_random_unit(&random) - 0.5) + (c == 0 ? 20 : 0);
                way[c] = solids[s].size[c] * (support_random_unit(&random) - (c == 1 ? 0 : 0.5)) - from[c];
            }
            assert_int_equal(cross_ray(world, from, way).sides, 0);
        }
    }
}

/* So thin that chance does not find them: a ladder's feet, which end behind the tubes. */
static void tubes_have_ends(void **state)
{
    const struct world *world = build_shape(*state, "ladder", (const double[3]){0.6, 1.8, 0.5});
    for (int side = -1; side <= 1; side += 2) {
        const double from[3] = {0.28 * side + 0.003, 0.025, -5}, way[3] = {0.0001, 0.0002, 1};
        const struct crossing crossing = cross_ray(world, from, way);
        assert_int_equal(crossing.first, 1);
        assert_int_equal(crossing.sides, 0);
    }
}

/* Of a boat, the outside shows planks, and from above one sees into it. */
static void a_hull_has_two_sides(void **state)
{
    const struct world *world = build_shape(*state, "hull", (const double[3]){6, 1.6, 2.1});
    for (int i = 0; i < 20; i++) {
        double x = -2.6 + 0.2 * i;
        expect_seen(world, (const double[3]){x, 1.9, 3}, (const double[3]){0.001, -0.4, -1}, 2, "side");
        expect_seen(world, (const double[3]){x, 0.9, -3}, (const double[3]){0.001, -0.05, 1}, 2, "other side");
        expect_seen(world, (const double[3]){x, 3, 0.2}, (const double[3]){0.001, -1, 0.002}, 2, "inside");
    }
}

static void a_mesh_is_scaled_to_fit(void **state)
{
    struct fixture *fixture = *state;
    char folder[64], path[128];
    support_folder_make(folder);
    snprintf(path, sizeof path, "%s/a.obj", folder);
    FILE *stream = fopen(path, "w");
    fputs("v 10 -2 0\nv 14 -2 0\nv 10 0 0\nv 10 -2 8\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", stream);
    fclose(stream);
    support_set(fixture->scene, "object.a.shape", "mesh");
    assert_false(world_build(&fixture->world, fixture->scene, &fixture->log.log));
    EXPECT_ERROR(&fixture->log, DPL_REASON_VALUE, "object.a.file", ".obj");
    support_set(fixture->scene, "object.a.file", "%s", path);
    support_set(fixture->scene, "object.a.color", "0.25 0.5 1");
    const struct world *world = build_shape(fixture, "mesh", (const double[3]){3, 0.5, 4});
    const double low[3] = {-0.5, 0, -1}, high[3] = {0.5, 0.5, 1};
    for (int c = 0; c < 3; c++) {
        if (!(fabs(world->low[c] - low[c]) < 1e-6 && fabs(world->high[c] - high[c]) < 1e-6))
            fail_msg("%g to %g along %c", world->low[c], world->high[c], 'x' + c);
        assert_true(fabs((double)world->vertices[0].color[c] - 0.25 * (1 << c)) < 1e-6);
    }
    support_set(fixture->scene, "object.a.file", "%s.none.obj", path);
    assert_false(world_build(&fixture->world, fixture->scene, &fixture->log.log));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_READ, "none.obj");
    assert_int_equal(world->index_count, 12); /* what was built stays */
    support_folder_count(folder, true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(shapes_fit_their_size, setup, teardown),
        cmocka_unit_test_setup_teardown(any_size_is_built, setup, teardown),
        cmocka_unit_test_setup_teardown(a_basin_faces_its_water, setup, teardown),
        cmocka_unit_test_setup_teardown(a_hall_is_open_at_its_windows, setup, teardown),
        cmocka_unit_test_setup_teardown(a_cave_is_open_at_its_mouth, setup, teardown),
        cmocka_unit_test_setup_teardown(solids_are_closed, setup, teardown),
        cmocka_unit_test_setup_teardown(tubes_have_ends, setup, teardown),
        cmocka_unit_test_setup_teardown(a_hull_has_two_sides, setup, teardown),
        cmocka_unit_test_setup_teardown(a_mesh_is_scaled_to_fit, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
