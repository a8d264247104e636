/* Surfaces and caustic maps from the GPU against those from the CPU, in OpenGL 3.3 and in OpenGL ES 3.0. */
#include "support.h"

#include <math.h>

struct fixture {
    struct support_log log;
    struct dpl_gl *gl;
    struct dpl_renderer *on_gpu, *on_cpu;
    struct dpl_scene *scene;
};

static void start(struct fixture *fixture, bool es)
{
    *fixture = (struct fixture){0};
    const struct dpl_log *log = support_log_start(&fixture->log);
    fixture->gl = support_gl_of_floats(es, log);
    assert_int_equal(dpl_gl_describe(fixture->gl)->es, es);
    fixture->on_gpu = dpl_renderer_create(fixture->gl, DPL_DEVICE_GL, log);
    fixture->on_cpu = dpl_renderer_create(NULL, DPL_DEVICE_CPU, log);
    fixture->scene = dpl_scene_create(log);
    support_set(fixture->scene, "caustics.technique", "multi-sample");
}

static void finish(struct fixture *fixture)
{
    assert_int_equal(fixture->log.errors, 0);
    dpl_renderer_destroy(fixture->on_gpu);
    dpl_renderer_destroy(fixture->on_cpu);
    dpl_scene_destroy(fixture->scene);
    dpl_gl_destroy(fixture->gl);
}

/* The largest difference between two images of the same size, which it destroys. */
static double difference(struct dpl_image *a, struct dpl_image *b)
{
    double most = 0;
    assert_non_null(a);
    assert_non_null(b);
    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    for (int i = 0; i < a->width * a->height * 3; i++)
        most = fmax(most, isfinite(a->pixels[i]) ? fabs((double)a->pixels[i] - (double)b->pixels[i]) : INFINITY);
    dpl_image_destroy(a);
    dpl_image_destroy(b);
    return most;
}

/* The GPU keeps normals and the map in half precision, 11 bits: a step of 8 bits is left over for what the sun map's
 * exponent makes of a normal's last bit. */
static void expect_same_map(struct fixture *fixture, double time)
{
    double most = difference(dpl_renderer_map(fixture->on_gpu, fixture->scene, time),
                             dpl_renderer_map(fixture->on_cpu, fixture->scene, time));
    if (most > 1.0 / 255)
        fail_msg("off by %.5f", most);
}

static void check_maps(bool es)
{
    struct fixture fixture;
    start(&fixture, es);
    for (int preset = 1; preset <= 4; preset++) {
        char name[32];
        snprintf(name, sizeof name, "collard-%d", preset);
        assert_true(dpl_scene_load(fixture.scene, name));
        support_set(fixture.scene, "caustics.map", "256");
        for (int steps = 1; steps <= 7; steps++) {
            support_set(fixture.scene, "multi-sample.steps", "%d", steps);
            support_set(fixture.scene, "multi-sample.faithful", steps % 2 ? "true" : "false");
            expect_same_map(&fixture, 2.6);
        }
        for (int blur = 1; blur <= 5; blur += 2) {
            support_set(fixture.scene, "caustics.blur", "%d", blur);
            expect_same_map(&fixture, 7.3);
        }
    }
    finish(&fixture);
}

static void maps_are_those_of_the_cpu(void **state)
{
    (void)state;
    check_maps(false);
}

static void maps_are_those_of_the_cpu_in_es(void **state)
{
    (void)state;
    check_maps(true);
}

static void check_sides(bool es)
{
    static const int sides[] = {1, 2, 3, 5, 64, 101};
    struct fixture fixture;
    start(&fixture, es);
    support_set(fixture.scene, "wave.1.cycles", "2 1");
    support_set(fixture.scene, "caustics.mesh", "50");
    for (int i = 0; i < 6; i++) {
        support_set(fixture.scene, "caustics.map", "%d", sides[i]);
        for (int blur = 0; blur <= 5; blur += 5) {
            support_set(fixture.scene, "caustics.blur", "%d", blur);
            expect_same_map(&fixture, 0.4);
        }
    }
    finish(&fixture);
}

static void maps_of_any_side_are_those_of_the_cpu(void **state)
{
    (void)state;
    check_sides(false);
}

static void maps_of_any_side_are_those_of_the_cpu_in_es(void **state)
{
    (void)state;
    check_sides(true);
}

/* The sun's picture and the map are kept in half precision. Heights evaluated on the GPU are off by 3e-5, which
 * differences divide by the distance of the vertices. */
