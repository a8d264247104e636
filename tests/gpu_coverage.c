/* The technique `coverage` on the GPU against the plain sum of tests/coverage.h, with compute shaders and without, in
 * OpenGL and in OpenGL ES; and the optics that its shaders share with the CPU. */
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

/* A receiver below the given sun (degrees), and how close the map comes. */
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

static const struct setup setups[] = {
    {64, 64, "sines", 1, 0, 60, 30, 1.333},    {64, 64, "sines", 3, 0, 90, 0, 1.333},
    {100, 37, "sines", 2, 0, 30, 200, 1.333},  {37, 150, "sines", 2, 0, 60, -70, 1.333},
    {1, 20, "sines", 1, 0, 60, 30, 1.333},     {96, 4, "sines", 1, 0, 50, 10, 1.333},
    {64, 64, "sines", 0.01, 0, 10, 30, 1.333}, {64, 64, "sines", 1, 2, 60, 30, 1.333},
    {64, 64, "sines", 1, 0, 60, 30, 1},        {64, 2, "collard", 1, 0, 60, 30, 1.333},
    {80, 90, "sines", 6, 0, 45, 120, 1.333},   {50, 60, "sines", 1, 8, 35, 120, 1.333},
};

static void a_point_sun_is_the_plain_sum(void **state)
{
    (void)state;
    for (int kind = 0; kind < KINDS; kind++) {
        struct fixture fixture;
        start(&fixture, kind);
        for (size_t i = 0; i < sizeof setups / sizeof *setups; i++) {
            const struct setup *setup = setups + i;
            double energy;
            apply(&fixture, setup, 0);
            double *wanted = wanted_map(&fixture, setup, 0, 1, setup->ceiling > 0 ? setup->ceiling : -setup->depth);
            double error = compare(dpl_renderer_map(fixture.renderer, fixture.scene, 1), wanted, &energy);
            print_message("kind %d setup %zu: error %.6f energy %.6f\n", kind, i, error, energy);
            free(wanted);
        }
        finish(&fixture);
    }
}

static void the_disc_is_many_suns(void **state)
{
    (void)state;
    static const struct setup discs[] = {
        {64, 64, "sines", 0.5, 0, 60, 30, 1.333},
        {64, 64, "sines", 2, 0, 60, 30, 1.333},
        {64, 64, "sines", 1, 0, 30, 30, 1.333},
        {64, 64, "sines", 4, 0, 90, 30, 1.333},
    };
    for (int kind = 0; kind < KINDS; kind++) {
        struct fixture fixture;
        start(&fixture, kind);
        for (size_t i = 0; i < sizeof discs / sizeof *discs * 3; i++) {
            const struct setup *setup = discs + i / 3;
            static const double radii[] = {0.2665, 2, 8};
            double energy, radius = radii[i % 3];
            apply(&fixture, setup, radius);
            double *wanted = wanted_map(&fixture, setup, radius, 48, -setup->depth);
            double error = compare(dpl_renderer_map(fixture.renderer, fixture.scene, 1), wanted, &energy);
            print_message("kind %d disc %zu: error %.6f energy %.6f\n", kind, i, error, energy);
            free(wanted);
        }
        finish(&fixture);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_point_sun_is_the_plain_sum),
        cmocka_unit_test(the_disc_is_many_suns),
    };
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
