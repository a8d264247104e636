/* The technique `coverage` on the GPU against the plain sum of tests/coverage.h, with compute shaders and without, in
 * OpenGL and in OpenGL ES. */
#include "coverage.h"
#include "gpu_state.h"

struct fixture {
    struct support_log log;
    struct dpl_gl *headless, *gl; /* the second one lives in the first one's context */
    struct dpl_renderer *renderer;
    struct dpl_scene *scene;
};

enum { KINDS = 4 }; /* OpenGL, OpenGL ES; with all that the device has, without */

static void start(struct fixture *fixture, int kind)
{
    *fixture = (struct fixture){0};
    const struct dpl_log *log = support_log_start(&fixture->log);
    fixture->headless = support_gl(kind % 2, log);
    struct dpl_gl_options options = {.get_proc_address = state_get_function, .plain = kind / 2};
    fixture->gl = dpl_gl_create(&options, log);
    assert_non_null(fixture->gl);
    assert_false(dpl_gl_describe(fixture->gl)->compute && options.plain);
    fixture->renderer = dpl_renderer_create(fixture->gl, DPL_DEVICE_GL, log);
    fixture->scene = support_scene("[water]\nmodel = sines\n[wave.1]\ncycles = 2 1\namplitude = 0.03\n"
                                   "[wave.2]\ncycles = -3 2\namplitude = 0.015\n[wave.3]\ncycles = 5 4\n"
                                   "amplitude = 0.004\n[caustics]\ntechnique = coverage\nmap = 64\nmesh = 64\n",
                                   log);
}

static void finish(struct fixture *fixture)
{
    assert_int_equal(fixture->log.errors, 0);
    dpl_renderer_destroy(fixture->renderer);
    dpl_scene_destroy(fixture->scene);
    dpl_gl_destroy(fixture->gl);
    dpl_gl_destroy(fixture->headless);
}

/* Water and a receiver below a sun; metres and degrees. */
struct setup {
    int map, mesh;
    const char *model;
    double depth, ceiling, elevation, azimuth, ior;
};

/* The vector to a place of the sun's disc, whose radius is in degrees. */
static void sun_at(const struct setup *setup, double radius, const double place[2], double sun[3])
{
    double e = setup->elevation * M_PI / 180, a = setup->azimuth * M_PI / 180, r = sin(radius * M_PI / 180);
    double up = place[0] * r, across = place[1] * r, ahead = sqrt(1 - up * up - across * across);
    sun[0] = (ahead * cos(e) - up * sin(e)) * cos(a) - across * sin(a);
    sun[1] = ahead * sin(e) + up * cos(e);
    sun[2] = (ahead * cos(e) - up * sin(e)) * sin(a) + across * cos(a);
}

static void apply(struct fixture *fixture, const struct setup *setup, double radius)
{
    support_set(fixture->scene, "caustics.map", "%d", setup->map);
    support_set(fixture->scene, "caustics.mesh", "%d", setup->mesh);
    support_set(fixture->scene, "caustics.ceiling", "%g", setup->ceiling);
    support_set(fixture->scene, "water.model", "%s", setup->model);
    support_set(fixture->scene, "water.ior", "%g", setup->ior);
    support_set(fixture->scene, "scene.depth", "%g", setup->depth);
    support_set(fixture->scene, "sun.elevation", "%g", setup->elevation);
    support_set(fixture->scene, "sun.azimuth", "%g", setup->azimuth);
    support_set(fixture->scene, "sun.angular_radius", "%g", radius);
}

/* The red channel by the plain sum over `suns` places of the disc, at the receiver's height; the caller frees it. */
static double *wanted_map(struct fixture *fixture, const struct setup *setup, double radius, int suns, double receiver)
{
    struct dpl_image *surface = dpl_renderer_surface(fixture->renderer, fixture->scene, 1);
    double *map = calloc((size_t)(setup->map * setup->map), sizeof *map);
    assert_non_null(surface);
    for (int s = 0; s < suns; s++) { /* Vogel 1979: evenly over a disc */
        double r = suns == 1 ? 0 : sqrt((s + 0.5) / suns), angle = s * 2.399963229728653;
        struct coverage_case c = {.columns = surface->width,
                                  .side = setup->map,
                                  .periodic = !strcmp(setup->model, "sines"),
                                  .size = 4,
                                  .receiver = receiver,
                                  .ior = setup->ior,
                                  .absorption = 0.35,
                                  .surface = surface->pixels};
        sun_at(setup, radius, (double[2]){r * cos(angle), r * sin(angle)}, c.sun);
        coverage_map(&c, 1.0 / suns, map);
    }
    dpl_image_destroy(surface);
    return map;
}

