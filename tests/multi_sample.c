/* The caustic map of Collard & Mundi 2022 on the CPU against its formulas, written a second time as plain loops in
 * double precision: heights → vertex normals → normals a texel each → the sum of samples. */
#include "support.h"

#include "collard.h"

#define TOLERANCE (1.0 / 255) /* a step of a picture of 8 bits */

struct fixture {
    struct support_log log;
    struct dpl_renderer *renderer;
    struct dpl_scene *scene;
};

static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    support_log_start(&fixture->log);
    fixture->renderer = dpl_renderer_create(NULL, DPL_DEVICE_AUTO, &fixture->log.log);
    fixture->scene = dpl_scene_create(&fixture->log.log);
    *state = fixture;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *fixture = *state;
    dpl_renderer_destroy(fixture->renderer);
    dpl_scene_destroy(fixture->scene);
    free(fixture);
    return 0;
}

/* Unit normals of a map's texels: those of the vertices, by their shares of the triangle, normalised. */
static void texel_normals(double (*vertices)[3], int side, double (*normals)[3])
{
    for (int t = 0; t < side * side; t++) {
        double x = (t % side + 0.5) / side * COLLARD_CELLS, z = (t / side + 0.5) / side * COLLARD_CELLS, length = 0;
        int i = (int)x, j = (int)z;
        double u = x - i, v = z - j;
        const double *right = vertices[j * COLLARD_SIDE + i + 1], *below = vertices[(j + 1) * COLLARD_SIDE + i];
        const double *near = vertices[j * COLLARD_SIDE + i], *far = vertices[(j + 1) * COLLARD_SIDE + i + 1];
        for (int c = 0; c < 3; c++) {
            normals[t][c] = u + v > 1 ? far[c] * (u + v - 1) + right[c] * (1 - v) + below[c] * (1 - u)
                                      : near[c] * (1 - u - v) + right[c] * u + below[c] * v;
            length += normals[t][c] * normals[t][c];
        }
        for (int c = 0; c < 3; c++)
            normals[t][c] /= sqrt(length);
    }
}

static int mirrored(int i, int side)
{
    i = i < 0 ? -1 - i : i;
    return i < side ? i : 2 * side - 1 - i;
}

/* Bilinear, mirrored beyond the edges, made a unit vector again; u and v from 0 to 1 across the map. */
static void look_up(double (*normals)[3], int side, double u, double v, double n[3])
{
    double x = u * side - 0.5, z = v * side - 0.5, length = 0;
    int i = (int)floor(x), j = (int)floor(z);
    double part_x = x - i, part_z = z - j;
    int left = mirrored(i, side), right = mirrored(i + 1, side);
    double(*above)[3] = normals + mirrored(j, side) * side, (*below)[3] = normals + mirrored(j + 1, side) * side;
    for (int c = 0; c < 3; c++) {
        n[c] = (1 - part_z) * ((1 - part_x) * above[left][c] + part_x * above[right][c]) +
               part_z * ((1 - part_x) * below[left][c] + part_x * below[right][c]);
        length += n[c] * n[c];
    }
    length = 1 / sqrt(length);
    for (int c = 0; c < 3; c++)
        n[c] *= length;
}

static double sun_map(double m)
{
    static const double points[][2] = {{.16, 0},   {.20, .004}, {.25, .03}, {.28, .08}, {.30, .14}, {.32, .23},
                                       {.34, .34}, {.36, .46},  {.38, .60}, {.40, .73}, {.42, .84}, {.44, .93},
                                       {.46, .99}, {.475, 1},   {.49, .99}, {.50, .96}};
    if (m <= points[0][0])
        return 0;
    for (int i = 1; i < 16; i++)
        if (m <= points[i][0])
            return points[i - 1][1] +
                   (m - points[i - 1][0]) / (points[i][0] - points[i - 1][0]) * (points[i][1] - points[i - 1][1]);
    return points[15][1];
}

