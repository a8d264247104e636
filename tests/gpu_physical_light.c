/* The physical look's light, in OpenGL 3.3 and OpenGL ES 3.0: how bright the floor is against closed forms, for a sun
 * from near the horizon to overhead; that caustics take no light away; the same bytes twice. */
#include "physical.h"

#define SIDE 48 /* pixels */

/* Brightness of the floor under flat water from 5° to 90°: what enters, what is left of it, what the water throws back.
 * The last is traced, by few paths and with three bounces: half of it being off by 5 % is what 0.5 % allow. */
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
            if (fabs(found / expected - 1) > 0.006)
                fail_msg("sun at %d degrees, channel %d: %g, not %g", elevation, c, found, expected);
        }
        dpl_image_destroy(image);
    }
    dpl_scene_destroy(scene);
}

/* Mean radiance of a picture of side × side pixels, by the look and by the path tracer. */
static void both_looks(struct physical_fixture *fixture, struct dpl_scene *scene, int side, double means[2])
{
    for (int i = 0; i < 2; i++) {
        support_set(scene, "render.look", i ? "path-traced" : "physical");
        struct dpl_image *image = physical_radiance(fixture, scene, side, side);
        means[i] = physical_mean(image, 1);
        dpl_image_destroy(image);
    }
}

/* The floor under water that scatters, from near above it: what the path tracer has. What the water scatters out of the
 * sun's beam lights the floor too, and counts once. */
static void check_cloudy_floor(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(
        fixture, "[scene]\ndepth = 5\n[water]\nabsorption = 0.05 0.05 0.05\n[sun]\nelevation = 60\n"
                 "[caustics]\ntechnique = coverage\n[look.path-traced]\nmesh = 64\npasses = 24\nphotons = 20\n");
    physical_look(scene, (const double[3]){0.1, -4.6, -0.2}, (const double[3]){0.1, -6, -0.2}, 20);
    support_set(scene, "camera.near_plane", "0.01");
    for (double scattering = 0; scattering < 0.5; scattering += 0.4) {
        double means[2];
        support_set(scene, "water.scattering", "%g %g %g", scattering, scattering, scattering);
        both_looks(fixture, scene, 32, means);
        if (fabs(means[0] / means[1] - 1) > (scattering > 0 ? 0.12 : 0.01))
            fail_msg("scattering %g: %g, not %g", scattering, means[0], means[1]);
    }
    dpl_scene_destroy(scene);
}

/* The floor of a tank near the pane that the sun shines through, where nothing comes from the surface, and in the
 * middle: what the path tracer has. */
static void check_side_light(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(fixture, "[scene]\nsize = 1\ndepth = 0.6\nedge = glass\n[sun]\n"
                                                      "elevation = 45\n[caustics]\ntechnique = coverage\n"
                                                      "[look.path-traced]\nmesh = 64\npasses = 32\nphotons = 200\n"
                                                      "solid_radius = 0.01\n");
    double near_pane = 0;
    for (int middle = 0; middle < 2; middle++) {
        double x = middle ? 0.12 : 0.4, means[2];
        physical_look(scene, (const double[3]){x, 0.5, 0.05}, (const double[3]){x, -0.6, 0.05}, 4);
        both_looks(fixture, scene, 16, means);
        if (fabs(means[0] / means[1] - 1) > 0.06)
            fail_msg("%g m from the middle: %g, not %g", x, means[0], means[1]);
        near_pane = middle ? near_pane / means[0] : means[0];
    }
    assert_true(near_pane < 0.8);
    dpl_scene_destroy(scene);
}

/* Near the focus: the first wave alone has it 1.2 m deep. */
static const char waves[] = "[scene]\nsize = 1\n[wave.1]\ncycles = 2 0\namplitude = 0.02\nphase = 30\n"
                            "[wave.2]\ncycles = 0 1\namplitude = 0.02\n[caustics]\nmap = 128\nmesh = 192\n";

/* The sun's light that enters the water of `waves`, in units of what enters flat water: a mean over its slopes of how
 * much each faces the sun, and of what Fresnel's law lets in there. */
