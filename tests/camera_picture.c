/* The path tracer's pictures where radiance is known in closed form, and its caustics where they have been counted. */
#include "camera.h"

#include "base/threads.h"
#include "optics/refraction.h"
#include "reference/camera.h"
#include "reference/photons.h"

#define SIDE 32 /* pixels */
#define MAP 32  /* texels */

struct picture {
    float pixels[SIDE * SIDE * 4]; /* the first row is the lowest */
};

/* From `eye` along an axis, with `half` the tangent of half the field of view. */
static struct camera_sight look(const double eye[3], int axis, double sign, double half)
{
    struct camera_sight view = {.eye = {eye[0], eye[1], eye[2]}, .width = SIDE, .height = SIDE};
    view.ahead[axis] = sign;
    view.right[axis == 0 ? 2 : 0] = half;
    view.up[axis == 1 ? 2 : 1] = half;
    return view;
}

static const struct camera_settings usual = {.bounces = 4, .photons = 10, .solid_radius = 0.03, .water_radius = 0.1};

static void draw(struct place *place, const struct camera_sight *view, const struct camera_settings *settings,
                 int passes, struct picture *picture)
{
    struct camera camera = {.passes = 0};
    assert_true(camera_begin(&camera, &place->world, view, settings, NULL));
    for (int i = 0; i < passes; i++)
        camera_pass(&camera);
    camera_read(&camera, 0, 0, SIDE, SIDE, picture->pixels);
    camera_finish(&camera);
}

static double mean(const struct picture *picture, int color)
{
    double sum = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        assert_true(isfinite(picture->pixels[4 * i + color]) && picture->pixels[4 * i + color] >= 0);
        sum += (double)picture->pixels[4 * i + color] / (SIDE * SIDE);
    }
    return sum;
}

static void expect(double found, double wanted, double tolerance)
{
    if (!(fabs(found - wanted) <= tolerance * fabs(wanted)))
        fail_msg("%.6f, not %.6f", found, wanted);
}

/* In white things under a white sky nothing can be seen. */
static void a_white_furnace_is_white(void **state)
{
    struct place *place = *state;
    struct picture picture;
    const struct camera_settings settings = {.bounces = 100};
    const struct camera_sight view = look((const double[3]){0.2, 1, 3}, 2, -1, 0.7);
    shine(place, 1, 0);
    for (int c = 0; c < 3; c++)
        place->floor[c] = place->solids[c] = 1;
    put_box(place, (const double[3]){-1, -1, -1}, (const double[3]){1, 1.5, 1}, false);
    draw(place, &view, &settings, 16, &picture);
    expect(mean(&picture, 1), 1, 2e-3);
    place->solids[1] = 0; /* a black box can */
    draw(place, &view, &settings, 4, &picture);
    assert_true(mean(&picture, 1) < 0.9);
}

/* Sun in, floor, out. The floor is almost black, so that what the surface throws back on it counts little: 0.02 × 0.48.
 */
static void the_floor_below_flat_water(void **state)
{
    struct place *place = *state;
    struct picture picture;
    struct surface *surface = at_rest(place);
    const struct camera_sight view = look((const double[3]){0.2, 3, 0.3}, 1, -1, 0.05);
    const double sine = sin(M_PI / 3), inside = sqrt(1 - pow(cos(M_PI / 3) / 1.333, 2)), absorption = 0.3;
    shine(place, 0, 5);
    place->world.water.half = INFINITY;
    place->world.water.surface = surface;
    place->world.water.optics.absorption[1] = absorption;
    place->floor[1] = 0.02;
    draw(place, &view, &usual, 16, &picture);
    double floor = 5 * sine * (1 - optics_fresnel_reflectance(sine, 1.333)) * exp(-absorption / inside);
    double seen = (1 - optics_fresnel_reflectance(1, 1.333)) * exp(-absorption) / (1.333 * 1.333);
    expect(mean(&picture, 1), floor * 0.02 / M_PI * seen * (1 + 0.02 * 0.48), 0.01);
}

/* Straight up from below: the sky within 48.6° of the vertical, brighter by the square of the index, and beyond that
 * the black floor in a mirror. */
static void sky_through_snells_window(void **state)
{
    struct place *place = *state;
    struct picture picture;
    struct surface *surface = at_rest(place);
    const double half = 2, edge = tan(asin(1 / 1.333));
    const struct camera_sight view = look((const double[3]){0.2, -0.6, 0.3}, 1, 1, half);
    shine(place, 1, 0);
    place->world.water.half = INFINITY;
    place->world.water.surface = surface;
    place->floor[0] = place->floor[1] = place->floor[2] = 0;
    draw(place, &view, &usual, 64, &picture);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double x = (2 * (i % SIDE + 0.5) / SIDE - 1) * half, y = (2 * (i / SIDE + 0.5) / SIDE - 1) * half;
        double away = sqrt(x * x + y * y), pixel = 2 * half / SIDE;
        double air = sqrt(fmax(1 - pow(1.333 * away / sqrt(1 + away * away), 2), 0));
        double wanted = (1 - optics_fresnel_reflectance(air, 1.333)) * 1.333 * 1.333;
        if (away > edge + pixel)
            assert_true(picture.pixels[4 * i] == 0);
        else if (away < edge - 2 * pixel)
            expect((double)picture.pixels[4 * i], wanted, 0.03);
    }
}

