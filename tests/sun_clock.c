/* The sun by date, hour and place, against what NREL's program and others say. */
#include "support.h"

#include "optics/sun.h"
#include "optics/sun_clock.h"
#include "scene/scene.h"

static const double degree = M_PI / 180;

struct moment {
    int date[3];
    double hour, time_zone, latitude, longitude;
};

static void read_moment(const struct moment *m, double *elevation, double *bearing)
{
    const struct sun_clock clock = {m->date, m->hour, m->time_zone, m->latitude, m->longitude};
    sun_clock_read(&clock, elevation, bearing);
}

/* Arc between two places in the sky, degrees. */
static double arc(double elevation, double bearing, const double wanted[2])
{
    double e = elevation * degree, w = wanted[0] * degree, turn = (bearing - wanted[1]) * degree;
    return acos(fmin(sin(e) * sin(w) + cos(e) * cos(w) * cos(turn), 1)) / degree;
}

/* Elevation above the horizon, with refraction, and bearing: the example of Reda & Andreas 2004 (table A5.1); results
 * of NREL's program (Hemphill; Philadelphia and Kyiv, without refraction, which is added here: 0.01°); three places of
 * the sun that came with satellites' pictures, of which the last is 0.034° off, for a reason that is not known. */
static void the_sun_stands_where_others_say(void **state)
{
    static const struct {
        struct moment moment;
        double wanted[2];
    } table[] = {
        {{{2003, 10, 17}, 12.508333, -7, 39.742476, -105.1786}, {39.88838, 194.34024}},
        {{{2003, 2, 1}, 8.983333, -6, 31.34635, -93.82015}, {20.19, 126.171556}},
        {{{1976, 7, 4}, 12, -4, 39.949444, -75.150278}, {68.044698 + 0.01, 136.392115}},
        {{{2022, 8, 24}, 12, 3, 50.4501, 30.5234}, {48.69325 + 0.01, 157.23991}},
        {{{2002, 5, 25}, 6.230556, 0, 33.334889, 69.922135}, {71.266, 127.482}},
        {{{2003, 7, 11}, 1.148889, 0, 35.769302, 139.278272}, {64.495, 115.428}},
        {{{2009, 3, 13}, 15.745, 0, 41.741604, -71.396}, {42.766, 155.745}},
    };
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        double elevation, bearing;
        read_moment(&table[i].moment, &elevation, &bearing);
        if (!(arc(elevation, bearing, table[i].wanted) < (i < 6 ? 0.02 : 0.05)))
            fail_msg("%zu: %.4f %.4f instead of %.4f %.4f", i, elevation, bearing, table[i].wanted[0],
                     table[i].wanted[1]);
    }
}

/* When NREL's program lets it rise and set, its middle is 50' below the horizon of an earth without air: half the sun's
 * width, and 34' of refraction. (NOAA's formula, which is for a sun that is up, lifts it by 24' there.) */
static void the_sun_rises_and_sets_in_time(void **state)
{
    static const struct moment table[] = {
        {{2003, 2, 1}, 7.131432, -6, 31.34635, -93.82015},   {{2003, 2, 1}, 17.836307, -6, 31.34635, -93.82015},
        {{1976, 7, 4}, 5.620365, -4, 39.949444, -75.150278}, {{1976, 7, 4}, 20.546170, -4, 39.949444, -75.150278},
        {{2022, 8, 24}, 5.995393, 3, 50.4501, 30.5234},      {{2022, 8, 24}, 19.997578, 3, 50.4501, 30.5234},
    };
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        double elevation, bearing;
        read_moment(table + i, &elevation, &bearing);
        if (!(fabs(elevation + 50.0 / 60 - 24.0 / 60) < 0.1))
            fail_msg("%zu: %.4f", i, elevation);
        assert_true(table[i].hour < 12 ? bearing < 180 : bearing > 180);
    }
}

/* From the poles the sun's declination is seen: 0 at the equinox (20 March 2024, 3:06 universal time), 23.44° at the
 * solstice (20 June, 20:51), -7.785° on 13 October 1992 (Meeus 1991, example 25.a); with refraction. */
static void seasons_come_when_they_should(void **state)
{
    static const struct {
        struct moment moment;
        double elevation;
    } table[] = {
        {{{2024, 3, 20}, 3.1, 0, 90, 0}, 0.482},
        {{{2024, 3, 20}, 3.1, 0, -90, 0}, 0.482},
        {{{2024, 6, 20}, 20.85, 0, 90, 77}, 23.438 + 0.037},
        {{{1992, 10, 13}, 0, 0, -90, 0}, 7.785 + 0.110},
    };
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        double elevation, bearing;
        read_moment(&table[i].moment, &elevation, &bearing);
        if (!(fabs(elevation - table[i].elevation) < 0.02))
            fail_msg("%zu: %.4f instead of %.4f", i, elevation, table[i].elevation);
    }
}