static double entering(double elevation, double azimuth)
{
    enum { STEPS = 400 };
    const double first = 0.02 * 4 * M_PI, second = 0.02 * 2 * M_PI, outside = (90 - elevation) * PHYSICAL_DEGREE;
    const double to_sun[3] = {sin(outside) * cos(azimuth * PHYSICAL_DEGREE), cos(outside),
                              sin(outside) * sin(azimuth * PHYSICAL_DEGREE)};
    double sum = 0;
    for (int i = 0; i < STEPS * STEPS; i++) {
        double slope_x = first * cos(2 * M_PI * (i % STEPS) / STEPS),
               slope_z = second * cos(2 * M_PI * (i / STEPS) / STEPS);
        double facing =
            to_sun[1] - slope_x * to_sun[0] - slope_z * to_sun[2]; /* times the surface above a square metre */
        double angle = acos(facing / sqrt(1 + slope_x * slope_x + slope_z * slope_z));
        if (facing > 0)
            sum += facing * (1 - physical_reflectance(angle, physical_inside(angle)));
    }
    return sum / (STEPS * STEPS) / cos(outside) / (1 - physical_reflectance(outside, physical_inside(outside)));
}

/* A tile of the floor under waves: caustics take no light away and add none. From 20° on the mean is that of flat water
 * within 1 %; below, waves that face the low sun let in more of it, and all elevations are held to the sum over the
 * slopes, which throw no shadows on each other here either. */
static void check_energy(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(fixture, waves);
    double thrown_back = scene->floor.color[1] * physical_thrown_back(0);
    physical_look_down(scene, 0, 0, 1);
    for (int elevation = 5; elevation <= 90; elevation += elevation < 20 ? 5 : 10) {
        support_set(scene, "sun.elevation", "%d", elevation);
        struct dpl_image *image = physical_radiance(fixture, scene, 64, 64);
        double flat = physical_floor(scene, 1), share = entering(elevation, 0), mean = physical_mean(image, 1);
        double expected = flat * (1 + (1 - thrown_back) * (share - 1));
        if (fabs(mean / expected - 1) > 0.005 || (elevation >= 20 && fabs(mean / flat - 1) > 0.01))
            fail_msg("sun at %d degrees: %g with waves, not %g; %g without", elevation, mean, expected, flat);
        assert_true(physical_contrast(image) > 0.5);
        dpl_image_destroy(image);
    }
    support_set(scene, "look.physical.caustics", "no");
    struct dpl_image *image = physical_radiance(fixture, scene, 64, 64);
    assert_true(fabs(physical_mean(image, 1) / physical_floor(scene, 1) - 1) < 0.005 &&
                physical_contrast(image) < 1e-3);
    dpl_image_destroy(image);
    dpl_scene_destroy(scene);
}

/* The same scene and time give the same bytes, again and by a renderer of its own. */
static void check_repeats(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(fixture, waves);
    struct dpl_renderer *other = dpl_renderer_create(fixture->gl, DPL_DEVICE_AUTO, &fixture->log.log);
    struct dpl_image *images[4];
    support_set(scene, "water.absorption", "1 1 1");
    support_set(scene, "water.scattering", "0.1 0.1 0.1");
    support_set(scene, "object.box.shape", "box");
    support_set(scene, "object.box.size", "0.2 1.2 0.2");
    for (int i = 0; i < 4; i++) {
        physical_look(scene, (const double[3]){1, i & 1 ? -0.4 : 0.7, 2}, (const double[3]){0, -0.2, 0}, 60);
        images[i] = dpl_renderer_radiance(i < 2 ? fixture->renderer : other, scene, 0.3, SIDE, SIDE);
        assert_non_null(images[i]);
    }
    for (int i = 0; i < 4; i++) {
        assert_memory_equal(images[i]->pixels, images[i & 1]->pixels, SIDE * SIDE * 3 * sizeof(float));
        assert_true((i & 1) == 0 || memcmp(images[i]->pixels, images[0]->pixels, SIDE * SIDE * 3 * sizeof(float)));
    }
    for (int i = 0; i < 4; i++)
        dpl_image_destroy(images[i]);
    dpl_renderer_destroy(other);
    dpl_scene_destroy(scene);
}

static void check(bool es)
{
    struct physical_fixture fixture;
    physical_start(&fixture, es);
    check_flat_floor(&fixture);
    if (!es) {
        check_cloudy_floor(&fixture);
        check_side_light(&fixture);
    }
    check_energy(&fixture);
    check_repeats(&fixture);
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