/* What is the same for every texel of a map. */
struct task {
    double D, S;
    double exponent, dark; /* of the cosine; up to where m is at most 0.16, and the sun map black */
    double brightness, power;
    bool keep; /* the normal's height as it is */
    int samples;
    struct {
        double x, z, weight, direction[3];
    } sample[36];
};

static struct task plan(const struct collard_preset *preset, int steps, bool faithful)
{
    struct task task = {.D = preset->depth + 0.6, .S = preset->sun_exponent, .keep = steps == 1};
    task.exponent = fmax(task.S / task.D, task.S);
    task.dark = pow(2 * 0.16, 1 / task.exponent);
    task.brightness = fmax(1 / task.D, 1) * preset->base_intensity;
    task.power = task.D + 1;
    for (int i = 0; i < (steps == 1 ? 1 : (steps + 1) * (steps + 1)); i++) {
        double x = steps == 1 ? 0 : -0.5 + (double)(i % (steps + 1)) / steps;
        double z = steps == 1 ? 0 : -0.5 + (double)(i / (steps + 1)) / steps, toward = faithful ? -z : z;
        double length = sqrt(x * x + 1 / (task.D * task.D) + z * z);
        task.sample[task.samples].x = x;
        task.sample[task.samples].z = z;
        task.sample[task.samples].weight = pow(1 - sqrt(x * x + z * z), 4);
        task.sample[task.samples].direction[0] = x / length;
        task.sample[task.samples].direction[1] = 1 / task.D / length;
        task.sample[task.samples++].direction[2] = toward / length;
    }
    return task;
}

/* What the sun map gives for a normal, seen along a direction. */
static double sun_seen(const struct task *task, const double direction[3], const double n[3])
{
    double tau = direction[0] * n[0] + direction[1] * n[1] + direction[2] * n[2];
    for (int i = 0; i < 5; i++)
        tau *= tau; /* to the 32nd */
    double up = (task->keep ? 1 : 1 - tau) * n[1];
    double length = sqrt(n[0] * n[0] + up * up + n[2] * n[2]);
    double cosine = length > 0 ? up / length : 1;
    return cosine <= task->dark ? 0 : sun_map(0.5 * pow(cosine, task->exponent));
}

/* The value of a texel. */
static double texel_value(const struct task *task, double (*normals)[3], int side, int i, int j)
{
    double sum = 0, n[3];
    for (int k = 0; k < task->samples; k++) {
        look_up(normals, side, (i + 0.5) / side + task->sample[k].x, (j + 0.5) / side + task->sample[k].z, n);
        sum += sun_seen(task, task->sample[k].direction, n) * task->brightness * task->sample[k].weight;
    }
    return fmin(pow(sum, task->power), 1);
}

/* Loads the built-in scene of a preset, and sets what a case varies. */
static void load(struct fixture *fixture, int preset, int side, int steps, bool faithful)
{
    char name[32];
    snprintf(name, sizeof name, "collard-%d", preset);
    assert_true(dpl_scene_load(fixture->scene, name));
    support_set(fixture->scene, "caustics.map", "%d", side);
    support_set(fixture->scene, "multi-sample.steps", "%d", steps);
    support_set(fixture->scene, "multi-sample.faithful", "%s", faithful ? "true" : "false");
}

/* The scene's map against the formulas; returns the largest difference. */
static double difference(struct fixture *fixture, const struct collard_preset *preset, double time, int steps,
                         bool faithful, double (*normals)[3], int side)
{
    struct dpl_image *map = dpl_renderer_map(fixture->renderer, fixture->scene, time);
    assert_non_null(map);
    assert_int_equal(map->width, side);
    assert_int_equal(map->height, side);
    const struct task task = plan(preset, steps, faithful);
    double most = 0;
#pragma omp parallel for reduction(max : most)
    for (int t = 0; t < side * side; t++) {
        double wanted = texel_value(&task, normals, side, t % side, t / side);
        for (int c = 0; c < 3; c++)
            most = fmax(most, fabs((double)map->pixels[t * 3 + c] - wanted));
    }
    dpl_image_destroy(map);
    return most;
}

