/* The technique `wavefront` on the GPU against the plain sum of tests/wavefront.h, by each of its variants, in OpenGL
 * and in OpenGL ES. */
#include "support.h"

#include "wavefront.h"

#include "light/map_texture.h"
#include "light/wavefront.h"

extern const struct light_technique light_wavefront;

struct fixture {
    struct support_log log;
    struct dpl_gl *gl;
    struct dpl_renderer *renderer;
    struct dpl_scene *scene;
};

static const char *const variants[] = {"derivatives", "geometry", "neighbours"};

static void start_scene(struct fixture *fixture)
{
    dpl_scene_destroy(fixture->scene);
    fixture->scene = support_scene("[scene]\ndepth = 1\n[sun]\nangular_radius = 0\nelevation = 50\nazimuth = 25\n"
                                   "[water]\nmodel = sines\n[wave.1]\ncycles = 2 1\namplitude = 0.03\n"
                                   "[wave.2]\ncycles = -3 2\namplitude = 0.015\n[wave.3]\ncycles = 5 4\n"
                                   "amplitude = 0.004\n[caustics]\ntechnique = wavefront\nmap = 64\nmesh = 48\n",
                                   &fixture->log.log);
}

static void start(struct fixture *fixture, bool es)
{
    *fixture = (struct fixture){0};
    const struct dpl_log *log = support_log_start(&fixture->log);
    fixture->gl = support_gl_of_floats(es, log);
    fixture->renderer = dpl_renderer_create(fixture->gl, DPL_DEVICE_GL, log);
    start_scene(fixture);
}

static void finish(struct fixture *fixture)
{
    assert_int_equal(fixture->log.errors, 0);
    dpl_renderer_destroy(fixture->renderer);
    dpl_scene_destroy(fixture->scene);
    dpl_gl_destroy(fixture->gl);
}

/* The map of a variant; the caller destroys it. */
static struct dpl_image *map_of(struct fixture *fixture, const char *variant)
{
    support_set(fixture->scene, "wavefront.variant", "%s", variant);
    struct dpl_image *map = dpl_renderer_map(fixture->renderer, fixture->scene, 1);
    if (!map)
        fail_msg("%s", fixture->log.text);
    for (int i = 0; i < map->width * map->height * 3; i++)
        assert_true(isfinite(map->pixels[i]) && map->pixels[i] >= 0);
    return map;
}

/* Calls `check` in OpenGL and in OpenGL ES with each variant. */
static void every_variant(void (*check)(struct fixture *fixture, const char *variant))
{
    for (int es = 0; es < 2; es++) {
        struct fixture fixture;
        start(&fixture, es);
        for (int v = 0; v < 3; v++) {
            start_scene(&fixture);
            check(&fixture, variants[v]);
        }
        finish(&fixture);
    }
}

/* Halves have 11 bits, which llvmpipe rounds down. */
static void check_still_water(struct fixture *fixture, const char *variant)
{
    static const char *const receivers[][2] = {{"1", "0"}, {"0.01", "0"}, {"7", "0"}, {"1", "2"}};
    for (int w = 1; w <= 3; w++) {
        char key[32];
        snprintf(key, sizeof key, "wave.%d.amplitude", w);
        support_set(fixture->scene, key, "0");
    }
    for (int k = 0; k < 8 * 4; k++) {
        support_set(fixture->scene, "wavefront.area", k & 1 ? "lengths" : "determinant");
        support_set(fixture->scene, "wavefront.folds", k & 2 ? "overwrite" : "add");
        support_set(fixture->scene, "wavefront.weights", k & 4 ? "false" : "true");
        support_set(fixture->scene, "wavefront.mesh", "%d", k & 1 ? 0 : 37);
        support_set(fixture->scene, "scene.depth", "%s", receivers[k / 8][0]);
        support_set(fixture->scene, "caustics.ceiling", "%s", receivers[k / 8][1]);
        support_set(fixture->scene, "sun.elevation", "%d", k & 1 ? 20 : 61);
        struct dpl_image *map = map_of(fixture, variant);
        for (int i = 0; i < 64 * 64 * 3; i++)
            assert_true(fabs((double)map->pixels[i] - 1) < 1e-3);
        dpl_image_destroy(map);
    }
}

static void still_water_gives_one_everywhere(void **state)
{
    (void)state;
    every_variant(check_still_water);
}

/* The plain sum for the scene as it is; the caller frees it. */
static double *wanted_map(struct fixture *fixture, bool periodic, double receiver, bool lengths, bool overwrite)
{
    struct dpl_image *surface = dpl_renderer_surface(fixture->renderer, fixture->scene, 1);
    double *map = calloc(64 * 64, sizeof *map), e = 50 * M_PI / 180, a = 25 * M_PI / 180;
    assert_non_null(surface);
    struct wavefront_case c = {
        .water = {.columns = surface->width,
                  .side = 64,
                  .periodic = periodic,
                  .size = 4,
                  .receiver = receiver,
                  .sun = {cos(e) * cos(a), sin(e), cos(e) * sin(a)},
                  .ior = 1.333,
                  .absorption = 0.35,
                  .surface = surface->pixels},
        .lengths = lengths,
        .overwrite = overwrite,
        .most = 20,
    };
    wavefront_map(&c, map);
    dpl_image_destroy(surface);
    return map;
}

