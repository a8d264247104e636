/* The paper's waves and normals against the same formulas written a second time (tests/collard.h). */
#include "support.h"

#include "collard.h"
#include "scene/scene.h"

struct fixture {
    struct dpl_scene *scene;
    struct surface surface;
    struct wave waves[WATER_WAVES_MAX];
    double heights[COLLARD_SIDE * COLLARD_SIDE];
    double normals[COLLARD_SIDE * COLLARD_SIDE][3];
};

static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    fixture->scene = support_scene("[scene]\nsize = 4\n[water]\nmodel = collard\n", NULL);
    *state = fixture;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *fixture = *state;
    surface_finish(&fixture->surface);
    dpl_scene_destroy(fixture->scene);
    free(fixture);
    return 0;
}

static void evaluate(struct fixture *fixture, double time)
{
    struct water_setup water = scene_water_setup(fixture->scene, fixture->waves);
    const struct water_model *model = water_models[fixture->scene->medium.model];
    assert_true(water_evaluate(model, &water, time, &fixture->surface, NULL));
}

static void set_preset(struct fixture *fixture, int preset, double time)
{
    const struct collard_preset *values = collard_presets + preset - 1;
    support_set(fixture->scene, "collard.wave", "preset-%d", preset);
    support_set(fixture->scene, "collard.amplitude", "%.17g", values->amplitude);
    support_set(fixture->scene, "collard.frequency", "%.17g", values->frequency);
    evaluate(fixture, time);
    collard_heights(preset, values->amplitude, values->frequency, time, fixture->heights);
}

static void numbers_of_vertices_are_those_of_the_mesh_file(void **state)
{
    (void)state;
    static int numbers[COLLARD_SIDE][COLLARD_SIDE];
    collard_numbers(numbers);
    assert_int_equal(numbers[160][1], 4); /* x = -1.975, z = 2 */
    assert_int_equal(numbers[160][159], 162);
    assert_int_equal(numbers[0][159], 163);
    assert_int_equal(numbers[0][1], 321);
    assert_int_equal(numbers[1][0], 322);
    assert_int_equal(numbers[159][160], 481);
    for (int c = 0; c < 159; c += 79)
        for (int r = 0; r < 159; r += 79)
            assert_int_equal(numbers[159 - r][1 + c], 640 + 159 * c + r);
}

static void heights_are_those_of_the_formulas(void **state)
{
    static const double times[] = {0, 1, 2.6, 7.3, 20, 100};
    struct fixture *fixture = *state;
    for (int preset = 1; preset <= 4; preset++) {
        for (size_t k = 0; k < sizeof times / sizeof *times; k++) {
            double most = 0;
            set_preset(fixture, preset, times[k]);
            for (int i = 0; i < COLLARD_SIDE * COLLARD_SIDE; i++) {
                double difference = fabs((double)fixture->surface.texels[i * 3] - fixture->heights[i]);
                /* single precision of numbers up to 0.2 */
                if (difference > 1e-8)
                    fail_msg("preset %d, time %g, vertex %d: %.9g instead of %.9g", preset, times[k], i,
                             (double)fixture->surface.texels[i * 3], fixture->heights[i]);
                most = fmax(most, fabs(fixture->heights[i]));
            }
            assert_true(most > 0.1 * collard_presets[preset - 1].amplitude * (preset == 1 ? 0.5 : 0.99));
        }
    }
}

static void figures_two_and_three_have_their_waves(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "collard.amplitude", "0.1");
    support_set(fixture->scene, "collard.frequency", "3");
    for (int figure = 2; figure <= 3; figure++) {
        support_set(fixture->scene, "collard.wave", figure == 2 ? "radial" : "ripple");
        evaluate(fixture, 1.25);
        for (int i = 0; i < COLLARD_SIDE * COLLARD_SIDE; i++) {
            double x = i % COLLARD_SIDE * 0.025 - 2, z = i / COLLARD_SIDE * 0.025 - 2, u = 3 * x + 1.25;
            double wanted = figure == 2 ? 0.1 * sin(-3.14159 * sqrt(x * x + z * z) * 3 + 1.25)
                                        : 0.1 * (sin(2 * u) + sin(M_PI * u)) / 2;
            assert_true(fabs((double)fixture->surface.texels[i * 3] - wanted) < 1e-8);
        }
    }
}

/* Units scale time, and all lengths together. */
static void units_scale_the_picture(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "scene.size", "10");
    support_set(fixture->scene, "collard.space_unit", "2.5");
    support_set(fixture->scene, "collard.time_unit", "0.5");
    for (int preset = 1; preset <= 4; preset++) {
        set_preset(fixture, preset, 3.5);
        collard_heights(preset, collard_presets[preset - 1].amplitude, collard_presets[preset - 1].frequency, 7,
                        fixture->heights);
        for (int i = 0; i < COLLARD_SIDE * COLLARD_SIDE; i++)
            assert_true(fabs((double)fixture->surface.texels[i * 3] - 2.5 * fixture->heights[i]) < 2.5e-8);
    }
}

static void normals_are_sums_over_the_triangles_around(void **state)
{
    struct fixture *fixture = *state;
    for (int preset = 1; preset <= 4; preset++) {
        set_preset(fixture, preset, 2.6);
        collard_normals(fixture->heights, 4, fixture->normals);
        for (int i = 0; i < COLLARD_SIDE * COLLARD_SIDE; i++) {
            const float *texel = fixture->surface.texels + i * 3;
            const double *normal = fixture->normals[i];
            /* heights in single precision, up to 0.2, divided by a spacing of 0.025 */
            assert_true(fabs((double)texel[1] + normal[0] / normal[1]) < 3e-6);
            assert_true(fabs((double)texel[2] + normal[2] / normal[1]) < 3e-6);
        }
    }
}

static void no_amplitude_is_flat(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "collard.amplitude", "0");
    for (int i = 0; i < 6; i++) {
        static const char *const waves[] = {"preset-1", "preset-2", "preset-3", "preset-4", "radial", "ripple"};
        support_set(fixture->scene, "collard.wave", "%s", waves[i]);
        evaluate(fixture, 5);
        for (int k = 0; k < COLLARD_SIDE * COLLARD_SIDE * 3; k++)
            assert_true(fixture->surface.texels[k] == 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(numbers_of_vertices_are_those_of_the_mesh_file, setup, teardown),
        cmocka_unit_test_setup_teardown(heights_are_those_of_the_formulas, setup, teardown),
        cmocka_unit_test_setup_teardown(figures_two_and_three_have_their_waves, setup, teardown),
        cmocka_unit_test_setup_teardown(units_scale_the_picture, setup, teardown),
        cmocka_unit_test_setup_teardown(normals_are_sums_over_the_triangles_around, setup, teardown),
        cmocka_unit_test_setup_teardown(no_amplitude_is_flat, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
