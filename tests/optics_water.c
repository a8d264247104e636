/* What water does to light: scattering, the types of water, and that all that reads the water's absorption goes by its
 * type. */
#include "support.h"

#include "optics/phase.h"
#include "scene/scene.h"

static void expect_near(double value, double wanted, double tolerance)
{
    if (!(fabs(value - wanted) <= tolerance))
        fail_msg("%.12g instead of %.12g", value, wanted);
}

/* All of the light goes somewhere, and its mean cosine is the anisotropy (Henyey & Greenstein 1941). */
static void scattered_light_is_all_there(void **state)
{
    const int steps = 200000;
    (void)state;
    for (double g = -0.95; g < 0.96; g += 0.19) {
        double sum = 0, mean = 0, back = 0;
        for (int i = 0; i < steps; i++) {
            double cosine = 2 * (i + 0.5) / steps - 1, share = 2 * M_PI * optics_phase(cosine, g) * 2 / steps;
            sum += share;
            mean += cosine * share;
            back += cosine < 0 ? share : 0;
        }
        expect_near(sum, 1, 1e-5);
        expect_near(mean, g, 1e-5);
        expect_near(optics_phase_backward(g), back, 1e-5);
    }
    expect_near(optics_phase(0.3, 0), 1 / (4 * M_PI), 1e-15);
    expect_near(optics_phase(1, 0.5) / optics_phase(-1, 0.5), 27, 1e-12); /* ((1 + g) / (1 - g))³ */
}

/* A share u lies below the cosine of u. */
static void scattering_is_sampled_as_it_is(void **state)
{
    (void)state;
    for (double g = -0.9; g < 0.95; g += 0.3) {
        expect_near(optics_phase_cosine(0, g), -1, 1e-9);
        expect_near(optics_phase_cosine(1, g), 1, 1e-9);
        for (double u = 0.001; u < 0.999; u += 0.001) {
            double low = optics_phase_cosine(u - 5e-4, g), high = optics_phase_cosine(u + 5e-4, g);
            double middle = optics_phase((low + high) / 2, g) * 2 * M_PI * (high - low);
            expect_near(middle, 1e-3, 1.5e-5);
        }
    }
    expect_near(optics_phase_cosine(0.25, 0), -0.5, 1e-12);
}

/* Attenuation of daylight with depth at 625, 550 and 450 nm: Austin & Petzold 1984, and Jerlov 1976 from coastal-3 on.
 */
static const struct {
    const char *name;
    double daylight[3]; /* 1/m */
} jerlov[] = {
    {"oceanic-I", {0.3174, 0.0640, 0.0176}},   {"oceanic-IA", {0.3206, 0.0674, 0.0257}},
    {"oceanic-IB", {0.3245, 0.0715, 0.0355}},  {"oceanic-II", {0.3389, 0.0863, 0.0714}},
    {"oceanic-III", {0.3655, 0.1139, 0.1381}}, {"coastal-1", {0.3922, 0.1415, 0.2048}},
    {"coastal-3", {0.40, 0.19, 0.39}},         {"coastal-5", {0.48, 0.30, 0.56}},
    {"coastal-7", {0.54, 0.46, 0.89}},         {"coastal-9", {0.65, 0.63, 1.60}},
};