static void check_straight_rays(bool es)
{
    static const char *const techniques[] = {"pixel-ray", "vertex-ray"}, *const normals[] = {"differences", "slopes"};
    static const int sides[] = {1, 2, 101, 256}, meshes[] = {0, 2, 50, 300};
    struct fixture fixture;
    start(&fixture, es);
    for (int k = 0; k < 16; k++) {
        assert_true(dpl_scene_load(fixture.scene, k / 2 % 2 ? "collard-2" : "shallows")); /* bounded; periodic */
        support_set(fixture.scene, "caustics.technique", "%s", techniques[k % 2]);
        support_set(fixture.scene, "caustics.map", "%d", sides[k / 4]);
        support_set(fixture.scene, "caustics.margin", "%g", k % 3 ? 0.2 : 0);
        support_set(fixture.scene, "caustics.window", "light");
        support_set(fixture.scene, "caustics.slices", "%d", k % 2 + 1);
        support_set(fixture.scene, "pixel-ray.normals", "%s", normals[k / 4 % 2]);
        support_set(fixture.scene, "vertex-ray.mesh", "%d", meshes[k / 4]);
        expect_same_map(&fixture, 0.4);
    }
    finish(&fixture);
}

static void straight_rays_are_those_of_the_cpu(void **state)
{
    (void)state;
    check_straight_rays(false);
    check_straight_rays(true);
}

/* Waves so steep that light is kept inside: dark on both, but for the texels on the line between. */
static void light_is_kept_inside_on_both(void **state)
{
    struct fixture fixture;
    int dark = 0, apart = 0;
    const int side = 200;
    (void)state;
    start(&fixture, false);
    support_set(fixture.scene, "caustics.technique", "pixel-ray");
    support_set(fixture.scene, "pixel-ray.sun_width", "90");
    support_set(fixture.scene, "caustics.map", "%d", side);
    support_set(fixture.scene, "wave.1.cycles", "2 1");
    support_set(fixture.scene, "wave.1.amplitude", "0.5");
    struct dpl_image *gpu = dpl_renderer_map(fixture.on_gpu, fixture.scene, 0);
    struct dpl_image *cpu = dpl_renderer_map(fixture.on_cpu, fixture.scene, 0);
    for (int t = 0; t < side * side; t++) {
        dark += cpu->pixels[t * 3] == 0;
        apart += fabs((double)cpu->pixels[t * 3] - (double)gpu->pixels[t * 3]) > 1.0 / 255;
    }
    assert_true(dark > side * side / 4);
    assert_true(dark < side * side * 3 / 4);
    assert_true(apart < side * side / 100);
    dpl_image_destroy(gpu);
    dpl_image_destroy(cpu);
    finish(&fixture);
}

/* Every receiver has a layer of its own, blurred or not. */
static void check_slices(bool es)
{
    struct fixture fixture;
    start(&fixture, es);
    support_set(fixture.scene, "wave.1.cycles", "2 1");
    support_set(fixture.scene, "wave.1.amplitude", "0.03");
    support_set(fixture.scene, "caustics.map", "40");
    support_set(fixture.scene, "caustics.slices", "5");
    for (int blur = 0; blur <= 2; blur += 2) {
        support_set(fixture.scene, "caustics.blur", "%d", blur);
        for (int slice = 0; slice < 5; slice++) {
            struct dpl_image *gpu = dpl_renderer_slice(fixture.on_gpu, fixture.scene, 1, slice);
            assert_true(difference(gpu, dpl_renderer_slice(fixture.on_cpu, fixture.scene, 1, slice)) <= 1.0 / 255);
            if (slice > 0) /* not the floor's again */
                assert_true(difference(dpl_renderer_slice(fixture.on_gpu, fixture.scene, 1, slice),
                                       dpl_renderer_map(fixture.on_gpu, fixture.scene, 1)) > 2.0 / 255);
        }
    }
    for (int wrong = -1; wrong <= 5; wrong += 6) {
        assert_null(dpl_renderer_slice(fixture.on_gpu, fixture.scene, 1, wrong));
        EXPECT_ERROR(&fixture.log, DPL_REASON_RANGE, "slice", "0 to 4");
    }
    finish(&fixture);
}

static void slices_are_those_of_the_cpu(void **state)
{
    (void)state;
    check_slices(false);
    check_slices(true);
}

static void a_ceiling_needs_a_technique_that_reflects(void **state)
{
    struct fixture fixture;
    (void)state;
    start(&fixture, false);
    support_set(fixture.scene, "caustics.technique", "multi-sample");
    support_set(fixture.scene, "caustics.ceiling", "2");
    assert_null(dpl_renderer_map(fixture.on_gpu, fixture.scene, 1));
    EXPECT_ERROR(&fixture.log, DPL_REASON_UNSUPPORTED, "caustics.ceiling", "multi-sample", "\"2\"");
    assert_null(dpl_renderer_map(fixture.on_cpu, fixture.scene, 1));
    EXPECT_ERROR(&fixture.log, DPL_REASON_UNSUPPORTED, "caustics.ceiling");
    finish(&fixture);
}