/* Of the error in the wanted map's, and how far the mean is off. */
static double compare(struct dpl_image *image, const double *wanted, double *energy)
{
    double errors = 0, squares = 0, sum = 0, off = 0;
    assert_non_null(image);
    for (int i = 0; i < image->width * image->height; i++) {
        double got = (double)image->pixels[3 * i];
        assert_true(isfinite(got));
        errors += (got - wanted[i]) * (got - wanted[i]);
        squares += wanted[i] * wanted[i];
        off += got - wanted[i];
        sum += wanted[i];
    }
    *energy = fabs(off) / sum;
    dpl_image_destroy(image);
    return sqrt(errors / squares);
}

struct expectation {
    struct setup setup;
    double radius;        /* degrees, of the sun */
    double error, energy; /* accepted: RMS in units of the map's own, and of its mean */
};
#define EXPECTATIONS_MAX 16

static void check(const struct expectation *expectations, size_t count, int suns)
{
    double *wanted[EXPECTATIONS_MAX] = {NULL}; /* made once, for all kinds of devices */
    assert_true(count <= EXPECTATIONS_MAX);
    for (int kind = 0; kind < KINDS; kind++) {
        struct fixture fixture;
        start(&fixture, kind);
        for (size_t i = 0; i < count; i++) {
            const struct expectation *e = expectations + i;
            double energy;
            apply(&fixture, &e->setup, e->radius);
            if (!wanted[i])
                wanted[i] = wanted_map(&fixture, &e->setup, e->radius, suns,
                                       e->setup.ceiling > 0 ? e->setup.ceiling : -e->setup.depth);
            double error = compare(dpl_renderer_map(fixture.renderer, fixture.scene, 1), wanted[i], &energy);
            if (error > e->error || energy > e->energy)
                fail_msg("kind %d, case %zu: error %.6f, energy off by %.6f", kind, i, error, energy);
        }
        finish(&fixture);
    }
    for (size_t i = 0; i < count; i++)
        free(wanted[i]);
}

/* The map keeps halves, 11 bits, which llvmpipe rounds down: 3.5e-4 in the mean. Triangles thinner than 1/64 texel are
 * made as wide as that, which moves a little light by less than a hundredth of a texel. */
#define EXACT 2e-3, 5e-4

static void a_point_sun_is_the_plain_sum(void **state)
{
    (void)state;
    static const struct expectation expectations[] = {
        {{64, 64, "sines", 1, 0, 60, 30, 1.333}, 0, EXACT},
        {{64, 64, "sines", 3, 0, 90, 0, 1.333}, 0, EXACT},
        {{100, 37, "sines", 2, 0, 30, 200, 1.333}, 0, EXACT},
        {{37, 150, "sines", 2, 0, 60, -70, 1.333}, 0, EXACT}, /* many cells in a texel */
        {{1, 20, "sines", 1, 0, 60, 30, 1.333}, 0, EXACT},
        {{96, 4, "sines", 1, 0, 50, 10, 1.333}, 0, EXACT}, /* cells that are split */
        {{64, 64, "sines", 0.01, 0, 10, 30, 1.333}, 0, EXACT},
        {{64, 64, "sines", 1, 2, 60, 30, 1.333}, 0, EXACT},
        {{50, 60, "sines", 1, 8, 35, 120, 1.333}, 0, EXACT},
        {{64, 64, "sines", 1, 0, 60, 30, 1}, 0, EXACT}, /* nothing is bent */
        {{64, 2, "collard", 1, 0, 60, 30, 1.333}, 0, EXACT},
        {{80, 90, "sines", 6, 0, 45, 120, 1.333}, 0, EXACT},
    };
    check(expectations, sizeof expectations / sizeof *expectations, 1);
}

/* One footprint for the whole map, the mean over the water: the wider the sun, the more that shows. The sun's own
 * width, eight times it, and one whose map is made with larger texels. */
static void a_disc_is_many_suns(void **state)
{
    (void)state;
    static const struct expectation expectations[] = {
        {{64, 64, "sines", 0.5, 0, 60, 30, 1.333}, 0.2665, EXACT},
        {{64, 64, "sines", 2, 0, 60, 30, 1.333}, 0.2665, EXACT},
        {{64, 64, "sines", 1, 0, 30, 30, 1.333}, 0.2665, EXACT},
        {{64, 64, "sines", 4, 0, 90, 30, 1.333}, 0.2665, 0.01, 5e-4},
        {{64, 64, "sines", 1, 3, 50, 30, 1.333}, 0.2665, 0.07, 5e-4}, /* thrown back: slopes count most */
        {{64, 64, "sines", 2, 0, 60, 30, 1.333}, 2, 0.01, 5e-4},
        {{64, 64, "sines", 4, 0, 90, 30, 1.333}, 8, 0.04, 1e-3},
    };
    check(expectations, sizeof expectations / sizeof *expectations, 48);
}

