/* The technique `coverage` on the CPU with the sun's disc: against the plain sum of tests/coverage.h over many places
 * of the disc, and against the reference. */
#include "coverage_cpu.h"

#include <math.h>

#define SUNS 150

/* The mean over places of the disc, each of which counts by what it gives to flat water. */
static double *many_suns(const struct fixture *fixture, int color)
{
    const struct optics_disc disc = optics_sun_disc(&fixture->sun);
    double *map = empty_map(fixture->map.side), share[SUNS], total = 0, up[3] = {0, 1, 0}, out[3] = {0};
    struct coverage_case c = plain_case(fixture, 0, color);
    for (int pass = 0; pass < 2; pass++) {
        for (int s = 0; s < SUNS; s++) { /* Vogel 1979: evenly over a disc */
            double r = sqrt((s + 0.5) / SUNS), angle = s * 2.399963229728653;
            optics_disc_place(&disc, (const double[2]){r * cos(angle), r * sin(angle)}, c.sun);
            if (pass == 0) {
                share[s] = coverage_bend(&c, up, out) * c.sun[1];
                share[s] *= exp(c.receiver > 0 ? 0 : -c.absorption * c.receiver / out[1]);
                total += share[s];
            } else {
                coverage_map(&c, share[s] / total, map);
            }
        }
    }
    return map;
}

struct expectation {
    double elevation, radius; /* degrees */
    double receiver, steepness;
    double chosen, finer; /* accepted errors where 1 % and 0.25 % are wanted */
};

/* Detail is chosen before anything is traced: accepted is a fifth more than what was measured, up to 2.5 times the
 * wanted error, and more where narrow errors are wanted from wide or low suns. With all detail there is, what is left
 * is that a footprint is one ellipse, and that 150 places are not a disc. */
static void a_disc_is_many_suns(void **state)
{
    static const struct expectation expectations[] = {
        {90, 0.2665, -2, 0.08, 0.0055, 0.0076}, {60, 0.2665, -3, 0.08, 0.0065, 0.003},
        {30, 0.2665, -3, 0.08, 0.0091, 0.0048}, {50, 1.5, -2, 0.08, 0.0173, 0.0106},
        {30, 2, -2, 0.06, 0.025, 0.0117},       {60, 0.2665, 0.7, 0.06, 0.0021, 0.0048},
    };
    static const double wanted_errors[] = {1, 0.25, 1, 1}; /* per cent */
    static const struct coverage params[] = {{0}, {0}, {COVERAGE_FINENESS_MAX, 5}, {1, 1}};
    struct fixture *fixture = *state;
    for (size_t i = 0; i < sizeof expectations / sizeof *expectations; i++) {
        const struct expectation *e = expectations + i;
        make_random(fixture, i < 3 ? 30 + i : 32 + i, 4, e->steepness, 72, true);
        fixture->sun = (struct optics_sun){.elevation = e->elevation, .azimuth = 110, .angular_radius = e->radius};
        fixture->receivers[0] = e->receiver;
        assert_true(light_map_resize(&fixture->map, 64, 3, 1, NULL));
        double *wanted = many_suns(fixture, 1), errors[4];
        for (int k = 0; k < 4; k++) {
            fixture->settings.error = wanted_errors[k];
            fixture->params = params[k];
            trace(fixture, 64, 1);
            errors[k] = error_of(fixture, 0, 1, wanted);
        }
        if (!(errors[0] < e->chosen && errors[1] < e->finer && errors[2] < 0.01 && errors[3] > 1.5 * errors[2]))
            fail_msg("case %zu: errors %g chosen for 1 %%, %g for 0.25 %%, %g with all, %g with least", i, errors[0],
                     errors[1], errors[2], errors[3]);
        free(wanted);
    }
}

/* Three waves halfway to their focus with the detail that is chosen for 1 %, and near it with all detail, where a disc
 * of a sixth of a texel asks for it: both below 1 %, the noise taken out. In colours; the mesh of 256 leaves 1e-3. */
static void a_map_is_the_reference_s(void **state)
{
    struct fixture *fixture = *state;
    const struct dpl_log *log = &fixture->log.log;
    struct dpl_renderer *renderer = dpl_renderer_create(NULL, DPL_DEVICE_CPU, log);
    struct dpl_scene *scene =
        support_scene("[scene]\nsize = 2\ndepth = 2\n[water]\nmodel = sines\ndispersion = 0.02\n"
                      "[wave.1]\ncycles = 2 1\namplitude = 0.02\n[wave.2]\ncycles = -1 3\namplitude = 0.01\n"
                      "[wave.3]\ncycles = 5 -2\namplitude = 0.003\n"
                      "[caustics]\nmap = 48\nmesh = 256\ntechnique = coverage\n[reference]\nphotons = 800\n",
                      log);
    for (int k = 0; k < 2; k++) {
        struct dpl_measure measure;
        support_set(scene, "scene.depth", "%d", k + 1);
        support_set(scene, "coverage.fineness", "%d", k == 0 ? 0 : COVERAGE_FINENESS_MAX);
        support_set(scene, "caustics.technique", "coverage");
        struct dpl_image *map = dpl_renderer_map(renderer, scene, 1);
        support_set(scene, "caustics.technique", "reference");
        struct dpl_image *reference = dpl_renderer_map(renderer, scene, 1);
        assert_true(map && reference);
        double noise = dpl_renderer_noise(renderer);
        assert_true(dpl_measure_map(map, reference, false, noise, &measure, log));
        if (!(noise > 0 && noise < 0.03 && measure.error < 0.01 && fabs(measure.energy - 1) < 1e-4))
            fail_msg("noise %g, error %g, energy %g", noise, measure.error, measure.energy);
        dpl_image_destroy(map);
        dpl_image_destroy(reference);
    }
    dpl_scene_destroy(scene);
    dpl_renderer_destroy(renderer);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_disc_is_many_suns, setup, teardown),
        cmocka_unit_test_setup_teardown(a_map_is_the_reference_s, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