/* The same moment by other zones' clocks, and by dates that count on. */
static void clocks_agree(void **state)
{
    static const struct moment table[] = {
        {{2023, 12, 31}, 23.5, 0, 10, 20}, {{2024, 1, 1}, 0.5, 1, 10, 20},  {{2023, 12, 32}, 1.5, 2, 10, 20},
        {{2023, 13, 1}, 1.5, 2, 10, 20},   {{2022, 25, 1}, 0.5, 1, 10, 20}, {{2023, 12, 31}, 13.5, -10, 10, 20},
    };
    double first[2];
    (void)state;
    read_moment(table, first, first + 1);
    for (size_t i = 1; i < sizeof table / sizeof *table; i++) {
        double elevation, bearing;
        read_moment(table + i, &elevation, &bearing);
        assert_true(arc(elevation, bearing, first) < 1e-5);
    }
}

/* Through scene text to the direction: at noon in the north the sun is south, +z; in the morning east, +x; and it does
 * not set. Its own angles do not matter then. */
static void the_scene_follows_the_clock(void **state)
{
    struct support_log log;
    struct dpl_scene *scene = support_scene("[sun]\nby = clock\ndate = 2024 6 21\nlatitude = 45\nlongitude = 0\n"
                                            "time_zone = 0\nelevation = 7\nazimuth = 111\n",
                                            support_log_start(&log));
    double to_sun[3];
    (void)state;
    optics_sun_direction(&scene->sun, to_sun);
    assert_true(to_sun[2] > 0.3 && fabs(to_sun[0]) < 0.05 && fabs(asin(to_sun[1]) / degree - 68.44) < 0.1);
    support_set(scene, "sun.hour", "6");
    optics_sun_direction(&scene->sun, to_sun);
    assert_true(to_sun[0] > 0.8 && to_sun[2] < 0);
    support_set(scene, "sun.hour", "18");
    optics_sun_direction(&scene->sun, to_sun);
    assert_true(to_sun[0] < -0.8 && to_sun[2] < 0);
    for (double hour = 0; hour < 24; hour += 0.5) {
        support_set(scene, "sun.hour", "%g", hour);
        struct optics_disc disc = optics_sun_disc(&scene->sun);
        assert_true(disc.middle[1] > sin(0.9999 * degree));
        assert_true(hour < 5 || hour > 19 || disc.middle[1] > sin(1.5 * degree));
        assert_true((hour > 4 && hour < 20) || disc.middle[1] < sin(1.0001 * degree));
    }
    support_set(scene, "sun.by", "angles");
    optics_sun_direction(&scene->sun, to_sun);
    assert_true(fabs(to_sun[1] - sin(7 * degree)) < 1e-12);
    dpl_scene_destroy(scene);
    assert_int_equal(log.errors, 0);
}

/* Every technique's light is that of the angles at which the clock puts the sun, to the byte. */
static void light_follows_the_clock(void **state)
{
    static const char text[] = "[scene]\nsize = 2\n[wave.1]\namplitude = 0.06\ncycles = 3 0\n[caustics]\nmap = 64\n"
                               "[sun]\nangular_radius = 5\ndate = 2024 3 2\nhour = 11\nlatitude = 40\n";
    (void)state;
    for (int t = 0; light_techniques[t]; t++) {
        struct support_log log;
        struct dpl_scene *scene = support_scene(text, support_log_start(&log));
        struct dpl_renderer *renderer = dpl_renderer_create(NULL, DPL_DEVICE_CPU, &log.log);
        struct dpl_image *maps[2] = {NULL};
        if (light_techniques[t]->physical && light_techniques[t]->trace &&
            strcmp(light_techniques[t]->name, "reference")) {
            double elevation, azimuth;
            support_set(scene, "caustics.technique", light_techniques[t]->name);
            support_set(scene, "sun.by", "clock");
            maps[0] = dpl_renderer_map(renderer, scene, 0);
            optics_sun_angles(&scene->sun, &elevation, &azimuth);
            support_set(scene, "sun.by", "angles");
            support_set(scene, "sun.elevation", "%.17g", elevation);
            support_set(scene, "sun.azimuth", "%.17g", azimuth);
            maps[1] = dpl_renderer_map(renderer, scene, 0);
            assert_memory_equal(maps[0]->pixels, maps[1]->pixels, 64 * 64 * 3 * sizeof(float));
        }
        for (int m = 0; m < 2; m++)
            dpl_image_destroy(maps[m]);
        dpl_renderer_destroy(renderer);
        dpl_scene_destroy(scene);
        assert_int_equal(log.errors, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_sun_stands_where_others_say), cmocka_unit_test(the_sun_rises_and_sets_in_time),
        cmocka_unit_test(seasons_come_when_they_should),   cmocka_unit_test(clocks_agree),
        cmocka_unit_test(the_scene_follows_the_clock),     cmocka_unit_test(light_follows_the_clock),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
