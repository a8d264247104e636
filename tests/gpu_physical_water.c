/* What the water of the physical look does to light, in OpenGL 3.3 and OpenGL ES 3.0: colours against depth and
 * distance, light that is scattered, shafts and their shadows; against closed forms. */
#include "physical.h"

#include "optics/phase.h"

#define ABSORPTION "[water]\nabsorption = 0.35 0.07 0.03\n"

/* Irradiance of the sun across its rays just below flat water. */
static void sun_below(const struct dpl_scene *scene, double irradiance[3])
{
    double outside = (90 - scene->sun.elevation) * PHYSICAL_DEGREE, inside = physical_inside(outside);
    physical_sun(scene, irradiance);
    for (int c = 0; c < 3; c++)
        irradiance[c] *= cos(outside) * (1 - physical_reflectance(outside, inside)) / cos(inside);
}

/* A white plate straight below the eye, deeper and deeper: the light goes down and up again. What the water throws back
 * of it is under 0.3 %. */
static void check_depths(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(
        fixture, ABSORPTION "[scene]\ndepth = 6\n[floor]\ncolor = 0 0 0\n[object.plate]\nshape = box\non_floor = no\n"
                            "size = 0.4 0.02 0.4\ncolor = 0.8 0.8 0.8\n");
    double below[3];
    sun_below(scene, below);
    for (double depth = 0.5; depth < 5; depth *= 2) {
        support_set(scene, "object.plate.position", "0 %g 0", -depth - 0.02);
        physical_look_down(scene, 0, 0, 0.2);
        struct dpl_image *image = physical_radiance(fixture, scene, 8, 8);
        for (int c = 0; c < 3; c++) {
            double expected = 0.8 / M_PI * below[c] * exp(-scene->medium.absorption[c] * (2 * depth - 0.02));
            double found = physical_mean(image, c);
            if (fabs(found / expected - 1) > 0.01)
                fail_msg("depth %g, channel %d: %g, not %g", depth, c, found, expected);
        }
        dpl_image_destroy(image);
    }
    dpl_scene_destroy(scene);
}

/* A wall from farther and farther away, level: its own light is the same each time. */
static void check_distances(struct physical_fixture *fixture)
{
    struct dpl_scene *scene =
        physical_scene(fixture, ABSORPTION "[sun]\nelevation = 40\nazimuth = 90\n[floor]\ncolor = 0 0 0\n"
                                           "[object.wall]\nshape = box\nposition = 0 0 -0.1\nsize = 2 0.9 0.2\n"
                                           "color = 0.8 0.8 0.8\n");
    double first[3] = {0};
    for (double way = 1; way < 10; way *= 2) {
        physical_look(scene, (const double[3]){0, -0.5, way}, (const double[3]){0, -0.5, 0}, 2);
        struct dpl_image *image = physical_radiance(fixture, scene, 8, 8);
        for (int c = 0; c < 3; c++) {
            double found = physical_mean(image, c) * exp(scene->medium.absorption[c] * way);
            first[c] = way == 1 ? found : first[c];
            if (fabs(found / first[c] - 1) > 0.005)
                fail_msg("%g m away, channel %d: %g, not %g", way, c, found, first[c]);
        }
        dpl_image_destroy(image);
    }
    double below[3], inside = physical_inside(50 * PHYSICAL_DEGREE);
    sun_below(scene, below);
    for (int c = 0; c < 3; c++) {
        double expected = 0.8 / M_PI * below[c] * sin(inside) * exp(-scene->medium.absorption[c] * 0.5 / cos(inside));
        if (fabs(first[c] / expected - 1) > 0.005)
            fail_msg("the wall, channel %d: %g, not %g", c, first[c], expected);
    }
    dpl_scene_destroy(scene);
}

#define MURKY                                                                                                          \
    "[water]\nabsorption = 0.5 0.5 0.5\nscattering = 0.2 0.2 0.2\nanisotropy = 0.5\n[floor]\ncolor = 0 0 0\n"          \
    "[scene]\nsize = 1\n"