/* Compares slice `slice` of three. */
static void check_slice(struct fixture *fixture, const struct setup *setup, int slice)
{
    double energy, *wanted = wanted_map(fixture, setup, 0, 1, -setup->depth * (3 - slice) / 3);
    struct dpl_image *image = dpl_renderer_slice(fixture->renderer, fixture->scene, 1, slice);
    assert_true(compare(image, wanted, &energy) < 2e-3);
    free(wanted);
}

static void every_slice_has_its_own_light(void **state)
{
    static const struct setup setup = {48, 48, "sines", 2, 0, 60, 30, 1.333};
    (void)state;
    for (int kind = 0; kind < KINDS; kind++) {
        struct fixture fixture;
        start(&fixture, kind);
        apply(&fixture, &setup, 0);
        support_set(fixture.scene, "caustics.slices", "3");
        for (int slice = 0; slice < 3; slice++)
            check_slice(&fixture, &setup, slice);
        finish(&fixture);
    }
}

/* Red, green and blue light are bent by indices of their own, and only red is compared: with the index that is left
 * when the water itself has that of red. */
static void dispersion_bends_colours_apart(void **state)
{
    struct setup setup = {64, 64, "sines", 2, 0, 60, 30, 1.333};
    (void)state;
    for (int kind = 0; kind < KINDS; kind++) {
        struct fixture fixture;
        double energy;
        start(&fixture, kind);
        setup.ior = 1.333;
        apply(&fixture, &setup, 0);
        support_set(fixture.scene, "water.dispersion", "0.1");
        struct dpl_image *image = dpl_renderer_map(fixture.renderer, fixture.scene, 1);
        setup.ior = 1.283;
        double *wanted = wanted_map(&fixture, &setup, 0, 1, -2);
        assert_true(compare(image, wanted, &energy) < 2e-3);
        free(wanted);
        finish(&fixture);
    }
}

static void still_water_gives_one_everywhere(void **state)
{
    (void)state;
    for (int kind = 0; kind < KINDS; kind++) {
        struct fixture fixture;
        start(&fixture, kind);
        for (int wave = 1; wave <= 3; wave++) {
            char key[32];
            snprintf(key, sizeof key, "wave.%d.amplitude", wave);
            support_set(fixture.scene, key, "0");
        }
        for (int i = 0; i < 6; i++) {
            static const char *const radii[] = {"0", "0.2665", "5"};
            support_set(fixture.scene, "sun.angular_radius", "%s", radii[i % 3]);
            support_set(fixture.scene, "caustics.map", "%d", i < 3 ? 64 : 75);
            support_set(fixture.scene, "caustics.ceiling", "%d", i % 2);
            struct dpl_image *image = dpl_renderer_map(fixture.renderer, fixture.scene, 1);
            assert_non_null(image);
            for (int k = 0; k < image->width * image->height * 3; k++)
                assert_true(fabs((double)image->pixels[k] - 1) < 2e-3);
            dpl_image_destroy(image);
        }
        finish(&fixture);
    }
}

static void two_runs_give_the_same_bytes(void **state)
{
    (void)state;
    for (int kind = 0; kind < KINDS; kind++) {
        struct dpl_image *maps[2];
        for (int run = 0; run < 2; run++) {
            struct fixture fixture;
            start(&fixture, kind);
            support_set(fixture.scene, "caustics.map", "200");
            if (run == 1) /* another frame before */
                dpl_image_destroy(dpl_renderer_picture(fixture.renderer, fixture.scene, 0, 64, 64));
            maps[run] = dpl_renderer_map(fixture.renderer, fixture.scene, 1);
            finish(&fixture);
        }
        assert_memory_equal(maps[0]->pixels, maps[1]->pixels, 200 * 200 * 3 * sizeof(float));
        dpl_image_destroy(maps[0]);
        dpl_image_destroy(maps[1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_point_sun_is_the_plain_sum),     cmocka_unit_test(a_disc_is_many_suns),
        cmocka_unit_test(every_slice_has_its_own_light),    cmocka_unit_test(dispersion_bends_colours_apart),
        cmocka_unit_test(still_water_gives_one_everywhere), cmocka_unit_test(two_runs_give_the_same_bytes),
    };
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
