/* No light comes in between the faces of a shape. Where faces only touch, a picture shows single pixels of what is
 * behind them: their edges are rounded apart. So a ray counts as stopped only by the inside of a face, or at an edge
 * that the face shares with another, vertex by vertex. */
#include "support.h"

#include "scene/world.h"

#define EDGE 1e-4 /* m from a free edge, where a ray may slip through */

struct triangle {
    double corners[3][3], normal[3];
    bool shared[3]; /* the side from each corner to the next, with another triangle */
};

struct side {
    float ends[2][3];
    int triangle, corner;
};

struct faces {
    struct dpl_scene *scene;
    struct triangle *triangles;
    int count;
};

static int compare_sides(const void *a, const void *b)
{
    const struct side *one = a, *other = b;
    for (int i = 0; i < 6; i++) {
        float x = one->ends[i / 3][i % 3], y = other->ends[i / 3][i % 3];
        if (x < y || x > y)
            return x < y ? -1 : 1;
    }
    return 0;
}

/* The lower end first, so that both triangles at a side give it the same. */
static struct side side_of(const struct world *world, int triangle, int corner)
{
    struct side side = {.triangle = triangle, .corner = corner}, turned = side;
    for (int end = 0; end < 2; end++) {
        const float *position = world->vertices[world->indices[3 * triangle + (corner + end) % 3]].position;
        for (int c = 0; c < 3; c++)
            side.ends[end][c] = turned.ends[1 - end][c] = position[c];
    }
    return compare_sides(&side, &turned) < 0 ? side : turned;
}

