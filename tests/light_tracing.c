/* photons, beams and hemisphere against light that can be worked out: flat water, plane waves, means, and the share of
 * useful candidates. */
#include "support.h"

#include "light/tracing.h"
#include "plane_wave.h"

#define SIDE 96
#define SIZE 2.0 /* m */

struct fixture {
    struct support_log log;
    struct dpl_renderer *renderer;
    struct dpl_scene *scene;
};

static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    support_log_start(&fixture->log);
    fixture->renderer = dpl_renderer_create(NULL, DPL_DEVICE_CPU, &fixture->log.log);
    fixture->scene = support_scene("[scene]\nsize = 2\n[water]\nmodel = sines\n[caustics]\nmap = 96\nmesh = 70\n",
                                   &fixture->log.log);
    *state = fixture;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *fixture = *state;
    int errors = fixture->log.errors;
    dpl_renderer_destroy(fixture->renderer);
    dpl_scene_destroy(fixture->scene);
    free(fixture);
    return errors;
}

static struct dpl_image *map_of(struct fixture *fixture, const char *technique)
{
    support_set(fixture->scene, "caustics.technique", "%s", technique);
    struct dpl_image *map = dpl_renderer_map(fixture->renderer, fixture->scene, 0);
    if (!map)
        fail_msg("%s", fixture->log.text);
    return map;
}

/* The map's mean, and the RMS of its difference from `wanted` (NULL: 1), a value for each column, both of one colour.
 * `rows`: columns are averaged first. Destroys the map. */
struct fit {
    double mean, error;
};
static struct fit fit_of(struct dpl_image *map, int color, const double *wanted, bool rows)
{
    struct fit fit = {0};
    double squares = 0;
    int count = map->width * map->height;
    for (int i = 0; i < map->width; i++) {
        double column = 0;
        for (int j = 0; j < map->height; j++) {
            double value = (double)map->pixels[(j * map->width + i) * 3 + color];
            column += value / map->height;
            squares += rows ? 0 : pow(value - (wanted ? wanted[i] : 1), 2) / count;
        }
        squares += rows ? pow(column - (wanted ? wanted[i] : 1), 2) / map->width : 0;
        fit.mean += column / map->width;
    }
    fit.error = sqrt(squares);
    dpl_image_destroy(map);
    return fit;
}

/* Every texel once: sides that share no factor put centres of texels on and beside edges of triangles. */
static void beams_tile_flat_water(void **state)
{
    static const int sides[] = {96, 97, 35, 70, 140};
    struct fixture *fixture = *state;
    for (int i = 0; i < 5; i++) {
        for (int elevation = 90; elevation > 0; elevation -= 35) {
            support_set(fixture->scene, "caustics.map", "%d", sides[i]);
            support_set(fixture->scene, "sun.elevation", "%d", elevation);
            struct dpl_image *map = map_of(fixture, "beams");
            for (int k = 0; k < map->width * map->height * 3; k++)
                assert_true(fabs((double)map->pixels[k] - 1) < 2e-6); /* sums are in parts of 2^-20 */
            dpl_image_destroy(map);
        }
    }
}

/* A texel's photons are as many as chance makes them: the count's root. A photon that is shared out by a bilinear tent
 * has (2/3)² of the variance of a whole one. */
static void photons_on_flat_water_have_the_grain_of_their_number(void **state)
{
    struct fixture *fixture = *state;
    for (int i = 0; i < 4; i++) {
        int count = i / 2 ? 25 : 4;
        support_set(fixture->scene, "photons.count", "%d", count);
        support_set(fixture->scene, "photons.spread", i % 2 ? "bilinear" : "nearest");
        struct fit fit = fit_of(map_of(fixture, "photons"), 1, NULL, false);
        double wanted = (i % 2 ? 2.0 / 3 : 1) / sqrt(count);
        assert_true(fabs(fit.mean - 1) < 5e-5);
        assert_true(fabs(fit.error / wanted - 1) < 0.03); /* 9216 texels */
    }
}

/* The share of candidates that the log tells. */
static double useful_share(struct fixture *fixture)
{
    double share = 0;
    assert_int_equal(sscanf(fixture->log.text, "hemisphere: %lf %%", &share), 1);
    fixture->log.text[0] = '\0';
    return share / 100;
}