/* The share of texels that are off by more than a hundredth. OpenGL places corners on a grid of 1/256 texel, which
 * gives texels at edges to one side or the other. */
static double share_off(const struct dpl_image *map, const double *wanted)
{
    int off = 0;
    for (int i = 0; i < 64 * 64; i++)
        off += fabs((double)map->pixels[3 * i] - wanted[i]) > 0.01 * fmax(wanted[i], 1);
    return off / (64.0 * 64);
}

static void check_plain(struct fixture *fixture, const char *variant)
{
    static const struct {
        const char *model;
        double depth, ceiling;
        bool lengths, overwrite;
    } cases[] = {
        {"sines", 1, 0, false, false}, {"sines", 5, 0, false, false},  {"sines", 2, 0, true, false},
        {"sines", 1, 3, false, false}, {"collard", 1, 0, true, false}, {"collard", 4, 0, false, true},
    };
    for (int k = 0; k < 6; k++) {
        support_set(fixture->scene, "water.model", "%s", cases[k].model);
        support_set(fixture->scene, "collard.wave", "preset-4");
        support_set(fixture->scene, "scene.depth", "%g", cases[k].depth);
        support_set(fixture->scene, "caustics.ceiling", "%g", cases[k].ceiling);
        support_set(fixture->scene, "wavefront.area", cases[k].lengths ? "lengths" : "determinant");
        support_set(fixture->scene, "wavefront.folds", cases[k].overwrite ? "overwrite" : "add");
        support_set(fixture->scene, "wavefront.most", "20");
        double receiver = cases[k].ceiling > 0 ? cases[k].ceiling : -cases[k].depth;
        double *wanted =
            wanted_map(fixture, !strcmp(cases[k].model, "sines"), receiver, cases[k].lengths, cases[k].overwrite);
        struct dpl_image *map = map_of(fixture, variant);
        double share = share_off(map, wanted);
        if (share > 0.01)
            fail_msg("%s, case %d: %.4f of all texels are off", variant, k, share);
        dpl_image_destroy(map);
        free(wanted);
    }
}

static void a_map_is_the_plain_sum(void **state)
{
    (void)state;
    every_variant(check_plain);
}

static double mean_of(const struct dpl_image *map)
{
    double sum = 0;
    for (int i = 0; i < map->width * map->height; i++)
        sum += (double)map->pixels[3 * i + 2];
    return sum / (map->width * map->height);
}

/* Water beyond its focus: light comes in from neighbouring tiles, sheets overlap. */
static void set_deep(struct fixture *fixture)
{
    support_set(fixture->scene, "scene.depth", "6");
    support_set(fixture->scene, "caustics.map", "256");
    support_set(fixture->scene, "caustics.mesh", "128");
}

static void check_means(struct fixture *fixture, const char *variant)
{
    double means[2];
    set_deep(fixture);
    for (int k = 0; k < 2; k++) {
        support_set(fixture->scene, "wavefront.folds", k ? "overwrite" : "add");
        struct dpl_image *map = map_of(fixture, variant);
        means[k] = mean_of(map);
        dpl_image_destroy(map);
    }
    assert_true(fabs(means[0] - 1) < 0.03);
    assert_true(means[1] < 0.9 * means[0]);
}

static void folds_add_up_or_hide_each_other(void **state)
{
    (void)state;
    every_variant(check_means);
}

/* All see the same triangles; they differ by rounding, that of halves included. */
static void variants_agree(void **state)
{
    (void)state;
    for (int es = 0; es < 2; es++) {
        struct fixture fixture;
        start(&fixture, es);
        set_deep(&fixture);
        struct dpl_image *maps[3];
        for (int v = 0; v < 3; v++)
            maps[v] = map_of(&fixture, variants[v]);
        bool geometry = dpl_gl_describe(fixture.gl)->geometry;
        assert_int_equal(geometry, !es);
        for (int i = 0; i < 256 * 256 * 3; i++) {
            double light = (double)maps[0]->pixels[i];
            assert_true(fabs((double)maps[1]->pixels[i] - light) <= 0.01 * fmax(light, 1));
            assert_true(fabs((double)maps[2]->pixels[i] - light) <= 0.01 * fmax(light, 1));
        }
        if (!geometry) /* what stands in its place */
            assert_memory_equal(maps[1]->pixels, maps[2]->pixels, sizeof(float) * 256 * 256 * 3);
        for (int v = 0; v < 3; v++)
            dpl_image_destroy(maps[v]);
        finish(&fixture);
    }
}