/* 64 waves of up to 40 cycles: their angles reach 250 radians, of which single precision keeps 1.5e-5; a slope is that
 * much of k times the height. */
static void check_surface(bool es)
{
    struct fixture fixture;
    uint64_t random = 9;
    double height = 0, slope = 0;
    start(&fixture, es);
    support_set(fixture.scene, "caustics.mesh", "123");
    for (int w = 1; w <= 64; w++) {
        char key[32];
        int x = (int)(support_random(&random) % 81) - 40, z = (int)(support_random(&random) % 81) - 40;
        double amplitude = 0.01 * support_random_unit(&random);
        snprintf(key, sizeof key, "wave.%d.cycles", w);
        support_set(fixture.scene, key, "%d %d", x, z);
        snprintf(key, sizeof key, "wave.%d.amplitude", w);
        support_set(fixture.scene, key, "%.17g", amplitude);
        height += amplitude;
        slope += amplitude * 2 * M_PI * hypot(x, z) / 4;
    }
    for (int k = 0; k < 3; k++) {
        struct dpl_image *gpu = dpl_renderer_surface(fixture.on_gpu, fixture.scene, k * 100);
        struct dpl_image *cpu = dpl_renderer_surface(fixture.on_cpu, fixture.scene, k * 100);
        assert_int_equal(gpu->width, 123);
        for (int i = 0; i < 123 * 123 * 3; i++) {
            double apart = fabs((double)gpu->pixels[i] - (double)cpu->pixels[i]);
            assert_true(apart <= 3e-5 * (i % 3 ? slope : height));
        }
        assert_true(difference(gpu, cpu) > 0); /* not the CPU's own twice */
    }
    finish(&fixture);
}

static void sines_are_those_of_the_cpu(void **state)
{
    (void)state;
    check_surface(false);
}

static void sines_are_those_of_the_cpu_in_es(void **state)
{
    (void)state;
    check_surface(true);
}

/* What the CPU evaluates for the GPU comes back as it was. */
static void check_upload(bool es)
{
    struct fixture fixture;
    start(&fixture, es);
    assert_true(dpl_scene_load(fixture.scene, "collard-2"));
    assert_true(difference(dpl_renderer_surface(fixture.on_gpu, fixture.scene, 3),
                           dpl_renderer_surface(fixture.on_cpu, fixture.scene, 3)) == 0);
    finish(&fixture);
}

static void uploaded_surfaces_are_those_of_the_cpu(void **state)
{
    (void)state;
    check_upload(false);
    check_upload(true);
}

static void check_bytes(bool es)
{
    struct dpl_image *maps[2], *pictures[2];
    for (int run = 0; run < 2; run++) {
        struct fixture fixture;
        start(&fixture, es);
        assert_true(dpl_scene_load(fixture.scene, "collard-3"));
        support_set(fixture.scene, "caustics.map", "200");
        if (run == 1) /* another frame before */
            dpl_image_destroy(dpl_renderer_picture(fixture.on_gpu, fixture.scene, 1, 320, 200));
        maps[run] = dpl_renderer_map(fixture.on_gpu, fixture.scene, 2);
        pictures[run] = dpl_renderer_picture(fixture.on_gpu, fixture.scene, 2, 320, 200);
        finish(&fixture);
    }
    assert_true(difference(maps[0], maps[1]) == 0);
    assert_true(difference(pictures[0], pictures[1]) == 0);
}

static void two_runs_give_the_same_bytes(void **state)
{
    (void)state;
    check_bytes(false);
    check_bytes(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(maps_are_those_of_the_cpu),
        cmocka_unit_test(maps_are_those_of_the_cpu_in_es),
        cmocka_unit_test(maps_of_any_side_are_those_of_the_cpu),
        cmocka_unit_test(maps_of_any_side_are_those_of_the_cpu_in_es),
        cmocka_unit_test(straight_rays_are_those_of_the_cpu),
        cmocka_unit_test(light_is_kept_inside_on_both),
        cmocka_unit_test(slices_are_those_of_the_cpu),
        cmocka_unit_test(a_ceiling_needs_a_technique_that_reflects),
        cmocka_unit_test(sines_are_those_of_the_cpu),
        cmocka_unit_test(sines_are_those_of_the_cpu_in_es),
        cmocka_unit_test(uploaded_surfaces_are_those_of_the_cpu),
        cmocka_unit_test(two_runs_give_the_same_bytes),
    };
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