static void daylight_fades_as_jerlov_measured(void **state)
{
    struct support_log log;
    struct dpl_scene *scene = support_scene("", support_log_start(&log));
    (void)state;
    support_set(scene, "water.type", "pure");
    struct optics_water pure = water_optics(&scene->medium);
    expect_near(pure.absorption[2], 0.00922, 1e-9); /* Pope & Fry 1997, table 3 */
    expect_near(pure.anisotropy, 0, 1e-9);
    for (size_t i = 0; i < sizeof jerlov / sizeof *jerlov; i++) {
        support_set(scene, "water.type", jerlov[i].name);
        struct optics_water water = water_optics(&scene->medium);
        for (int c = 0; c < 3; c++) {
            double a = water.absorption[c], b = water.scattering[c];
            double kirk = sqrt(a * a + (0.425 - 0.19) * a * b); /* Kirk 1984, eq. 10, sun overhead */
            assert_true(fabs(kirk / jerlov[i].daylight[c] - 1) < 0.13);
            assert_true(a >= pure.absorption[c] && b > 0);
        }
        assert_true(water.scattering[2] > water.scattering[1] && water.scattering[1] > water.scattering[0]);
        assert_true(water.anisotropy >= 0 && water.anisotropy <= scene->medium.anisotropy);
    }
    dpl_scene_destroy(scene);
    assert_int_equal(log.errors, 0);
}

/* `custom` is what stands in the scene, whatever the type was before. */
static void custom_water_has_its_own_numbers(void **state)
{
    struct support_log log;
    struct dpl_scene *scene =
        support_scene("[water]\nabsorption = 1 2 3\nscattering = 4 5 6\nanisotropy = 0.5\n", support_log_start(&log));
    (void)state;
    for (int type = 0; type < 2; type++) {
        struct optics_water water = water_optics(&scene->medium);
        for (int c = 0; c < 3; c++) {
            expect_near(water.absorption[c], c + 1, 0);
            expect_near(water.scattering[c], c + 4, 0);
        }
        expect_near(water.anisotropy, 0.5, 0);
        support_set(scene, "water.type", "coastal-9");
        assert_true(water_optics(&scene->medium).absorption[0] < 1);
        support_set(scene, "water.type", "custom");
    }
    dpl_scene_destroy(scene);
}

/* The map of every physical technique with a CPU path is the same for a type as for the type's numbers given, and not
 * that of other water. */
static void light_goes_by_the_type(void **state)
{
    static const char text[] = "[scene]\nsize = 2\ndepth = 3\n[wave.1]\namplitude = 0.02\ncycles = 1 1\n"
                               "[wave.2]\namplitude = 0.03\n[caustics]\nmap = 32\nmesh = 32\n";
    static const char *const waters[] = {"oceanic-IB", "coastal-7", "custom"};
    (void)state;
    for (int t = 0; light_techniques[t]; t++) {
        struct support_log log;
        struct dpl_scene *scene = support_scene(text, support_log_start(&log));
        struct dpl_renderer *renderer = dpl_renderer_create(NULL, DPL_DEVICE_CPU, &log.log);
        struct dpl_image *maps[3] = {NULL};
        if (light_techniques[t]->physical && light_techniques[t]->trace && light_techniques[t]->channels == 3 &&
            strcmp(light_techniques[t]->name, "reference")) {
            support_set(scene, "caustics.technique", light_techniques[t]->name);
            for (int w = 0; w < 3; w++) {
                support_set(scene, "water.type", waters[w]);
                if (w == 2)
                    support_set(scene, "water.absorption", "0.359 0.258 0.578"); /* of coastal-7 */
                maps[w] = dpl_renderer_map(renderer, scene, 0);
                assert_non_null(maps[w]);
            }
            assert_memory_equal(maps[1]->pixels, maps[2]->pixels, 32 * 32 * 3 * sizeof(float));
            assert_memory_not_equal(maps[0]->pixels, maps[1]->pixels, 32 * 32 * 3 * sizeof(float));
        }
        for (int w = 0; w < 3; w++)
            dpl_image_destroy(maps[w]);
        dpl_renderer_destroy(renderer);
        dpl_scene_destroy(scene);
        assert_int_equal(log.errors, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scattered_light_is_all_there),
        cmocka_unit_test(scattering_is_sampled_as_it_is),
        cmocka_unit_test(daylight_fades_as_jerlov_measured),
        cmocka_unit_test(custom_water_has_its_own_numbers),
        cmocka_unit_test(light_goes_by_the_type),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
