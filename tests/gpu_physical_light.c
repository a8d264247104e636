/* The physical look's light, in OpenGL 3.3 and OpenGL ES 3.0: how bright the floor is against closed forms, for a sun
 * from near the horizon to overhead; that caustics take no light away; colours against depth; shafts; the same bytes
 * twice. */
#include "physical.h"

#define SIDE 48 /* pixels */

/* Near the focus: this wave alone has it 1.2 m deep. */
static const char waves[] = "[scene]\nsize = 1\n[wave.1]\ncycles = 2 0\namplitude = 0.02\nphase = 30\n"
                            "[wave.2]\ncycles = 0 1\namplitude = 0.02\n[caustics]\nmap = 256\n";

/* Brightness of the floor under flat water from 5° to 90°: what enters, what is left of it, what the water throws back.
 */
static void check_flat_floor(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(fixture, "[water]\nabsorption = 0.35 0.07 0.03\n");
    physical_look_down(scene, 0.1, -0.2, 0.1);
    for (int elevation = 5; elevation <= 90; elevation += 5) {
        support_set(scene, "sun.elevation", "%d", elevation);
        support_set(scene, "sun.azimuth", "%d", 4 * elevation);
        struct dpl_image *image = physical_radiance(fixture, scene, 8, 8);
        for (int c = 0; c < 3; c++) {
            double way = exp(-scene->medium.absorption[c] * (scene->settings.depth - 0.02));
            double expected = physical_floor(scene, c) * way, found = physical_mean(image, c);
            print_message("%d %d %g %g %g\n", elevation, c, expected, found, found / expected - 1);
        }
        dpl_image_destroy(image);
    }
    dpl_scene_destroy(scene);
}

static void check_energy(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(fixture, waves);
    physical_look_down(scene, 0, 0, 1);
    for (int elevation = 5; elevation <= 90; elevation += 5) {
        support_set(scene, "sun.elevation", "%d", elevation);
        support_set(scene, "look.physical.caustics", "yes");
        struct dpl_image *with = physical_radiance(fixture, scene, 128, 128);
        support_set(scene, "look.physical.caustics", "no");
        struct dpl_image *without = physical_radiance(fixture, scene, 128, 128);
        print_message("%d: %g %g: %g, %g %g\n", elevation, physical_mean(with, 1), physical_mean(without, 1),
                      physical_mean(with, 1) / physical_mean(without, 1) - 1, physical_contrast(with),
                      physical_contrast(without));
        dpl_image_destroy(with);
        dpl_image_destroy(without);
    }
    dpl_scene_destroy(scene);
}

static void check(bool es)
{
    struct physical_fixture fixture;
    physical_start(&fixture, es);
    check_flat_floor(&fixture);
    check_energy(&fixture);
    physical_finish(&fixture);
}

static void light_is_right(void **state)
{
    (void)state;
    check(false);
}

static void light_is_right_in_es(void **state)
{
    (void)state;
    check(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(light_is_right), cmocka_unit_test(light_is_right_in_es)};
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