/* Seen from under flat water the lamp has a 1/n² of its size in the air, but for its own foreshortening: 1 for a lamp
 * that is overhead. */
static void the_share_of_useful_candidates_is_the_lamps_of_the_cone(void **state)
{
    static const struct {
        double lamp, cone, elevation;
    } cases[] = {{1, 6, 90}, {0, 3, 90}, {10, 90, 90}, {30, 40, 90}, {1, 6, 40}};
    struct fixture *fixture = *state;
    support_set(fixture->scene, "sun.angular_radius", "0.5");
    support_set(fixture->scene, "hemisphere.candidates", "100");
    for (int i = 0; i < 5; i++) {
        double radius = (cases[i].lamp > 0 ? cases[i].lamp : 0.5) * M_PI / 180, cone = cases[i].cone * M_PI / 180;
        double in = (90 - cases[i].elevation) * M_PI / 180, ior = 1.333, out = asin(sin(in) / ior);
        support_set(fixture->scene, "hemisphere.lamp", "%g", cases[i].lamp);
        support_set(fixture->scene, "hemisphere.cone", "%g", cases[i].cone);
        support_set(fixture->scene, "sun.elevation", "%g", cases[i].elevation);
        struct fit fit = fit_of(map_of(fixture, "hemisphere"), 1, NULL, false);
        double lamp = in > 0 ? radius * radius / 2 * cos(in) / cos(out) / (ior * ior) /* a small one */
                             : 1 - cos(asin(sin(radius) / ior));
        double wanted = lamp / (1 - cos(cone)), share = useful_share(fixture);
        if (!(fabs(share / wanted - 1) < 0.01 && fabs(fit.mean - 1) < 0.01))
            fail_msg("%.3g instead of %.3g, mean %.4f: case %d", share, wanted, fit.mean, i);
    }
}

/* Told once, and again when it may have changed. */
static void the_share_is_told_once(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "caustics.map", "8");
    dpl_image_destroy(map_of(fixture, "hemisphere"));
    assert_true(useful_share(fixture) > 0);
    dpl_image_destroy(map_of(fixture, "hemisphere"));
    assert_string_equal(fixture->log.text, "");
    support_set(fixture->scene, "hemisphere.cone", "3");
    dpl_image_destroy(map_of(fixture, "hemisphere"));
    assert_true(useful_share(fixture) > 0);
}

/* A receiver below or above a plane wave, whose crests focus at 2.5 m below and whose troughs do at 0.3 m above. */
struct plane_case {
    double receiver;                   /* m */
    double sun[3];                     /* degrees: elevation, azimuth, angular radius */
    double cone;                       /* degrees, of candidates */
    double beams, photons, hemisphere; /* accepted: RMS over columns; 0: not tried */
};

static void expect_columns(struct fixture *fixture, const struct plane_case *expected, const char *technique,
                           double tolerance)
{
    const struct optics_sun sun = {
        .elevation = expected->sun[0], .azimuth = expected->sun[1], .angular_radius = expected->sun[2]};
    double columns[SIDE];
    for (int c = 0; c < 3; c += 2) {
        const struct plane_wave wave = {SIZE, 2, 0.04, 1.333 + (c - 1) * 0.05, c ? 0.03 : 0.35};
        wave_columns(&wave, &sun, expected->receiver, SIDE, columns);
        struct fit fit = fit_of(map_of(fixture, technique), c, columns, true);
        if (!(fit.error < tolerance))
            fail_msg("%s: off by %.3f, receiver %g m, sun %g°, colour %d", technique, fit.error, expected->receiver,
                     sun.elevation, c);
    }
}