#define WAVES                                                                                                          \
    "[wave.1]\ncycles = 2 0\namplitude = 0.02\n[wave.2]\ncycles = 0 1\namplitude = 0.02\n[caustics]\nslices = 6\n"

/* Level, between surface and floor. */
static struct dpl_image *look_level(struct physical_fixture *fixture, struct dpl_scene *scene, bool shafts,
                                    const double eye[3], double view)
{
    physical_look(scene, eye, (const double[3]){eye[0] + 0.2, eye[1], eye[2] - 2}, view);
    support_set(scene, "look.physical.shafts", shafts ? "yes" : "no");
    return physical_radiance(fixture, scene, 96, 64);
}

/* Shafts redistribute light: over places all over the tile the mean stays, while pixels differ. */
static void check_shafts(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(fixture, MURKY WAVES);
    double with_sum = 0, without_sum = 0, square = 0;
    support_set(scene, "sun.elevation", "70");
    for (int i = 0; i < 4; i++) {
        const double place[3] = {0.125 * i, -0.5, 0.25 * i};
        struct dpl_image *with = look_level(fixture, scene, true, place, 20);
        struct dpl_image *without = look_level(fixture, scene, false, place, 20);
        with_sum += physical_mean(with, 1);
        without_sum += physical_mean(without, 1);
        for (int p = 0; p < with->width * with->height; p++)
            square +=
                pow((double)(with->pixels[3 * p + 1] - without->pixels[3 * p + 1]), 2) / (with->width * with->height);
        dpl_image_destroy(with);
        dpl_image_destroy(without);
    }
    if (fabs(with_sum / without_sum - 1) > 0.01 || sqrt(square / 4) < 0.05 * without_sum / 4)
        fail_msg("shafts: the mean %g, not %g; pixels differ by %g", with_sum / 4, without_sum / 4, sqrt(square / 4));
    dpl_scene_destroy(scene);
}

/* For each unit of the sun's irradiance, straight down, the radiance of a level sight without end at half a metre's
 * depth in MURKY: as render/volume.glsl says, summed up in steps. */
static double murky_glow(void)
{
    double sum = 0, step = 1e-3;
    for (double way = 0.5 + step / 2; way < 40; way += step) {
        double x = 0.2 * way, share = (1 - exp(-x)) / x;
        sum += 0.2 * share * optics_phase(0, pow(0.5, 1 / share)) * exp(-0.5 * way) * step;
    }
    return sum;
}

/* Under a raft that covers all of the sight there is no scattered sun; without shafts nothing says so. */
static void check_raft(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(
        fixture, MURKY "[object.raft]\nshape = box\non_floor = no\nposition = 0 -0.1 0\nsize = 24 0.02 24\n");
    const double place[3] = {0, -0.5, 0};
    struct dpl_image *with = look_level(fixture, scene, true, place, 4);
    struct dpl_image *without = look_level(fixture, scene, false, place, 4);
    double below[3];
    sun_below(scene, below);
    double expected = below[1] * murky_glow();
    double found = physical_mean(without, 1) - physical_mean(with, 1);
    if (fabs(found / expected - 1) > 0.01)
        fail_msg("a raft takes %g of the scattered light, not %g", found, expected);
    dpl_image_destroy(with);
    dpl_image_destroy(without);
    dpl_scene_destroy(scene);
}

static void check(bool es)
{
    struct physical_fixture fixture;
    physical_start(&fixture, es);
    check_depths(&fixture);
    check_distances(&fixture);
    check_shafts(&fixture);
    check_raft(&fixture);
    physical_finish(&fixture);
}

static void the_water_takes_light(void **state)
{
    (void)state;
    check(false);
}

static void the_water_takes_light_in_es(void **state)
{
    (void)state;
    check(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_water_takes_light),
                                       cmocka_unit_test(the_water_takes_light_in_es)};
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
