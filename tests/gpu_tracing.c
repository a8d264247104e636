/* photons, beams and hemisphere on the GPU against the CPU, which sends the same rays, in OpenGL 3.3 and in OpenGL ES
 * 3.0. */
#include "support.h"

#include <math.h>

#define MAP 40

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
    fixture->on_gpu = dpl_renderer_create(fixture->gl, DPL_DEVICE_GL, log);
    fixture->on_cpu = dpl_renderer_create(NULL, DPL_DEVICE_CPU, log);
}

static void finish(struct fixture *fixture)
{
    assert_int_equal(fixture->log.errors, 0);
    dpl_renderer_destroy(fixture->on_gpu);
    dpl_renderer_destroy(fixture->on_cpu);
    dpl_gl_destroy(fixture->gl);
}

/* The RMS of the difference in units of the CPU's map's own. */
static double error_of(struct fixture *fixture, int slice)
{
    struct dpl_image *gpu = dpl_renderer_slice(fixture->on_gpu, fixture->scene, 1, slice);
    struct dpl_image *cpu = dpl_renderer_slice(fixture->on_cpu, fixture->scene, 1, slice);
    double errors = 0, squares = 0;
    if (!gpu || !cpu)
        fail_msg("%s", fixture->log.text);
    for (int i = 0; i < MAP * MAP * 3; i++) {
        errors += pow((double)gpu->pixels[i] - (double)cpu->pixels[i], 2);
        squares += pow((double)cpu->pixels[i], 2);
    }
    dpl_image_destroy(gpu);
    dpl_image_destroy(cpu);
    return squares > 0 ? sqrt(errors / squares) : INFINITY;
}

/* Where they may differ: half floats, rays near the edge of a texel or of the lamp, and for beams thin triangles near a
 * texel's centre. */
struct expectation {
    const char *technique, *settings; /* further scene text */
    double error;
};

static const struct expectation expectations[] = {
    {"photons", "[photons]\ncount = 8\n", 0.005},
    {"photons", "[photons]\ncount = 8\nspread = bilinear\n", 0.005},
    {"beams", "", 0.02},
    {"hemisphere", "[hemisphere]\ncandidates = 64\nlamp = 3\ncone = 12\n", 0.015},
};

static const char water[] = "[scene]\nsize = 2\ndepth = 0.6\n[wave.1]\ncycles = 2 1\namplitude = 0.03\n"
                            "[wave.2]\ncycles = -1 3\namplitude = 0.01\n[caustics]\nmap = 40\nmesh = 50\n";
static const char *const scenes[] = {
    "[sun]\nelevation = 50\nazimuth = 200\n[caustics]\nslices = 2\n",
    "[sun]\nazimuth = 110\n[water]\ndispersion = 0.1\n[caustics]\nmesh = 33\n",
    "[caustics]\nceiling = 0.4\n[water]\ndispersion = 1e-17\n", /* so little that colours stay together */
    "[water]\nmodel = collard\n[sun]\nelevation = 40\n[caustics]\nwindow = light\nmargin = 0.2\n",
};

static void check(bool es)
{
    struct fixture fixture;
    start(&fixture, es);
    for (size_t s = 0; s < sizeof scenes / sizeof *scenes; s++) {
        for (size_t i = 0; i < sizeof expectations / sizeof *expectations; i++) {
            const struct expectation *e = expectations + i;
            char text[1024];
            snprintf(text, sizeof text, "%s%s%s", water, scenes[s], e->settings);
            fixture.scene = support_scene(text, &fixture.log.log);
            support_set(fixture.scene, "caustics.technique", "%s", e->technique);
            double error = error_of(&fixture, s == 0 ? 1 : 0);
            if (!(error < e->error))
                fail_msg("%s in scene %d: off by %.4f", e->technique, (int)s, error);
            dpl_scene_destroy(fixture.scene);
        }
    }
    finish(&fixture);
}

static void maps_are_those_of_the_cpu(void **state)
{
    (void)state;
    check(false);
}

static void maps_are_those_of_the_cpu_in_es(void **state)
{
    (void)state;
    check(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(maps_are_those_of_the_cpu),
        cmocka_unit_test(maps_are_those_of_the_cpu_in_es),
    };
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
