/* The model `ripples` on the GPU against the CPU, in OpenGL and in OpenGL ES: film by film of drops, rain and a ball
 * that swims and is dragged. */
#include "support.h"

#include <math.h>

/* A scene as two renderers see it. */
struct pair {
    struct support_log log;
    struct dpl_gl *gl;
    struct dpl_scene *scene;
    struct dpl_renderer *gpu, *cpu;
};

static void start(struct pair *pair, bool es, const char *text)
{
    *pair = (struct pair){0};
    const struct dpl_log *log = support_log_start(&pair->log);
    pair->gl = support_gl(es, log);
    pair->scene = support_scene(text, log);
    pair->gpu = dpl_renderer_create(pair->gl, DPL_DEVICE_GL, log);
    pair->cpu = dpl_renderer_create(NULL, DPL_DEVICE_CPU, log);
}

static void finish(struct pair *pair)
{
    assert_int_equal(pair->log.errors, 0);
    dpl_renderer_destroy(pair->gpu);
    dpl_renderer_destroy(pair->cpu);
    dpl_scene_destroy(pair->scene);
    dpl_gl_destroy(pair->gl);
}

/* The largest differences of heights and slopes in units of the largest height and slope. */
static void compare(struct pair *pair, double time, double tolerance)
{
    struct dpl_image *got = dpl_renderer_surface(pair->gpu, pair->scene, time);
    struct dpl_image *wanted = dpl_renderer_surface(pair->cpu, pair->scene, time);
    assert_non_null(got);
    assert_non_null(wanted);
    assert_int_equal(got->width, wanted->width);
    double largest[2] = {0, 0}, errors[2] = {0, 0};
    for (int k = 0; k < wanted->width * wanted->height * 3; k++) {
        int slope = k % 3 != 0;
        largest[slope] = fmax(largest[slope], fabs((double)wanted->pixels[k]));
        errors[slope] = fmax(errors[slope], fabs((double)got->pixels[k] - (double)wanted->pixels[k]));
    }
    assert_true(largest[0] > 1e-5 && largest[1] > 1e-4);
    if (!(errors[0] <= tolerance * largest[0] && errors[1] <= tolerance * largest[1]))
        print_error("%g s: heights %g of %g, slopes %g of %g\n", time, errors[0], largest[0], errors[1], largest[1]);
    assert_true(errors[0] <= tolerance * largest[0] && errors[1] <= tolerance * largest[1]);
    dpl_image_destroy(got);
    dpl_image_destroy(wanted);
}

#define POOL                                                                                                           \
    "[scene]\nsize = 2\n[water]\nmodel = ripples\n[ripples]\nside = 96\nrain = 20\n"                                   \
    "[sphere]\nradius = 0.25\nposition = -0.4 0.5 0.2\ngravity = on\n"

static void films_agree(void **state)
{
    (void)state;
    for (int es = 0; es < 2; es++) {
        struct pair pair;
        start(&pair, es, POOL "[ripples]\ndevice = gpu\n");
        for (int frame = 0; frame < 90; frame++) {
            if (frame == 20)
                support_set(pair.scene, "sphere.position", "0.3 -0.1 -0.2");
            if (frame == 33) {
                dpl_renderer_drop(pair.gpu, 0.1, 0.7, 0.2, -0.02);
                dpl_renderer_drop(pair.cpu, 0.1, 0.7, 0.2, -0.02);
            }
            compare(&pair, frame / 50.0, 1e-4);
        }
        finish(&pair);
    }
}

/* The GPU is given the CPU's water where it has missed what happened: other grids, leaps, time that goes back. */
static void water_that_the_gpu_has_not_seen_is_copied(void **state)
{
    (void)state;
    static const double times[] = {0.5, 0.51, 5, 5.01, 0.3, 0.3, 60, 60.02};
    struct pair pair;
    start(&pair, false, POOL "[ripples]\ndevice = gpu\n");
    for (int i = 0; i < 8; i++) {
        support_set(pair.scene, "ripples.side", "%d", i < 4 ? 64 : 50);
        compare(&pair, times[i], 1e-5);
    }
    support_set(pair.scene, "ripples.device", "cpu");
    compare(&pair, 60.1, 1e-6);
    support_set(pair.scene, "ripples.device", "gpu");
    compare(&pair, 60.2, 1e-5);
    finish(&pair);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(films_agree),
        cmocka_unit_test(water_that_the_gpu_has_not_seen_is_copied),
    };
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
