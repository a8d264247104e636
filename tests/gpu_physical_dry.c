/* What stands half out of the water, in the physical look, in OpenGL 3.3 and OpenGL ES 3.0: caustics on what is wet,
 * none on what is dry but those that the water throws up, none in shadow; a shadow that goes on through the surface,
 * and one in what the water throws up. */
#include "physical.h"

/* A wall from the floor to 0.6 m above the water, whose face at x = -0.5 looks at the sun. */
#define WALL                                                                                                           \
    "[sun]\nelevation = 35\nazimuth = 0\n[object.wall]\nshape = box\nposition = -0.6 0 0\nsize = 0.2 1.6 3\n"          \
    "color = 0.5 0.5 0.5\n"
#define WAVES                                                                                                          \
    "[wave.1]\ncycles = 8 0\namplitude = 0.01\n[wave.2]\ncycles = 2 7\namplitude = 0.01\n[caustics]\nslices = "        \
    "4\nmesh = 192\n"

static struct dpl_image *draw(struct physical_fixture *fixture, struct dpl_scene *scene, bool caustics)
{
    support_set(scene, "look.physical.caustics", caustics ? "yes" : "no");
    return physical_radiance(fixture, scene, 64, 64);
}

/* How much of the picture, as a share of its mean, is there with caustics only; 0: the same bytes. */
static double added(struct physical_fixture *fixture, struct dpl_scene *scene)
{
    struct dpl_image *with = draw(fixture, scene, true), *without = draw(fixture, scene, false);
    double square = 0, mean = physical_mean(without, 1);
    for (int i = 0; i < 64 * 64 * 3; i++)
        square += pow((double)(with->pixels[i] - without->pixels[i]), 2);
    dpl_image_destroy(with);
    dpl_image_destroy(without);
    return sqrt(square / (64 * 64 * 3)) / mean;
}

static void check_caustics(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(fixture, WALL WAVES);
    physical_look(scene, (const double[3]){0.8, -0.4, 0.6}, (const double[3]){-0.5, -0.4, 0}, 15);
    double wet = added(fixture, scene);
    physical_look(scene, (const double[3]){0.8, 0.4, 0.6}, (const double[3]){-0.5, 0.3, 0}, 15);
    double dry = added(fixture, scene);
    support_set(scene, "caustics.reflected_slices", "6");
    support_set(scene, "caustics.reflected_height", "0.6");
    double thrown = added(fixture, scene);
    if (wet < 0.1 || dry != 0 || thrown < 0.01 || thrown > wet)
        fail_msg("caustics: %g on what is wet, %g on what is dry, %g with light thrown up", wet, dry, thrown);
    dpl_scene_destroy(scene);
}

/* Under a raft: the sun's light and its pattern are gone; they are there where it throws no shadow. */
static void check_under_raft(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(
        fixture, WAVES "[object.raft]\nshape = box\non_floor = no\nposition = 0 -0.3 0\nsize = 1.5 0.1 1.5\n");
    physical_look_down(scene, 0, 0, 0.3);
    support_set(scene, "camera.position", "0 -0.5 0");
    double hidden = added(fixture, scene);
    support_set(scene, "object.raft.casts", "no");
    double open = added(fixture, scene);
    if (hidden > 1e-3 || open < 0.1)
        fail_msg("caustics: %g in shadow, %g without it", hidden, open);
    dpl_scene_destroy(scene);
}

/* The green at a point of the wall, as the eye sees it straight. */
static double wall_at(const struct dpl_scene *scene, const struct dpl_image *image, double y, double z)
{
    double column, row;
    physical_place(scene, image, (const double[3]){-0.5, y, z}, &column, &row);
    assert_true(column > 0 && row > 0 && column < image->width && row < image->height);
    return physical_pixel(image, (int)column, (int)row, 1);
}

/* The shadow of an upright pole on the wall is upright, as the sun's rays in the water stay in their plane: it goes on
 * where the wall gets wet. Its middle is where the sun's azimuth says. */
static void check_through_surface(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(fixture, WALL "[object.pole]\nshape = pole\nsize = 0.12 1.7 0.12\n");
    support_set(scene, "sun.azimuth", "20");
    double middle = -0.5 * tan(20 * PHYSICAL_DEGREE);
    for (int above = 0; above < 2; above++) {
        physical_look(scene, (const double[3]){0.5, above ? 0.25 : -0.25, 0.8},
                      (const double[3]){-0.5, above ? 0.1 : -0.1, -0.1}, 40);
        struct dpl_image *image = draw(fixture, scene, true);
        for (int i = 0; i < 10; i++) {
            double y = (above ? 1 : -1) * (0.012 + 0.015 * i), dark = wall_at(scene, image, y, middle);
            double left = wall_at(scene, image, y, middle - 0.13), right = wall_at(scene, image, y, middle + 0.13);
            if (dark > 0.3 * fmin(left, right) || fabs(left / right - 1) > 0.05)
                fail_msg("%g m from the surface: %g in shadow, %g and %g beside it", y, dark, left, right);
        }
        dpl_image_destroy(image);
    }
    dpl_scene_destroy(scene);
}

