/* The receivers of a scene: heights of the slices below the water and above it, and the squares that their maps show.
 */
#include "support.h"

#include "scene/scene.h"

static const char text[] = "[scene]\nsize = 3\ndepth = 2\n[water]\nior = 1.4\n[sun]\nelevation = 40\nazimuth = 110\n"
                           "[caustics]\nslices = 4\nreflected_slices = 5\nreflected_height = 2.5\nmargin = 0.25\n"
                           "window = light\n";

static void slices_stand_at_even_steps(void **state)
{
    (void)state;
    struct support_log log;
    struct dpl_scene *scene = support_scene(text, support_log_start(&log));
    double heights[LIGHT_SLICES_MAX];
    assert_int_equal(scene_receivers(scene, heights), 4);
    for (int k = 0; k < 4; k++)
        assert_true(fabs(heights[k] + 2 - 0.5 * k) < 1e-12);
    assert_int_equal(scene_reflected(scene, heights), 5);
    for (int k = 0; k < 5; k++)
        assert_true(fabs(heights[k] - 0.5 * (k + 1)) < 1e-12);
    support_set(scene, "caustics.reflected_slices", "0");
    assert_int_equal(scene_reflected(scene, heights), 0);
    support_set(scene, "caustics.reflected_slices", "%d", LIGHT_SLICES_MAX);
    assert_int_equal(scene_reflected(scene, heights), LIGHT_SLICES_MAX);
    assert_true(fabs(heights[LIGHT_SLICES_MAX - 1] - 2.5) < 1e-12);
    dpl_scene_destroy(scene);
    assert_int_equal(log.errors, 0);
}

/* Of periodic water the map is the tile; of bounded water it lies where the sun's light falls: away from the sun by
 * the tangent of its angle, in the water by Snell's law, and as far above it where it is thrown back. */
static void windows_follow_the_light(void **state)
{
    (void)state;
    struct support_log log;
    struct dpl_scene *scene = support_scene(text, support_log_start(&log));
    const double heights[] = {-2, -0.5, 0.5, 2.5}, outside = 50 * M_PI / 180, azimuth = 110 * M_PI / 180;
    struct ray_window windows[4];
    scene_windows(scene, true, heights, 4, windows);
    for (int k = 0; k < 4; k++)
        assert_true(windows[k].x == -1.5 && windows[k].z == -1.5 && windows[k].side == 3);
    scene_windows(scene, false, heights, 4, windows);
    for (int k = 0; k < 4; k++) {
        double along = fabs(heights[k]) * tan(heights[k] < 0 ? asin(sin(outside) / 1.4) : outside);
        assert_true(fabs(windows[k].side - 4.5) < 1e-12);
        assert_true(fabs(windows[k].x + 2.25 + along * cos(azimuth)) < 1e-9);
        assert_true(fabs(windows[k].z + 2.25 + along * sin(azimuth)) < 1e-9);
    }
    support_set(scene, "caustics.window", "tile");
    scene_windows(scene, false, heights, 4, windows);
    for (int k = 0; k < 4; k++)
        assert_true(windows[k].x == -2.25 && windows[k].z == -2.25);
    dpl_scene_destroy(scene);
    assert_int_equal(log.errors, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slices_stand_at_even_steps),
        cmocka_unit_test(windows_follow_the_light),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
