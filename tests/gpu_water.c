/* The water's surface from the GPU against that from the CPU, for every model that the GPU evaluates, in OpenGL 3.3 and
 * in OpenGL ES 3.0. */
#include "support.h"

#include "scene/scene.h"
#include "water/surface_gpu.h"

#include <math.h>

/* What the models are asked for, with their own defaults; the waves are of `sines`. */
static const char *const scenes[] = {
    "[caustics]\nmesh = 48\n[wave.1]\ncycles = 3 1\n[wave.2]\ncycles = -5 2\namplitude = 0.003\nphase = 50\n",
    "[scene]\nsize = 2\nloop = 3\n[caustics]\nmesh = 65\n[wave.1]\ncycles = 2 1\nsteepness = 0.5\n"
    "[wave.5]\ncycles = 0 -3\nsteepness = 0.2\n[wave.6]\ncycles = 4 4\namplitude = 0.002\n"
    "[wave.7]\ncycles = -1 6\namplitude = 0.002\nsteepness = 0.2\n[wave.8]\ncycles = 0 0\nsteepness = 1\n",
};
enum { SCENES = sizeof scenes / sizeof *scenes };

/* One side of the comparison: models that keep something keep it twice. */
struct side {
    struct water_memory memory;
    struct water_setup setup;
    struct surface surface;
};

static void start(struct side *side, const struct dpl_scene *scene, struct wave *waves)
{
    *side = (struct side){.setup = scene_water_setup(scene, waves)};
    side->setup.memory = &side->memory;
}

static void finish(struct side *side, struct dpl_gl *gl)
{
    surface_finish(&side->surface);
    water_memory_finish(&side->memory, gl);
}

/* Within 2e-5 of the largest number of the same kind: angles and sums of waves in single precision. */
static void expect_same(const float *gpu, const float *cpu, size_t count, int channels, const char *what)
{
    double most = 0, scale[2] = {0}; /* the first channel of texels is m, the others slopes */
    for (size_t i = 0; i < count; i++) {
        int kind = channels == 3 && i % 3 == 0;
        scale[kind] = fmax(scale[kind], fabs((double)cpu[i]));
    }
    for (size_t i = 0; i < count; i++) {
        int kind = channels == 3 && i % 3 == 0;
        assert_true(isfinite(gpu[i]));
        most = fmax(most, fabs((double)gpu[i] - (double)cpu[i]) / fmax(scale[kind], 1e-6));
    }
    if (most > 2e-5)
        fail_msg("%s: off by %g of the largest", what, most);
}

static void compare(const struct side *gpu, const struct side *cpu, const char *name)
{
    size_t vertices = (size_t)cpu->surface.columns * (size_t)cpu->surface.rows;
    assert_int_equal(gpu->surface.columns, cpu->surface.columns);
    assert_int_equal(gpu->surface.rows, cpu->surface.rows);
    assert_int_equal(gpu->surface.periodic, cpu->surface.periodic);
    assert_int_equal(gpu->surface.shifts != NULL, cpu->surface.shifts != NULL);
    expect_same(gpu->surface.texels, cpu->surface.texels, vertices * 3, 3, name);
    if (cpu->surface.shifts)
        expect_same(gpu->surface.shifts, cpu->surface.shifts, vertices * 2, 2, name);
}

static void check_model(struct dpl_gl *gl, const struct water_model *model, const char *text)
{
    struct dpl_scene *scene = support_scene(text, gl->log);
    struct wave waves[WATER_WAVES_MAX];
    struct surface_gpu surface = {0};
    struct side gpu, cpu;
    support_set(scene, "water.model", "%s", model->name);
    start(&gpu, scene, waves);
    start(&cpu, scene, waves);
    for (double time = 0; time < 1; time += 0.45) {
        assert_true(water_prepare(model, &cpu.setup, time, gl->log));
        assert_true(water_evaluate(model, &cpu.setup, time, &cpu.surface, gl->log));
        assert_true(water_prepare(model, &gpu.setup, time, gl->log));
        gpu_enter(gl);
        assert_true(surface_gpu_evaluate(gl, &surface, model, &gpu.setup, time));
        assert_true(surface_gpu_read(gl, &surface, &gpu.surface));
        gpu_leave(gl, 0);
        compare(&gpu, &cpu, model->name);
    }
    surface_gpu_finish(gl, &surface);
    finish(&gpu, gl);
    finish(&cpu, NULL);
    dpl_scene_destroy(scene);
}

static void check(bool es)
{
    struct support_log log;
    struct dpl_gl *gl = support_gl(es, support_log_start(&log));
    for (int i = 0; water_models[i]; i++)
        for (int k = 0; k < SCENES && surface_gpu_can_evaluate(gl, water_models[i]); k++)
            check_model(gl, water_models[i], scenes[k]);
    assert_int_equal(log.errors, 0);
    dpl_gl_destroy(gl);
}

static void surfaces_are_those_of_the_cpu(void **state)
{
    (void)state;
    check(false);
}

static void surfaces_are_those_of_the_cpu_in_es(void **state)
{
    (void)state;
    check(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(surfaces_are_those_of_the_cpu),
        cmocka_unit_test(surfaces_are_those_of_the_cpu_in_es),
    };
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