/* Sunlit water without end, seen horizontally: what is scattered once on the way, in closed form. */
static void shafts_of_still_water(void **state)
{
    struct place *place = *state;
    struct picture picture;
    struct surface *surface = at_rest(place);
    struct optics_water *optics = &place->world.water.optics;
    const struct camera_settings once = {.bounces = 0, .photons = 40, .solid_radius = 0.03, .water_radius = 0.4};
    const struct camera_sight view = look((const double[3]){0.2, -1.5, 0.3}, 0, 1, 0.01);
    shine(place, 0, 5);
    place->world.depth = 50;
    place->world.water.half = INFINITY;
    place->world.water.surface = surface;
    for (int c = 0; c < 3; c++) {
        optics->absorption[c] = 0.3;
        optics->scattering[c] = 0.001 * (1 + c); /* so little that almost none is scattered twice */
    }
    optics->anisotropy = 0.4;
    draw(place, &view, &once, 16, &picture);
    double sine = sin(M_PI / 3), inside = sqrt(1 - pow(cos(M_PI / 3) / 1.333, 2));
    /* The sun stands in +x and +z: its light goes on towards the eye, which looks to +x. */
    double along = cos(M_PI / 3) * cos(M_PI / 6) / 1.333, g = 0.4;
    double phase = (1 - g * g) / (4 * M_PI * pow(1 + g * g - 2 * g * along, 1.5));
    for (int c = 0; c < 3; c++) {
        double extinction = optics->absorption[c] + optics->scattering[c];
        double beam =
            5 * (1 - optics_fresnel_reflectance(sine, 1.333)) * sine / inside * exp(-extinction * 1.5 / inside);
        expect(mean(&picture, c), beam * optics->scattering[c] * phase / extinction, 0.02);
    }
}

/* Cloudy water over a bright floor: what photons bring is what paths find that know the sun's way through water at
 * rest, and are scattered and thrown back as often as they like. */
static void photons_bring_what_paths_find(struct place *place, double absorption, double scattering, double tolerance)
{
    struct picture picture;
    struct surface *surface = at_rest(place);
    const struct camera_sight sight = look((const double[3]){0.2, 2, 0.3}, 1, -1, 0.1);
    const struct camera_settings settings = {.bounces = 30, .photons = 60, .solid_radius = 0.05, .water_radius = 0.05};
    shine(place, 0, 5);
    place->world.water.half = INFINITY;
    place->world.water.surface = surface;
    for (int c = 0; c < 3; c++) {
        place->world.water.optics.absorption[c] = absorption;
        place->world.water.optics.scattering[c] = scattering * (1 + c);
    }
    place->world.water.optics.anisotropy = 0.3;
    draw(place, &sight, &settings, 16, &picture);

    struct camera_scene scene;
    double sums[3] = {0, 0, 0};
    const int paths = 32;
    assert_true(camera_scene_make(&scene, &place->world, NULL));
    const struct camera_path path = {.scene = &scene, .bounces = 30};
    for (int i = 0; i < SIDE * SIDE * paths; i++) {
        struct draws draws = {.start = random_mix(1000 + (uint64_t)(i / paths)), .path = (uint64_t)(i % paths)};
        double direction[3], radiance[3], u = draws_next(&draws), v = draws_next(&draws);
        camera_sight_ray(&sight, i / paths % SIDE + u, i / paths / SIDE + v, direction);
        camera_path_radiance(&path, sight.eye, direction, false, &draws, radiance);
        for (int c = 0; c < 3; c++)
            sums[c] += radiance[c] / (SIDE * SIDE * paths);
    }
    camera_scene_finish(&scene);
    for (int c = 0; c < 3; c++)
        expect(mean(&picture, c), sums[c], tolerance);
}

static void photons_in_cloudy_water(void **state)
{
    photons_bring_what_paths_find(*state, 0.1, 0.3, 0.025);
}

/* So murky that photons leave more in the water than there is room for. */
static void photons_in_murky_water(void **state)
{
    photons_bring_what_paths_find(*state, 1, 4, 0.04);
}

/* A black plate in the water that throws no shadow: the floor below it has its light all the same. */
static void photons_pass_what_throws_no_shadow(void **state)
{
    static const bool casts[12] = {false};
    struct place *place = *state;
    struct picture open, below;
    struct surface *surface = at_rest(place);
    const struct camera_sight view = look((const double[3]){0.2, -0.7, 0.3}, 1, -1, 0.3);
    shine(place, 0, 5);
    place->world.water.half = INFINITY;
    place->world.water.surface = surface;
    place->solids[0] = place->solids[1] = place->solids[2] = 0;
    place->floor[0] = place->floor[1] = place->floor[2] = 0.02;
    draw(place, &view, &usual, 16, &open);
    put_box(place, (const double[3]){-9, -0.5, -9}, (const double[3]){9, -0.4, 9}, false);
    place->world.solids.casts = casts;
    draw(place, &view, &usual, 16, &below);
    expect(mean(&below, 1), mean(&open, 1), 0.03);
}

