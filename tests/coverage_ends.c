/* The technique `coverage` on the CPU where its map is known without a sum: flat water, edges, ends of ranges. */
#include "coverage_cpu.h"

#include <time.h>

#define MESH 30

static void make_flat(struct fixture *fixture, int mesh, bool periodic, double height)
{
    make_waves(fixture, NULL, 0, mesh, periodic);
    for (int i = 0; i < mesh * mesh; i++)
        fixture->surface.texels[3 * i] = (float)height;
}

static void expect(const struct fixture *fixture, double wanted, double tolerance)
{
    int count = fixture->map.side * fixture->map.side * fixture->map.slices * 3;
    for (int i = 0; i < count; i++)
        if (!(fabs((double)fixture->map.texels[i] - wanted) <= tolerance))
            fail_msg("%.7f instead of %g in number %d, receiver %g, sun %g°, %g° wide, map %d",
                     (double)fixture->map.texels[i], wanted, i, fixture->receivers[0], fixture->sun.elevation,
                     fixture->sun.angular_radius, fixture->map.side);
}

/* Any sun, any receiver, any mesh, coarser and finer than the map. Light of a low sun lands many tiles away. */
static void flat_water_gives_one_everywhere(void **state)
{
    static const double elevations[] = {1, 5, 30, 90}, receivers[] = {-1e-6, -0.3, -40, 1e-6, 0.7, 40};
    static const int sides[] = {1, 33, 64}, meshes[] = {2, 17, 80};
    struct fixture *fixture = *state;
    for (int i = 0; i < 4 * 6 * 3 * 2; i++) {
        double elevation = elevations[i % 4], receiver = receivers[i / 4 % 6];
        bool disc = i % 3 == 0 && elevation > 20 && fabs(receiver) < 1; /* others reach over many maps, and take long */
        fixture->sun = (struct optics_sun){
            .elevation = elevation, .azimuth = 35 * (i % 5), .angular_radius = disc ? 0.2665 + i % 5 : 0};
        fixture->receivers[0] = receiver;
        fixture->medium.dispersion = i % 7 ? 0 : 0.1;
        make_flat(fixture, meshes[i % 3], true, 0);
        trace(fixture, sides[i / 24 % 3], 1);
        expect(fixture, 1, 1e-5); /* single precision, with sums over a row */
    }
}

/* The sun in +x: no light comes in at that edge, and what leaves at the other is lost. The disc blurs the edge. */
static void bounded_flat_water_gives_one_where_its_light_falls(void **state)
{
    struct fixture *fixture = *state;
    const int side = 40;
    for (int i = 0; i < 8; i++) {
        double receiver = i & 1 ? 0.4 : -0.9, radius = i & 2 ? 0.5 : 0, shift, blur;
        fixture->sun = (struct optics_sun){.elevation = 50, .azimuth = i & 4 ? 90 : 0, .angular_radius = radius};
        fixture->receivers[0] = receiver;
        make_flat(fixture, 25, false, 0);
        trace(fixture, side, 1);
        shift = (i & 1 ? 0.4 / tan(50 * M_PI / 180) : 0.9 * tan(asin(cos(50 * M_PI / 180) / 1.333))) * side / SIZE;
        blur =
            radius > 0 ? 2 : 0; /* texels: 0.5° over a way of 1.4 m at the most are 12 mm, or 0.25, and a whole one */
        for (int k = 0; k < side * side; k++) {
            int along = i & 4 ? k / side : k % side, across = i & 4 ? k % side : k / side;
            double value = (double)fixture->map.texels[3 * k], end = side - shift;
            bool within = along + 1 <= end - blur && across >= blur && across + 1 <= side - blur && along >= blur;
            if (within ? fabs(value - 1) > 1e-5 : along >= end + blur ? value > 1e-5 : value > 1 + 1e-5)
                fail_msg("case %d: %g at %d, %d; light ends at %g", i, value, along, across, end);
        }
        if (radius == 0) /* the texel that the edge of the light lies in has that part of it */
            assert_true(
                fabs((double)fixture->map.texels[3 * (i & 4 ? (int)(side - shift) * side : (int)(side - shift))] -
                     (side - shift - floor(side - shift))) < 1e-4);
    }
}

/* Water that is lower than the floor, or higher than the ceiling, lights it straight, with nothing absorbed. */
static void water_beyond_its_receiver_lights_it_straight(void **state)
{
    struct fixture *fixture = *state;
    fixture->sun.elevation = 40;
    for (int i = 0; i < 4; i++) {
        double direction = i & 1 ? 1 : -1;
        fixture->sun.angular_radius = i & 2 ? 1 : 0;
        fixture->receivers[0] = 0.3 * direction;
        fixture->medium.absorption[0] = fixture->medium.absorption[1] = fixture->medium.absorption[2] = 0;
        make_flat(fixture, MESH, true, 0.5 * direction);
        trace(fixture, 30, 1);
        expect(fixture, 1, 1e-5);
    }
}

/* No step of the index: light goes straight on whatever the waves, and nothing is thrown back. To what a mesh of 128
 * leaves where light is slanted (measured: 3.4e-3 at 40°). */