/* A ceiling 1 m above flat water, which throws the sun up to it, and a plate half way up; all that is lit besides is
 * as good as black. Light comes to a point of the ceiling from the water beside it, towards the sun by the height over
 * the tangent of the sun's elevation; so the plate stands half as far aside of its shadow's middle. The sun shines in
 * under the ceiling, and the plate's own shadow on the water throws none up to it. */
#define ELEVATION 50
#define AZIMUTH 30
#define PLATE 0.15                                    /* m, half its side */
static const double shadow_middle[2] = {0.08, -0.05}; /* x and z */

static struct dpl_scene *ceiling_scene(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(
        fixture, "[floor]\ncolor = 0 0 0\n[caustics]\nslices = 4\nmesh = 192\nreflected_slices = 4\n"
                 "reflected_height = 1.2\n[object.ceiling]\nshape = box\non_floor = no\nposition = 0 1 0\n"
                 "size = 1 0.1 1\ncolor = 0.1 0.1 0.1\n[object.plate]\nshape = box\non_floor = no\n"
                 "color = 0.001 0.001 0.001\n");
    double aside = 0.5 / tan(ELEVATION * PHYSICAL_DEGREE);
    support_set(scene, "sun.elevation", "%d", ELEVATION);
    support_set(scene, "sun.azimuth", "%d", AZIMUTH);
    support_set(scene, "object.plate.size", "%g 0.01 %g", 2 * PLATE, 2 * PLATE);
    support_set(scene, "object.plate.position", "%.17g 0.5 %.17g",
                shadow_middle[0] + aside * cos(AZIMUTH * PHYSICAL_DEGREE),
                shadow_middle[1] + aside * sin(AZIMUTH * PHYSICAL_DEGREE));
    physical_look(scene, (const double[3]){-0.3, 0.2, -0.3}, (const double[3]){0, 1, 0}, 100);
    return scene;
}

/* Radiance of the ceiling by what flat water throws back of the sun, by Fresnel's law. */
static double open_ceiling(const struct dpl_scene *scene)
{
    double sun[3], outside = (90 - ELEVATION) * PHYSICAL_DEGREE;
    physical_sun(scene, sun);
    return 0.1 / M_PI * sun[1] * cos(outside) * physical_reflectance(outside, physical_inside(outside));
}

/* Everywhere on the ceiling but at its rim and 6 cm around the shadow's edge, which waves are taken to blur by 4 cm. */
static void check_ceiling(const struct dpl_scene *scene, const struct dpl_image *image, bool shadowed)
{
    double open = open_ceiling(scene);
    for (int i = 0; i < 29 * 29; i++) {
        double point[3] = {(i % 29 - 14) * 0.03, 1, (i / 29 - 14) * 0.03}, column, row;
        physical_place(scene, image, point, &column, &row);
        assert_true(column > 0 && row > 0 && column < image->width && row < image->height);
        double beside = fmax(fabs(point[0] - shadow_middle[0]), fabs(point[2] - shadow_middle[1])) - PLATE;
        double found = physical_pixel(image, (int)column, (int)row, 1) / open;
        double expected = shadowed && beside < 0 ? 0 : 1;
        if (fabs(found - expected) > 0.01 && (!shadowed || fabs(beside) > 0.06))
            fail_msg("ceiling at %g, %g: %g of what flat water throws up, not %g", point[0], point[2], found, expected);
    }
}

static void check_thrown(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = ceiling_scene(fixture);
    for (int i = 0; i < 4; i++) {
        bool shadowed = i & 1;
        support_set(scene, "object.plate.casts", shadowed ? "yes" : "no");
        support_set(scene, "caustics.reflected_slices", i & 2 ? "0" : "4");
        struct dpl_image *image = physical_radiance(fixture, scene, 128, 128);
        check_ceiling(scene, image, shadowed);
        dpl_image_destroy(image);
    }
    dpl_scene_destroy(scene);
}

static void check(bool es)
{
    struct physical_fixture fixture;
    physical_start(&fixture, es);
    check_caustics(&fixture);
    check_under_raft(&fixture);
    check_through_surface(&fixture);
    check_thrown(&fixture);
    physical_finish(&fixture);
}

static void caustics_stay_below(void **state)
{
    (void)state;
    check(false);
}

static void caustics_stay_below_in_es(void **state)
{
    (void)state;
    check(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(caustics_stay_below),
                                       cmocka_unit_test(caustics_stay_below_in_es)};
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
