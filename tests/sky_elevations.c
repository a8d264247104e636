/* The clear sky from a sun at the horizon to one overhead: nothing jumps, and no light is made. */
#include "sky.h"

enum { LOWEST = 1, HIGHEST = 90 };

/* How fast a value's logarithm changes its slope from one degree to the next. */
static double bend(const double *value)
{
    return fabs(log(value[1]) - 2 * log(value[0]) + log(value[-1]));
}

static void every_degree_follows_from_the_last(void **state)
{
    struct fixture *fixture = *state;
    double sun[HIGHEST + 1][3], sky[3][HIGHEST + 1], side[HIGHEST + 1], direction[3], radiance[3];
    direction_of(25, fixture->sun.azimuth + 100, direction);
    for (int elevation = LOWEST; elevation <= HIGHEST; elevation++) {
        fixture->sun.elevation = elevation;
        make(fixture);
        double sine = sin(elevation * M_PI / 180);
        for (int c = 0; c < 3; c++) {
            sun[elevation][c] = fixture->sky.sun[c];
            sky[c][elevation] = fixture->sky.irradiance[c];
        }
        optics_sky_radiance(&fixture->sky, direction, radiance);
        side[elevation] = luminance(radiance);
        /* what is scattered comes from the sun; of a sun so low that its light is long on the way, from elsewhere too
         */
        double all = luminance(fixture->sky.irradiance) + luminance(fixture->sky.sun) * sine;
        assert_true(all < (elevation < 5 ? 1.3 : 0.95) * sine);
    }
    for (int elevation = LOWEST + 1; elevation < HIGHEST; elevation++) {
        double most = elevation < 8 ? 0.15 : 0.02;
        for (int c = 0; c < 3; c++) {
            assert_true(sun[elevation][c] >= sun[elevation - 1][c]);
            assert_true(sky[c][elevation] > sky[c][elevation - 1]);
            assert_true(bend(&sky[c][elevation]) < most);
        }
        assert_true(bend(&side[elevation]) < most);
        assert_true(sun[elevation][2] / sun[elevation][0] >= sun[elevation - 1][2] / sun[elevation - 1][0]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(every_degree_follows_from_the_last, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