static void without_refraction_light_is_even(void **state)
{
    struct fixture *fixture = *state;
    fixture->medium = (struct water_medium){.ior = 1};
    for (int i = 0; i < 6; i++) {
        make_random(fixture, 50 + (uint64_t)i, 4, 0.2, 128, true);
        fixture->sun = (struct optics_sun){.elevation = i % 3 == 0   ? 90
                                                        : i % 3 == 1 ? 60
                                                                     : 40,
                                           .azimuth = 20 * i,
                                           .angular_radius = i < 3 ? 0 : 0.5};
        fixture->receivers[0] = -1;
        trace(fixture, 32, 1);
        double worst = 0;
        for (int k = 0; k < 32 * 32 * 3; k++)
            worst = fmax(worst, fabs((double)fixture->map.texels[k] - 1));
        assert_true(worst < 5e-3);
        fixture->receivers[0] = 1;
        fixture->sun.angular_radius = 0;
        trace(fixture, 32, 1);
        expect(fixture, 0, 1e-5);
    }
}

/* Absorption by colour: flat water's map stays 1, and a level that stands higher is darker by the way it is longer. */
static void absorption_acts_on_each_colour(void **state)
{
    struct fixture *fixture = *state;
    fixture->sun = (struct optics_sun){.elevation = 40, .azimuth = 10, .angular_radius = 0};
    make_flat(fixture, MESH, true, 0.2);
    trace(fixture, 30, 1);
    double down = cos(asin(cos(40 * M_PI / 180) / 1.333));
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < 900; i++)
            assert_true(
                fabs((double)fixture->map.texels[3 * i + c] - exp(-fixture->medium.absorption[c] * 0.2 / down)) < 1e-5);
}

/* Numbers at their ends, many at once: high waves through floors and ceilings, crests turned away from a sun at 1°,
 * images a thousand tiles wide, dark water, a disc of 10°. trace() looks at each number; none takes a second, which
 * sanitizers may make ten of. (From air into water nothing is ever totally reflected.) */
static void nothing_is_ever_infinite_or_endless(void **state)
{
    static const double receivers[] = {-1e-6, -0.05, -1000, 1e-6, 0.05, 1000};
    struct fixture *fixture = *state;
    for (int i = 0; i < 128; i++) {
        struct plane_wave waves[] = {{{3, 1}, i & 1 ? 100 : 0.1, 0, i & 64 ? 0.9 : 0},
                                     {{13, -11}, i & 2 ? 1 : 0.01, 0, i & 64 ? -0.5 : 0}};
        double receiver = receivers[i % 6];
        bool disc =
            i & 16 && !(i & 1) && receiver < 0 && receiver > -1; /* wider discs need more memory than there is */
        make_waves(fixture, waves, 2, i % 3 == 0 ? 2 : MESH, i & 4);
        fixture->surface.size = i % 5 || disc ? SIZE : 0.01;
        fixture->sun = (struct optics_sun){
            .elevation = i & 8 ? 1 : 5 + 85 * (i & 1), .azimuth = 10 * (i % 18), .angular_radius = disc ? 10 : 0};
        fixture->receivers[0] = receiver;
        fixture->medium =
            (struct water_medium){.ior = i & 32 ? 1 : 3, .dispersion = i & 32 ? 0 : 0.5, .absorption = {0, 0.05, 0.3}};
        clock_t start = clock();
        trace(fixture, i % 7 == 0 ? 1 : 24, 1);
        double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
        if (seconds > 10)
            fail_msg("case %d took %g s", i, seconds);
    }
}

/* Straight above, the sun has no azimuth: what its sine leaves moves no light. */
static void the_zenith_has_no_azimuth(void **state)
{
    struct fixture *fixture = *state;
    fixture->sun.elevation = 90;
    make_flat(fixture, MESH, true, 0);
    for (int azimuth = -360; azimuth <= 360; azimuth += 30) {
        fixture->sun.azimuth = azimuth;
        trace(fixture, 25, 1);
        expect(fixture, 1, 1e-5);
    }
}

/* A trough of 2 m in water that lets nothing through: its light has less water than flat water's. */
static void black_water_is_finite(void **state)
{
    const struct plane_wave wave = {{1, 0}, 2, 0, 0};
    struct fixture *fixture = *state;
    fixture->medium.absorption[0] = 100;
    fixture->receivers[0] = -3;
    make_waves(fixture, &wave, 1, MESH, true);
    trace(fixture, 25, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(flat_water_gives_one_everywhere, setup, teardown),
        cmocka_unit_test_setup_teardown(bounded_flat_water_gives_one_where_its_light_falls, setup, teardown),
        cmocka_unit_test_setup_teardown(water_beyond_its_receiver_lights_it_straight, setup, teardown),
        cmocka_unit_test_setup_teardown(without_refraction_light_is_even, setup, teardown),
        cmocka_unit_test_setup_teardown(absorption_acts_on_each_colour, setup, teardown),
        cmocka_unit_test_setup_teardown(nothing_is_ever_infinite_or_endless, setup, teardown),
        cmocka_unit_test_setup_teardown(the_zenith_has_no_azimuth, setup, teardown),
        cmocka_unit_test_setup_teardown(black_water_is_finite, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
