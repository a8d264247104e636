/* The model `ocean` on the GPU against the CPU, in OpenGL 3.3 and in OpenGL ES 3.0. */
#include "support.h"

#include "scene/scene.h"

#include <math.h>

/* All of what changes the passes: one grid and several, in one texture and in several, choppy or not, vertices that are
 * those of a cascade, more and fewer. */
static const char *const scenes[] = {
    "[ocean]\nresolution = 32\ncascades = 1\n",
    ("[scene]\nsize = 12\nloop = 5\n[caustics]\nmesh = 100\n[ocean]\nresolution = 64\ncascades = 4\nspectrum = "
     "phillips\n"),
    "[caustics]\nmesh = 300\n[ocean]\nresolution = 128\ncascades = 3\nchoppiness = 1\n",
};

struct surfaces {
    struct surface cpu, gpu;
    struct surface_gpu textures;
};

/* The largest difference in units of the largest of `scale` numbers, every `step`-th from `first`. */
static double apart(const float *a, const float *b, int count, int first, int step)
{
    double most = 0, scale = 0;
    for (int i = first; i < count; i += step) {
        most = fmax(most, isfinite(a[i]) ? fabs((double)a[i] - (double)b[i]) : INFINITY);
        scale = fmax(scale, fabs((double)b[i]));
    }
    assert_true(scale > 0);
    return most / scale;
}

/* Single precision, ten or so roundings in a row; a slope is a difference of coefficients that are some ten times as
 * large. */
static void expect_same(const struct surfaces *surfaces)
{
    const struct surface *cpu = &surfaces->cpu, *gpu = &surfaces->gpu;
    int vertices = cpu->columns * cpu->rows;
    assert_int_equal(gpu->columns, cpu->columns);
    assert_int_equal(gpu->shifts != NULL, cpu->shifts != NULL);
    for (int c = 0; c < 3; c++)
        assert_true(apart(gpu->texels, cpu->texels, vertices * 3, c, 3) < (c ? 2e-5 : 2e-6));
    for (int c = 0; c < 2 && cpu->shifts; c++)
        assert_true(apart(gpu->shifts, cpu->shifts, vertices * 2, c, 2) < 2e-6);
    assert_true(memcmp(gpu->texels, cpu->texels, (size_t)vertices * 3 * sizeof(float)) != 0); /* not the CPU's own */
}

static void check(bool es)
{
    struct support_log log;
    struct dpl_gl *gl = support_gl_of_floats(es, support_log_start(&log));
    struct surfaces surfaces = {0};
    struct water_memory memory = {0};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        struct wave waves[WATER_WAVES_MAX];
        struct dpl_scene *scene = support_scene(scenes[i], &log.log);
        support_set(scene, "water.model", "ocean");
        struct water_setup setup = scene_water_setup(scene, waves);
        const struct water_model *model = water_models[scene->medium.model];
        setup.memory = &memory;
        for (int k = 0; k < 2; k++) {
            gpu_enter(gl);
            assert_true(water_prepare(model, &setup, k * 1e4, &log.log));
            assert_true(surface_gpu_evaluate(gl, &surfaces.textures, model, &setup, k * 1e4));
            assert_true(surface_gpu_read(gl, &surfaces.textures, &surfaces.gpu));
            assert_true(water_evaluate(model, &setup, k * 1e4, &surfaces.cpu, &log.log));
            expect_same(&surfaces);
            assert_true(gpu_check(gl));
        }
        dpl_scene_destroy(scene);
    }
    assert_int_equal(log.errors, 0);
    surface_finish(&surfaces.cpu);
    surface_finish(&surfaces.gpu);
    surface_gpu_finish(gl, &surfaces.textures);
    water_memory_finish(&memory, gl);
    gpu_leave(gl, 0);
    dpl_gl_destroy(gl);
}

static void the_sea_is_that_of_the_cpu(void **state)
{
    (void)state;
    check(false);
}

static void the_sea_is_that_of_the_cpu_in_es(void **state)
{
    (void)state;
    check(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_sea_is_that_of_the_cpu),
        cmocka_unit_test(the_sea_is_that_of_the_cpu_in_es),
    };
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