/* A mesh of its own, and slices, as on the CPU. */
static void a_mesh_and_slices_are_those_of_the_cpu(void **state)
{
    (void)state;
    for (int es = 0; es < 2; es++) {
        struct fixture fixture;
        start(&fixture, es);
        struct dpl_renderer *on_cpu = dpl_renderer_create(NULL, DPL_DEVICE_CPU, &fixture.log.log);
        support_set(fixture.scene, "wavefront.mesh", "75");
        support_set(fixture.scene, "caustics.slices", "3");
        for (int k = 0; k < 6; k++) {
            support_set(fixture.scene, "water.model", k < 3 ? "sines" : "collard");
            support_set(fixture.scene, "collard.wave", "preset-4");
            support_set(fixture.scene, "caustics.window", k == 5 ? "light" : "tile");
            struct dpl_image *map = dpl_renderer_slice(fixture.renderer, fixture.scene, 1, k % 3);
            struct dpl_image *wanted = dpl_renderer_slice(on_cpu, fixture.scene, 1, k % 3);
            int off = 0;
            for (int i = 0; i < 64 * 64 * 3; i++)
                off += fabs((double)(map->pixels[i] - wanted->pixels[i])) > 0.01 * fmax((double)wanted->pixels[i], 1);
            assert_true(off < 0.01 * 64 * 64 * 3);
            dpl_image_destroy(map);
            dpl_image_destroy(wanted);
        }
        dpl_renderer_destroy(on_cpu);
        finish(&fixture);
    }
}

/* Water whose points move sideways; it ends at its edges. */
static void make_choppy(struct surface *surface)
{
    assert_true(surface_resize(surface, 33, 33, false, true, 4, NULL));
    for (int v = 0; v < 33 * 33; v++) {
        double angle = M_PI * (v % 33 + v / 33) / 8;
        surface->texels[3 * v] = (float)(0.03 * cos(angle));
        surface->texels[3 * v + 1] = surface->texels[3 * v + 2] = (float)(-0.1 * sin(angle));
        surface->shifts[2 * v] = (float)(0.05 * sin(angle));
        surface->shifts[2 * v + 1] = (float)(-0.03 * cos(angle));
    }
}

static void check_choppy(struct dpl_gl *gl, int variant, int mesh)
{
    struct wavefront params;
    struct surface surface = {0};
    struct surface_gpu surface_gpu = {0};
    struct gpu_texture texture = {0};
    struct light_map map = {0};
    const struct ray_window window = {-2, -2, 4};
    const struct optics_sun sun = {.elevation = 70, .azimuth = 25, .angular_radius = 0};
    const struct water_medium medium = {.ior = 1.333, .dispersion = 0, .absorption = {0.35, 0.07, 0.03}};
    const struct water_setup setup = {.size = 4};
    const double receiver = -1;
    void *states[2] = {calloc(1, light_wavefront.state_size), calloc(1, light_wavefront.state_size)};
    const struct light_input input = {&surface,
                                      &surface_gpu,
                                      NULL,
                                      &setup,
                                      .receivers = &receiver,
                                      .slices = 1,
                                      .windows = &window,
                                      .sun = &sun,
                                      .medium = &medium,
                                      .params = &params};
    param_defaults(light_wavefront.params, &params);
    params.variant = variant;
    params.mesh = mesh;
    make_choppy(&surface);
    gpu_enter(gl);
    surface_gpu_upload(gl, &surface_gpu, &surface);
    map_texture_resize(gl, &texture, 64, 3, 1, MAP_DRAWN, false, false);
    assert_true(light_wavefront.draw(states[0], gl, &input, &texture));
    struct dpl_image *image = map_texture_read(gl, &texture, 0);
    assert_true(light_map_resize(&map, 64, 3, 1, NULL) && light_wavefront.trace(states[1], &input, &map));
    int off = 0;
    for (int i = 0; i < 64 * 64 * 3; i++)
        off += fabs((double)(image->pixels[i] - map.texels[i])) > 0.01 * fmax((double)map.texels[i], 1);
    assert_true(off < 0.01 * 64 * 64 * 3);
    dpl_image_destroy(image);
    light_map_finish(&map);
    texture_finish(gl, &texture);
    surface_gpu_finish(gl, &surface_gpu);
    surface_finish(&surface);
    for (int k = 0; k < 2; k++) {
        light_wavefront.finish(states[k], gl);
        free(states[k]);
    }
    gpu_leave(gl, 0);
}

static void choppy_water_is_that_of_the_cpu(void **state)
{
    (void)state;
    for (int es = 0; es < 2; es++) {
        struct fixture fixture;
        start(&fixture, es);
        for (int k = 0; k < 6; k++)
            check_choppy(fixture.gl, k % 3, k / 3 * 20);
        finish(&fixture);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(still_water_gives_one_everywhere),       cmocka_unit_test(a_map_is_the_plain_sum),
        cmocka_unit_test(folds_add_up_or_hide_each_other),        cmocka_unit_test(variants_agree),
        cmocka_unit_test(a_mesh_and_slices_are_those_of_the_cpu), cmocka_unit_test(choppy_water_is_that_of_the_cpu),
    };
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