static void find_shared(struct faces *faces, const struct world *world)
{
    struct side *sides = calloc((size_t)faces->count * 3, sizeof *sides);
    for (int i = 0; i < 3 * faces->count; i++)
        sides[i] = side_of(world, i / 3, i % 3);
    qsort(sides, (size_t)faces->count * 3, sizeof *sides, compare_sides);
    for (int i = 0; i + 1 < 3 * faces->count; i++)
        if (compare_sides(sides + i, sides + i + 1) == 0)
            for (int k = i; k < i + 2; k++)
                faces->triangles[sides[k].triangle].shared[sides[k].corner] = true;
    free(sides);
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int c = 0; c < 3; c++)
        out[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void subtract(const double a[3], const double b[3], double out[3])
{
    for (int c = 0; c < 3; c++)
        out[c] = a[c] - b[c];
}

static void build(struct faces *faces)
{
    struct support_log log;
    struct world world = {0};
    if (!world_build(&world, faces->scene, support_log_start(&log)))
        fail_msg("%s", log.text);
    faces->count = world.index_count / 3;
    faces->triangles = calloc((size_t)faces->count, sizeof *faces->triangles);
    for (int t = 0; t < faces->count; t++) {
        struct triangle *triangle = faces->triangles + t;
        double a[3], b[3];
        for (int i = 0; i < 9; i++)
            triangle->corners[i / 3][i % 3] = (double)world.vertices[world.indices[3 * t + i / 3]].position[i % 3];
        subtract(triangle->corners[1], triangle->corners[0], a);
        subtract(triangle->corners[2], triangle->corners[0], b);
        cross(a, b, triangle->normal);
    }
    find_shared(faces, &world);
    world_finish(&world);
}

/* Whether a place in a triangle's plane is inside it, and not near a free side. */
static bool holds(const struct triangle *triangle, const double place[3])
{
    double area = sqrt(dot(triangle->normal, triangle->normal));
    for (int k = 0; k < 3; k++) {
        double along[3], to[3], out[3];
        subtract(triangle->corners[(k + 1) % 3], triangle->corners[k], along);
        subtract(place, triangle->corners[k], to);
        cross(along, to, out);
        if (dot(out, triangle->normal) / area / sqrt(dot(along, along)) < (triangle->shared[k] ? -1e-7 : EDGE))
            return false;
    }
    return true;
}

/* What a ray meets first: 1 a front, -1 a back, 0 nothing. */
static int first_met(const struct faces *faces, const double from[3], const double way[3])
{
    double nearest = INFINITY;
    int met = 0;
    for (int t = 0; t < faces->count; t++) {
        const struct triangle *triangle = faces->triangles + t;
        double to[3], place[3], facing = dot(triangle->normal, way);
        subtract(triangle->corners[0], from, to);
        double distance = dot(triangle->normal, to) / facing;
        if (!(distance > 0 && distance < nearest))
            continue;
        for (int c = 0; c < 3; c++)
            place[c] = from[c] + distance * way[c];
        if (holds(triangle, place)) {
            nearest = distance;
            met = facing < 0 ? 1 : -1;
        }
    }
    return met;
}

/* Looks from a place at free sides in a box, one of `every`. From inside an enclosure something is seen everywhere, and
 * of everything only the front. */
static void look_at_edges(const struct faces *faces, const double from[3], const double box[2][3], int every,
                          bool enclosed)
{
    uint64_t random = 11;
    int looked = 0;
    for (int i = 0; i < 3 * faces->count; i++) {
        const struct triangle *triangle = faces->triangles + i / 3;
        double place[3], way[3], share = support_random_unit(&random);
        bool inside = !triangle->shared[i % 3] && support_random(&random) % (uint32_t)every == 0;
        for (int c = 0; c < 3; c++) {
            double a = triangle->corners[i % 3][c], b = triangle->corners[(i + 1) % 3][c];
            place[c] = a + share * (b - a) + 2e-5 * (support_random_unit(&random) - 0.5);
            inside = inside && place[c] > box[0][c] && place[c] < box[1][c];
        }
        if (!inside)
            continue;
        looked++;
        subtract(place, from, way);
        int met = first_met(faces, from, way);
        if (met < 0 || (enclosed && met == 0))
            fail_msg("%s seen at %g %g %g", met ? "a back" : "the open", place[0], place[1], place[2]);
    }
    assert_true(looked > 50);
}

static int setup(void **state)
{
    struct faces *faces = calloc(1, sizeof *faces);
    struct support_log log;
    faces->scene = dpl_scene_create(support_log_start(&log));
    *state = faces;
    return 0;
}

static int teardown(void **state)
{
    struct faces *faces = *state;
    dpl_scene_destroy(faces->scene);
    free(faces->triangles);
    free(faces);
    return 0;
}

static void add(struct faces *faces, const char *name, const char *shape, const char *position, const char *size)
{
    char parameter[64];
    const char *const values[][2] = {{"shape", shape}, {"on_floor", "no"}, {"position", position}, {"size", size}};
    for (int i = 0; i < 4; i++) {
        snprintf(parameter, sizeof parameter, "object.%s.%s", name, values[i][0]);
        support_set(faces->scene, parameter, "%s", values[i][1]);
    }
}

/* But for the windows, whose outer edges are at x > 6.6. */
static void a_hall_around_a_basin_is_closed(void **state)
{
    struct faces *faces = *state;
    add(faces, "basin", "basin", "0 0 0", "8 1.9 8");
    add(faces, "hall", "hall", "0 1.9 0", "13 5 13");
    build(faces);
    const double box[2][3] = {{-20, 0.05, -20}, {6.6, 20, 20}};
    look_at_edges(faces, (const double[3]){-3.13, 3.61, 2.17}, box, 3, true);
    look_at_edges(faces, (const double[3]){2.71, 1.43, -1.37}, box, 3, true);
}

static void a_hull_is_closed(void **state)
{
    struct faces *faces = *state;
    const double all[2][3] = {{-20, -20, -20}, {20, 20, 20}};
    add(faces, "hull", "hull", "0 0 0", "5 1.3 1.9");
    build(faces);
    look_at_edges(faces, (const double[3]){-4.1, 0.83, 3.2}, all, 2, false);
    look_at_edges(faces, (const double[3]){-5.3, 1.31, -0.7}, all, 2, false);
    look_at_edges(faces, (const double[3]){3.7, 0.31, 3.9}, all, 2, false);
    look_at_edges(faces, (const double[3]){0.13, 3.9, 0.21}, all, 2, false);
}

static void a_quay_is_closed(void **state)
{
    struct faces *faces = *state;
    const double front[2][3] = {{-20, 0.05, -20}, {20, 20, 20}};
    add(faces, "quay", "quay", "0 0 0", "12 4 3");
    build(faces);
    look_at_edges(faces, (const double[3]){2.3, 2.7, 6.1}, front, 2, false);
    look_at_edges(faces, (const double[3]){-9.7, 5.3, 4.1}, front, 2, false);
    look_at_edges(faces, (const double[3]){9.1, 3.3, -4.7}, front, 2, false);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_hall_around_a_basin_is_closed, setup, teardown),
        cmocka_unit_test_setup_teardown(a_hull_is_closed, setup, teardown),
        cmocka_unit_test_setup_teardown(a_quay_is_closed, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
