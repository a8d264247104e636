/* Light from all around where it is known in closed form. */
#include "camera.h"

#include "base/threads.h"
#include "optics/refraction.h"

static double bake(struct place *place, double x, double y, double z, double up, int rays)
{
    const float position[3] = {(float)x, (float)y, (float)z}, normal[3] = {0, (float)up, 0};
    float irradiance[3];
    assert_true(ambient_bake(&place->world, 1, position, normal, &rays, irradiance, NULL));
    return (double)irradiance[1];
}

static void expect(double found, double wanted, double tolerance)
{
    if (!(fabs(found - wanted) <= tolerance))
        fail_msg("%.5f, not %.5f", found, wanted);
}

/* Over an endless floor only the sky is seen; below a sky of radiance 1 that gives π. */
static void open_sky_gives_pi(void **state)
{
    struct place *place = *state;
    shine(place, 1, 0);
    expect(bake(place, 0.3, -1, 0.2, 1, 64), M_PI, 1e-6);
    expect(bake(place, 0.3, 1, 0.2, -1, 256), M_PI * 0.5, 1e-3); /* sky that the floor throws back */
}

/* Within a box of which all sides are white and the sun outside, nothing. */
static void a_closed_box_is_dark(void **state)
{
    struct place *place = *state;
    shine(place, 1, 5);
    put_box(place, (const double[3]){-1, -0.5, -1}, (const double[3]){1, 1, 1}, true);
    expect(bake(place, 0, 0, 0, 1, 64), 0, 0);
}

/* Of a sky of radiance 1 the share 1 less the mean Fresnel reflectance enters, whatever the angle in the water. */
static void sky_through_flat_water(void **state)
{
    struct place *place = *state;
    double enters = 0;
    const int steps = 20000;
    for (int i = 0; i < steps; i++)
        enters += (1 - optics_fresnel_reflectance(sqrt((i + 0.5) / steps), 1.333)) / steps;
    shine(place, 1, 0);
    place->world.water.half = INFINITY;
    place->floor[0] = place->floor[1] = place->floor[2] = 0;
    expect(bake(place, 0.3, -1, 0.2, 1, 4096), M_PI * enters, 0.02);
    /* The floor's own light that the surface throws back: the sum over bounces is more. */
    place->floor[0] = place->floor[1] = place->floor[2] = 0.8;
    double back = 1 - enters / (1.333 * 1.333), kept = 0.8 * back;         /* share of diffuse light kept below */
    double most = M_PI * enters * (1 + kept + kept * kept + pow(kept, 3)); /* as many bounces as are followed */
    expect(bake(place, 0.3, -1, 0.2, 1, 16384), most, 0.03);
}

/* A wall in the sun lights the floor; here it is the floor that lights what looks down: reflectance × sun × sine. */
static void sunlit_floor_lights_what_is_above(void **state)
{
    struct place *place = *state;
    shine(place, 0, 2);
    expect(bake(place, 0.3, 1, 0.2, -1, 64), 0.5 * 2 * sin(M_PI / 3), 1e-3);
    expect(bake(place, 0.3, -1, 0.2, 1, 64), 0, 0); /* straight from the sun is left out */
}

/* The same floor under water, almost black so that the surface throws little of its light back, and what looks down
 * 2 cm above it: the way there has a mean length of 4 cm. */
static void sun_through_flat_water(void **state)
{
    struct place *place = *state;
    shine(place, 0, 2);
    place->world.water.half = INFINITY;
    place->world.water.optics.absorption[1] = 0.4;
    place->floor[1] = 0.01;
    place->world.sun.radius = 0;
    double sine = sin(M_PI / 3), inside = sqrt(1 - pow(cos(M_PI / 3) / 1.333, 2));
    double floor = 2 * sine * (1 - optics_fresnel_reflectance(sine, 1.333)) * exp(-0.4 / inside);
    expect(bake(place, 0.3, -0.98, 0.2, -1, 64) / (0.01 * floor), exp(-0.4 * 0.04), 0.01);
}