static void fill_normals(int preset, double time, int side, double (*normals)[3])
{
    static double heights[COLLARD_SIDE * COLLARD_SIDE], vertices[COLLARD_SIDE * COLLARD_SIDE][3];
    const struct collard_preset *values = collard_presets + preset - 1;
    collard_heights(preset, values->amplitude, values->frequency, time, heights);
    collard_normals(heights, 4, vertices);
    texel_normals(vertices, side, normals);
}

static void expect_close(struct fixture *fixture, int preset, double time, int steps, bool faithful,
                         double (*normals)[3], int side)
{
    load(fixture, preset, side, steps, faithful);
    double most = difference(fixture, collard_presets + preset - 1, time, steps, faithful, normals, side);
    if (most > TOLERANCE)
        fail_msg("preset %d, time %g, steps %d, %s, map %d: off by %.5f", preset, time, steps,
                 faithful ? "faithful" : "equal signs", side, most);
}

static void every_preset_time_and_step_is_the_formula(void **state)
{
    static const double times[] = {1, 2.6, 7.3, 20};
    static double normals[256 * 256][3];
    for (int preset = 1; preset <= 4; preset++) {
        for (int k = 0; k < 4; k++) {
            fill_normals(preset, times[k], 256, normals);
            for (int steps = 1; steps <= 5; steps++)
                expect_close(*state, preset, times[k], steps, (k + steps) % 2, normals, 256);
        }
    }
}

static void the_papers_map_is_the_formula(void **state)
{
    double(*normals)[3] = malloc(1024 * 1024 * sizeof *normals);
    for (int preset = 1; preset <= 4; preset++) {
        fill_normals(preset, 2.6, 1024, normals);
        expect_close(*state, preset, 2.6, collard_presets[preset - 1].steps, true, normals, 1024);
    }
    free(normals);
}

/* A texel, or a few, are mirrored again and again within the square of samples. */
static void small_and_odd_maps_are_the_formula(void **state)
{
    static double normals[101 * 101][3];
    static const int sides[] = {1, 2, 3, 7, 101};
    for (int i = 0; i < 5; i++) {
        fill_normals(3, 1, sides[i], normals);
        for (int steps = 1; steps <= 5; steps++)
            expect_close(*state, 3, 1, steps, true, normals, sides[i]);
    }
}

/* Where water is flat and the look goes straight up, the refracted vector is zero: it is to be up. */
static void flat_water_is_the_formula(void **state)
{
    static double normals[32 * 32][3];
    struct fixture *fixture = *state;
    for (int t = 0; t < 32 * 32; t++)
        normals[t][1] = 1;
    for (int steps = 1; steps <= 5; steps++) {
        load(fixture, 4, 32, steps, true);
        support_set(fixture->scene, "collard.amplitude", "0");
        double most = difference(fixture, collard_presets + 3, 1, steps, true, normals, 32);
        assert_true(most <= TOLERANCE);
    }
}

/* Less than a metre with the bias: the sun's exponent and its brightness grow by 1/D. */
static void shallow_water_is_the_formula(void **state)
{
    static double normals[128 * 128][3];
    struct collard_preset shallow = collard_presets[0];
    shallow.depth = 0.05;
    shallow.sun_exponent = 100;
    fill_normals(1, 1, 128, normals);
    for (int steps = 1; steps <= 5; steps++) {
        load(*state, 1, 128, steps, false);
        support_set(((struct fixture *)*state)->scene, "scene.depth", "0.05");
        support_set(((struct fixture *)*state)->scene, "multi-sample.sun_exponent", "100");
        assert_true(difference(*state, &shallow, 1, steps, false, normals, 128) <= TOLERANCE);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(every_preset_time_and_step_is_the_formula, setup, teardown),
        cmocka_unit_test_setup_teardown(the_papers_map_is_the_formula, setup, teardown),
        cmocka_unit_test_setup_teardown(small_and_odd_maps_are_the_formula, setup, teardown),
        cmocka_unit_test_setup_teardown(flat_water_is_the_formula, setup, teardown),
        cmocka_unit_test_setup_teardown(shallow_water_is_the_formula, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