/* The photons of a picture and those of a caustic map count the same light on the floor. */
static void caustics_are_those_that_were_counted(void **state)
{
    struct place *place = *state;
    struct wave wave = {{4, 2}, 0.05, 0, 0, 0};
    struct optics_sun sun = {.elevation = 60, .azimuth = 30, .angular_radius = 0.2665};
    struct water_medium medium = {.ior = 1.333, .absorption = {0.35, 0.07, 0.03}};
    struct water_setup setup_ = {.size = 4, .depth = 1, .waves = &wave, .wave_count = 1};
    const double receiver = -1;
    struct photons_task task = {.model = water_models[0],
                                .setup = &setup_,
                                .sun = &sun,
                                .medium = &medium,
                                .receivers = &receiver,
                                .receiver_count = 1,
                                .side = MAP};
    static float map[MAP * MAP * 3];
    struct photons counted = {.passes = 0};
    assert_true(photons_begin(&counted, &task, NULL));
    for (int i = 0; i < 100; i++)
        photons_pass(&counted, &task);
    photons_read(&counted, 0, map);
    photons_finish(&counted);

    struct surface *surface = at_rest(place);
    water_fill(water_models[0], &setup_, 0, surface);
    shine(place, 0, 5);
    place->world.water.half = INFINITY;
    place->world.water.surface = surface;
    place->world.water.optics = water_optics(&medium);
    struct camera_scene scene;
    struct camera_photons photons;
    const struct camera_sight view = look((const double[3]){0, 4, 0}, 1, -1, 0.4);
    assert_true(camera_scene_make(&scene, &place->world, NULL));
    assert_true(camera_photons_begin(&photons, &scene, &view, 1500000, NULL));
    camera_photons_send(&photons, 0);
    const double sine = sin(M_PI / 3), inside = sqrt(1 - pow(cos(M_PI / 3) / 1.333, 2)), up[3] = {0, 1, 0};
    double flat = 5 * sine * (1 - optics_fresnel_reflectance(sine, 1.333)) * exp(-0.07 / inside);
    double squares = 0, contrast = 0;
    int texels = 0;
    for (int i = 0; i < MAP * MAP; i++) {
        const double texel = 4.0 / MAP, at[3] = {(i % MAP + 0.5) * texel - 2, -1, (i / MAP + 0.5) * texel - 2};
        double irradiance[3], counted_light = (double)map[3 * i + 1];
        if (fabs(at[0]) > 1.5 || fabs(at[2]) > 1.5)
            continue;
        camera_photons_surface(&photons, at, up, texel / sqrt(M_PI), irradiance); /* a disc of a texel's area */
        squares += pow(irradiance[1] / flat - counted_light, 2);
        contrast += pow(counted_light - 1, 2);
        texels++;
    }
    camera_photons_finish(&photons);
    camera_scene_finish(&scene);
    assert_true(sqrt(contrast / texels) > 0.5);
    if (!(sqrt(squares / contrast) < 0.05)) /* a disc is no square */
        fail_msg("%.4f", sqrt(squares / contrast));
}

static void threads_do_not_show(void **state)
{
    struct place *place = *state;
    static struct picture first, second;
    struct surface *surface = at_rest(place);
    const struct camera_sight view = look((const double[3]){0, -0.5, 3}, 2, -1, 0.7);
    shine(place, 1, 5);
    place->world.water =
        (struct camera_water){INFINITY, surface, {1.33, 1.333, 1.336}, 0.02, {{0.3, 0.1, 0.1}, {0.1, 0.1, 0.2}, 0.8}};
    put_box(place, (const double[3]){-1, -0.5, -1}, (const double[3]){1, 0.5, 1}, false);
    omp_set_num_threads(1);
    draw(place, &view, &usual, 2, &first);
    omp_set_num_threads(2);
    draw(place, &view, &usual, 2, &second);
    assert_memory_equal(first.pixels, second.pixels, sizeof first.pixels);
    assert_true(mean(&first, 0) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_white_furnace_is_white, setup, teardown),
        cmocka_unit_test_setup_teardown(the_floor_below_flat_water, setup, teardown),
        cmocka_unit_test_setup_teardown(sky_through_snells_window, setup, teardown),
        cmocka_unit_test_setup_teardown(shafts_of_still_water, setup, teardown),
        cmocka_unit_test_setup_teardown(photons_in_cloudy_water, setup, teardown),
        cmocka_unit_test_setup_teardown(photons_in_murky_water, setup, teardown),
        cmocka_unit_test_setup_teardown(photons_pass_what_throws_no_shadow, setup, teardown),
        cmocka_unit_test_setup_teardown(caustics_are_those_that_were_counted, setup, teardown),
        cmocka_unit_test_setup_teardown(threads_do_not_show, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