/* A lid over everything: a shadow everywhere, or, where it throws none, light between lid and floor too. */
static void shadows_take_the_sun_away(void **state)
{
    struct place *place = *state;
    shine(place, 0, 2);
    put_box(place, (const double[3]){-50, 1, -50}, (const double[3]){50, 2, 50}, false);
    expect(bake(place, 0, 0, 0, -1, 64), 0, 0);
    const bool casts[12] = {false};
    place->world.solids.casts = casts;
    expect(bake(place, 0, 0, 0, -1, 64), (1 + 0.5 * 0.5) * 0.5 * 2 * sin(M_PI / 3), 0.02);
}

/* A block of water with a thin wall that lies in its side's plane towards the sun: what the sun would bring in there
 * stays out. */
static void a_wall_in_the_side_of_the_water(void **state)
{
    struct place *place = *state;
    shine(place, 0, 2);
    place->world.water.half = 1;
    place->world.sun = optics_sun_disc(&(struct optics_sun){.elevation = 14});
    assert_true(bake(place, 0.8, -0.6, 0, -1, 256) > 0.01);
    put_box(place, (const double[3]){1, -1.5, -9}, (const double[3]){1.00005, 3, 9}, false);
    place->solids[0] = place->solids[1] = place->solids[2] = 0;
    expect(bake(place, 0.8, -0.6, 0, -1, 256), 0, 0);
}

/* A box stands between two places on the floor, and not between two others. */
static void a_box_parts_places(void **state)
{
    struct place *place = *state;
    put_box(place, (const double[3]){-0.2, -1.5, -1}, (const double[3]){0.2, 0.5, 1}, true);
    const float pairs[3][6] = {{-1, -0.9f, 0, 1, -0.9f, 0}, {-1, -0.9f, -1, -1, -0.9f, 1}, {1, 0.6f, 0, -1, 0.6f, 0}};
    bool clear[3];
    assert_true(ambient_clear(&place->world, 3, pairs[0], clear, NULL));
    assert_false(clear[0]);
    assert_true(clear[1]);
    assert_true(clear[2]);
}

/* For any number of threads, and with solids, water and scattering. */
static void threads_do_not_show(void **state)
{
    enum { COUNT = 2000, RAYS = 16 };
    static float positions[3 * COUNT], normals[3 * COUNT], first[3 * COUNT], second[3 * COUNT];
    static int rays[COUNT];
    struct place *place = *state;
    shine(place, 1, 5);
    place->world.water.half = INFINITY;
    for (int c = 0; c < 3; c++)
        place->world.water.optics.scattering[c] = place->world.water.optics.absorption[c] = 0.1 * (1 + c);
    put_box(place, (const double[3]){-1, -0.5, -1}, (const double[3]){1, 0.5, 1}, false);
    for (int i = 0; i < COUNT; i++) {
        for (int c = 0; c < 3; c++)
            positions[3 * i + c] = (float)sin(i * (12.9 + c));
        normals[3 * i + i % 3] = 1;
        rays[i] = RAYS;
    }
    omp_set_num_threads(1);
    assert_true(ambient_bake(&place->world, COUNT, positions, normals, rays, first, NULL));
    omp_set_num_threads(2);
    assert_true(ambient_bake(&place->world, COUNT, positions, normals, rays, second, NULL));
    assert_memory_equal(first, second, sizeof first);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(open_sky_gives_pi, setup, teardown),
        cmocka_unit_test_setup_teardown(a_closed_box_is_dark, setup, teardown),
        cmocka_unit_test_setup_teardown(sky_through_flat_water, setup, teardown),
        cmocka_unit_test_setup_teardown(sunlit_floor_lights_what_is_above, setup, teardown),
        cmocka_unit_test_setup_teardown(sun_through_flat_water, setup, teardown),
        cmocka_unit_test_setup_teardown(shadows_take_the_sun_away, setup, teardown),
        cmocka_unit_test_setup_teardown(a_wall_in_the_side_of_the_water, setup, teardown),
        cmocka_unit_test_setup_teardown(a_box_parts_places, setup, teardown),
        cmocka_unit_test_setup_teardown(threads_do_not_show, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