/* Folds, the side that light goes to, colours, reflection. */
static void a_plane_wave_gives_the_sum_over_its_folds(void **state)
{
    static const struct plane_case cases[] = {
        {-0.8, {90, 0, 0}, 10, 0.02, 0, 0},  {-0.8, {50, 200, 0}, 10, 0.05, 0, 0}, {0.1, {50, 200, 0}, 40, 0.2, 0, 0},
        {-1.2, {90, 0, 1}, 8, 0, 0.04, 0.1}, {-5, {50, 200, 1}, 8, 0, 0.05, 0.15}, {1, {50, 20, 1}, 40, 0, 0.06, 0.55},
    };
    struct fixture *fixture = *state;
    support_set(fixture->scene, "wave.1.cycles", "2 0");
    support_set(fixture->scene, "wave.1.amplitude", "0.04");
    support_set(fixture->scene, "water.dispersion", "0.1");
    support_set(fixture->scene, "water.absorption", "0.35 0.07 0.03");
    support_set(fixture->scene, "hemisphere.lamp", "0");
    support_set(fixture->scene, "hemisphere.candidates", "100");
    for (int i = 0; i < 6; i++) {
        const struct plane_case *c = cases + i;
        support_set(fixture->scene, "sun.elevation", "%g", c->sun[0]);
        support_set(fixture->scene, "sun.azimuth", "%g", c->sun[1]);
        support_set(fixture->scene, "sun.angular_radius", "%g", c->sun[2]);
        support_set(fixture->scene, "scene.depth", "%g", fabs(c->receiver));
        support_set(fixture->scene, "caustics.ceiling", "%g", fmax(c->receiver, 0));
        support_set(fixture->scene, "hemisphere.cone", "%g", c->cone);
        if (c->beams > 0)
            expect_columns(fixture, c, "beams", c->beams);
        if (c->photons > 0)
            expect_columns(fixture, c, "photons", c->photons);
        if (c->hemisphere > 0)
            expect_columns(fixture, c, "hemisphere", c->hemisphere);
    }
}

/* Light that is folded over itself is neither lost nor made: the mean is that of exact coverage. */
static void no_light_is_lost_behind_the_focus(void **state)
{
    static const struct {
        const char *technique;
        double tolerance;
    } cases[] = {{"photons", 0.003}, {"beams", 0.03}, {"hemisphere", 0.02}};
    struct fixture *fixture = *state;
    support_set(fixture->scene, "scene.depth", "4");
    support_set(fixture->scene, "caustics.mesh", "150");
    support_set(fixture->scene, "wave.1.cycles", "2 1");
    support_set(fixture->scene, "wave.1.amplitude", "0.03");
    support_set(fixture->scene, "wave.2.cycles", "-1 3");
    support_set(fixture->scene, "wave.2.amplitude", "0.02");
    support_set(fixture->scene, "hemisphere.cone", "8");
    double wanted = fit_of(map_of(fixture, "coverage"), 1, NULL, false).mean;
    for (int i = 0; i < 3; i++) {
        double mean = fit_of(map_of(fixture, cases[i].technique), 1, NULL, false).mean;
        if (!(fabs(mean / wanted - 1) < cases[i].tolerance))
            fail_msg("%s: mean %.4f instead of %.4f", cases[i].technique, mean, wanted);
    }
}

static void light_that_is_no_number_is_none(void **state)
{
    struct tracing_sums sums = {0};
    float texel[3];
    (void)state;
    assert_true(tracing_sums_start(&sums, 1, NULL));
    tracing_sums_add(&sums, 0, 0, (const double[3]){NAN, -1, 2});
    tracing_sums_read(&sums, (const double[3]){1, 1, 1}, texel);
    assert_true(texel[0] == 0 && texel[1] == 0 && texel[2] == 2);
    tracing_sums_finish(&sums);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_that_is_no_number_is_none),
        cmocka_unit_test_setup_teardown(beams_tile_flat_water, setup, teardown),
        cmocka_unit_test_setup_teardown(photons_on_flat_water_have_the_grain_of_their_number, setup, teardown),
        cmocka_unit_test_setup_teardown(the_share_of_useful_candidates_is_the_lamps_of_the_cone, setup, teardown),
        cmocka_unit_test_setup_teardown(the_share_is_told_once, setup, teardown),
        cmocka_unit_test_setup_teardown(no_light_is_lost_behind_the_focus, setup, teardown),
        cmocka_unit_test_setup_teardown(a_plane_wave_gives_the_sum_over_its_folds, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
