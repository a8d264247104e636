/* Where the physical look shows things, in OpenGL 3.3 and OpenGL ES 3.0: through flat water, mirrored in it, in Snell's
 * window, through an aquarium's pane, and with the lens half in the water; against Snell's law.
 *
 * A thing is found by drawing the scene with it and without it. */
#include "physical.h"

#define WIDTH 120
#define HEIGHT 80
#define LEAST 3e-4 /* by which pixels differ that show a thing */
#define TANK "[scene]\nsize = 1\ndepth = 0.6\nedge = glass\n[floor]\ncolor = 0 0 0\n" /* 1 m wide */
#define ANYWHERE 180 /* degrees: all that differs counts */
#define NEAR 3       /* what is farther off is the image in another pane */

/* The picture with an object `marker` of that shape, size and place, and without it. */
struct pair {
    struct dpl_image *with, *without;
};

static struct pair draw_pair(struct physical_fixture *fixture, struct dpl_scene *scene, const char *shape,
                             const double middle[3], const double size[3])
{
    struct pair pair;
    support_set(scene, "object.marker.shape", "%s", shape);
    support_set(scene, "object.marker.on_floor", "no");
    support_set(scene, "object.marker.position", "%.17g %.17g %.17g", middle[0], middle[1] - size[1] / 2, middle[2]);
    support_set(scene, "object.marker.size", "%.17g %.17g %.17g", size[0], size[1], size[2]);
    support_set(scene, "object.marker.casts", "no");
    pair.with = physical_radiance(fixture, scene, WIDTH, HEIGHT);
    support_set(scene, "object.marker.position", "%.17g -30 %.17g", middle[0], middle[2]); /* below the floor */
    pair.without = physical_radiance(fixture, scene, WIDTH, HEIGHT);
    return pair;
}

static void finish_pair(struct pair *pair)
{
    dpl_image_destroy(pair->with);
    dpl_image_destroy(pair->without);
}

/* Where they differ, within `around` degrees of a direction. */
static struct physical_spot spot_near(const struct dpl_scene *scene, const struct pair *pair, const double direction[3],
                                      double around)
{
    struct physical_spot spot = {0, 0, 0};
    for (int row = 0; row < HEIGHT; row++) {
        for (int column = 0; column < WIDTH; column++) {
            double ray[3],
                change = physical_pixel(pair->with, column, row, 1) - physical_pixel(pair->without, column, row, 1);
            physical_ray(scene, pair->with, column + 0.5, row + 0.5, ray);
            if (fabs(change) <= LEAST || physical_angle(ray, direction) > around)
                continue;
            spot.count++;
            spot.x += column + 0.5;
            spot.y += row + 0.5;
        }
    }
    spot.x /= spot.count;
    spot.y /= spot.count;
    return spot;
}

/* Fails unless the pictures differ around where `expected` is seen, within `most` degrees; `around`: as above. */
static void expect_seen(const char *what, const struct dpl_scene *scene, const struct pair *pair,
                        const double expected[3], double most, double around)
{
    struct physical_spot spot = spot_near(scene, pair, expected, around);
    double found[3];
    if (spot.count < 8)
        fail_msg("%s: not seen, %d pixels", what, spot.count);
    physical_ray(scene, pair->with, spot.x, spot.y, found);
    if (!(physical_angle(found, expected) <= most))
        fail_msg("%s: %g degrees off", what, physical_angle(found, expected));
}

/* A thin white plate on the floor, seen from the air at ever lower angles. At high quality a texel of what is seen
 * through the water is a pixel, here 0.15°. */
static void check_from_above(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(fixture, "[floor]\ncolor = 0 0 0\n");
    for (double away = 0; away < 5; away += 1.6) {
        const double eye[3] = {away * 0.6, 0.8, away * 0.8}, size[3] = {0.12, 0.002, 0.12};
        double cross = physical_crossing(0.8, 1, away, PHYSICAL_IOR);
        double expected[3] = {-0.6 * cross, -0.8, -0.8 * cross}, target[3];
        for (int c = 0; c < 3; c++) /* not in the picture's middle */
            target[c] = eye[c] + expected[c] + (c == 0 ? 0.05 : 0.02);
        physical_normalize(expected);
        physical_look(scene, eye, target, 12);
        struct pair pair = draw_pair(fixture, scene, "box", (const double[3]){0, -0.999, 0}, size);
        expect_seen("a plate on the floor", scene, &pair, expected, 0.25, ANYWHERE);
        finish_pair(&pair);
    }
    dpl_scene_destroy(scene);
}

/* The same from in the water: a ball in the air, through the window. */
static void check_from_below(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(fixture, "[floor]\ncolor = 0 0 0\n[sky]\nbrightness = 0.1\n");
    physical_bright_sky(fixture, scene);
    for (double away = 0; away < 3; away += 0.9) {
        const double eye[3] = {away, -0.7, 0.1}, size[3] = {0.1, 0.1, 0.1};
        double cross = physical_crossing(0.7, 1, away, 1 / PHYSICAL_IOR);
        double expected[3] = {-cross, 0.7, 0}, target[3];
        for (int c = 0; c < 3; c++)
            target[c] = eye[c] + expected[c] + (c == 2 ? 0.05 : 0.02);
        physical_normalize(expected);
        physical_look(scene, eye, target, 14);
        struct pair pair = draw_pair(fixture, scene, "sphere", (const double[3]){0, 1, 0.1}, size);
        expect_seen("a ball in the air", scene, &pair, expected, 0.3, ANYWHERE);
        finish_pair(&pair);
    }
    dpl_scene_destroy(scene);
}

/* A ball in the air is seen straight, and in the water below it, mirrored; so is one in the water, from in it, where
 * the water throws back all. A texel of what is mirrored is as wide as two pixels, 0.4°. */
static void check_mirrored(struct physical_fixture *fixture)
{
    static const char *const names[2][2] = {{"a ball in the water", "its image in total reflection"},
                                            {"a ball in the air", "its mirror image"}};
    struct dpl_scene *scene = physical_scene(fixture, "[floor]\ncolor = 0 0 0\n");
    physical_bright_sky(fixture, scene);
    for (int i = 0; i < 4; i++) {
        bool above = i & 1, mirrored = i & 2;
        const double eye[3] = {0.3, above ? 0.6 : -0.4, 2.2}, ball[3] = {0, above ? 0.5 : -0.5, 0};
        double expected[3], target[3];
        for (int c = 0; c < 3; c++) {
            expected[c] = (mirrored && c == 1 ? -1 : 1) * ball[c] - eye[c];
            target[c] = eye[c] + expected[c] + 0.05;
        }
        physical_normalize(expected);
        physical_look(scene, eye, target, 16);
        struct pair pair = draw_pair(fixture, scene, "sphere", ball, (const double[3]){0.16, 0.16, 0.16});
        expect_seen(names[above][mirrored], scene, &pair, expected, 0.25, ANYWHERE);
        finish_pair(&pair);
    }
    dpl_scene_destroy(scene);
}

/* From in the water the sky stands in a circle of 48.6° about the zenith, and outside it the black floor. The picture
 * is 12° high there, across the edge, to several sides. */
static void check_window(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(fixture, "[floor]\ncolor = 0 0 0\n");
    const double edge = asin(1 / PHYSICAL_IOR);
    physical_bright_sky(fixture, scene);
    for (int azimuth = 10; azimuth < 360; azimuth += 70) {
        const double level = tan(edge), eye[3] = {0.3, -0.5, 0.1};
        const double target[3] = {eye[0] + level * cos(azimuth * PHYSICAL_DEGREE), 0.5,
                                  eye[2] + level * sin(azimuth * PHYSICAL_DEGREE)};
        physical_look(scene, eye, target, 12);
        struct dpl_image *image = physical_radiance(fixture, scene, WIDTH, HEIGHT);
        int row = 0;
        while (row < HEIGHT && physical_pixel(image, WIDTH / 2, row, 1) > 0.05)
            row++;
        for (int below = row; below < HEIGHT; below++)
            assert_true(physical_pixel(image, WIDTH / 2, below, 1) <= 1e-3);
        double ray[3];
        physical_ray(scene, image, WIDTH / 2.0, row, ray);
        double found = acos(ray[1]) / PHYSICAL_DEGREE;
        if (!(fabs(found - edge / PHYSICAL_DEGREE) < 0.2))
            fail_msg("azimuth %d: the window ends at %g degrees", azimuth, found);
        dpl_image_destroy(image);
    }
    dpl_scene_destroy(scene);
}

/* How bright the sky is in the window: as Fresnel lets it in, and n² times as bright, as its light comes from a wider
 * angle. */
static void check_window_brightness(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(fixture, "[floor]\ncolor = 0 0 0\n");
    physical_bright_sky(fixture, scene);
    physical_look(scene, (const double[3]){0, -0.5, 0}, (const double[3]){0, 0, 0}, 90);
    struct dpl_image *image = physical_radiance(fixture, scene, WIDTH, HEIGHT);
    for (int column = WIDTH / 2; column < WIDTH; column++) {
        double ray[3];
        physical_ray(scene, image, column + 0.5, HEIGHT / 2.0 + 0.5, ray);
        double inside = acos(ray[1]), sine = PHYSICAL_IOR * sin(inside);
        double share = sine >= 1 ? 1 : physical_reflectance(asin(sine), inside);
        double expected = PHYSICAL_IOR * PHYSICAL_IOR * (1 - share);
        double found = physical_pixel(image, column, HEIGHT / 2, 1);
        if (fabs(inside - asin(1 / PHYSICAL_IOR)) > 0.003 && fabs(found - expected) > 0.003)
            fail_msg("%g degrees: %g, not %g", inside / PHYSICAL_DEGREE, found, expected);
    }
    dpl_image_destroy(image);
    dpl_scene_destroy(scene);
}

/* Half in the water: sky, and water that mirrors it, above a line, and the black floor below it; where the lens, the
 * near plane, meets the water. */
static void check_line(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(fixture, "[floor]\ncolor = 0 0 0\n[camera]\nnear_plane = 0.1\n");
    physical_bright_sky(fixture, scene);
    for (int i = -2; i <= 2; i++) {
        const double height = 0.01 * i, eye[3] = {0.2, height, 1};
        physical_look(scene, eye, (const double[3]){0.2, height, 0}, 50);
        struct dpl_image *image = physical_radiance(fixture, scene, WIDTH, HEIGHT);
        double line = HEIGHT / 2.0 * (1 + height / 0.1 / tan(25 * PHYSICAL_DEGREE));
        for (int column = 5; column < WIDTH; column += 22)
            for (int row = 0; row < HEIGHT; row++) {
                double found = physical_pixel(image, column, row, 1), from_line = row + 0.5 - line;
                if (fabs(from_line) > 0.51 && (from_line < 0 ? found < 0.2 : found > 1e-3))
                    fail_msg("%g m above the water, row %d, the line in row %g: %g", height, row, line, found);
            }
        dpl_image_destroy(image);
    }
    dpl_scene_destroy(scene);
}

/* The direction in which an eye outside a tank of 1 m sees a place in it, through the pane ahead on that axis. */
static void through_pane(const double eye[3], const double place[3], int ahead, double direction[3])
{
    int beside = 2 - ahead;
    double before = eye[ahead] - 0.5, beyond = 0.5 - place[ahead];
    double along[2] = {place[beside] - eye[beside], place[1] - eye[1]}, level = hypot(along[0], along[1]);
    double cross = physical_crossing(before, beyond, level, PHYSICAL_IOR);
    direction[ahead] = -before;
    direction[beside] = along[0] * cross / level;
    direction[1] = along[1] * cross / level;
    physical_normalize(direction);
}

static const double ball_size[3] = {0.08, 0.08, 0.08};

/* A ball in a tank, from outside it: through the pane that is between, as through any plane; the last through the one
 * that faces the eye less. A texel of the layer is 0.9°; the water's line is in it, too. */
static void check_pane(struct physical_fixture *fixture)
{
    static const struct {
        double eye[3], ball[3];
        int ahead;
    } cases[] = {{{0, -0.3, 1.5}, {0.1, -0.35, -0.1}, 2},
                 {{0.9, -0.25, 1.4}, {0.1, -0.35, -0.1}, 2},
                 {{-1.5, -0.1, 1.8}, {0.1, -0.35, -0.1}, 2},
                 {{1.6, -0.35, 0.6}, {0.1, -0.35, -0.1}, 0},
                 {{1.2, -0.25, 1.3}, {0.35, -0.35, -0.25}, 0}};
    struct dpl_scene *scene = physical_scene(fixture, TANK);
    physical_bright_sky(fixture, scene);
    for (int i = 0; i < 5; i++) {
        double expected[3];
        through_pane(cases[i].eye, cases[i].ball, cases[i].ahead, expected);
        physical_look(scene, cases[i].eye, (const double[3]){0, -0.3, 0.1}, 35);
        struct pair pair = draw_pair(fixture, scene, "sphere", cases[i].ball, ball_size);
        expect_seen("a ball in a tank", scene, &pair, expected, 0.45, NEAR);
        finish_pair(&pair);
    }
    dpl_scene_destroy(scene);
}

/* In a side pane, which throws back all, it is seen as if it were as far beyond that. */
static void check_side_pane(struct physical_fixture *fixture)
{
    const double eye[3] = {0.9, -0.25, 1.4}, ball[3] = {-0.35, -0.35, -0.25}, image[3] = {-0.65, -0.35, -0.25};
    struct dpl_scene *scene = physical_scene(fixture, TANK);
    double expected[3];
    physical_bright_sky(fixture, scene);
    physical_look(scene, eye, (const double[3]){0, -0.3, 0.1}, 35);
    struct pair pair = draw_pair(fixture, scene, "sphere", ball, ball_size);
    through_pane(eye, ball, 2, expected);
    expect_seen("a ball near a side pane", scene, &pair, expected, 0.45, NEAR);
    through_pane(eye, image, 2, expected);
    expect_seen("its image in that", scene, &pair, expected, 0.45, NEAR);
    finish_pair(&pair);
    dpl_scene_destroy(scene);
}

/* From above the tank, through the surface: a ball, and its image in the pane behind it. */
static void check_tank_from_above(struct physical_fixture *fixture)
{
    static const char *const names[2] = {"a ball in a tank from above", "its image from above"};
    const double eye[3] = {0.2, 0.9, 1}, ball[3] = {0, -0.35, -0.3}, away[2] = {1.3, 1.7};
    struct dpl_scene *scene = physical_scene(fixture, TANK);
    physical_bright_sky(fixture, scene);
    physical_look(scene, eye, (const double[3]){0.05, -0.1, -0.2}, 35);
    struct pair pair = draw_pair(fixture, scene, "sphere", ball, ball_size);
    for (int i = 0; i < 2; i++) {
        double level = hypot(eye[0], away[i]), cross = physical_crossing(0.9, 0.35, level, PHYSICAL_IOR);
        double expected[3] = {-eye[0] * cross / level, -0.9, -away[i] * cross / level};
        physical_normalize(expected);
        expect_seen(names[i], scene, &pair, expected, 0.45, NEAR);
    }
    finish_pair(&pair);
    dpl_scene_destroy(scene);
}

static void check(bool es)
{
    struct physical_fixture fixture;
    physical_start(&fixture, es);
    check_from_above(&fixture);
    check_from_below(&fixture);
    check_mirrored(&fixture);
    check_window(&fixture);
    check_window_brightness(&fixture);
    check_line(&fixture);
    check_pane(&fixture);
    check_side_pane(&fixture);
    check_tank_from_above(&fixture);
    physical_finish(&fixture);
}

static void things_are_seen_where_they_should_be(void **state)
{
    (void)state;
    check(false);
}

static void things_are_seen_where_they_should_be_in_es(void **state)
{
    (void)state;
    check(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(things_are_seen_where_they_should_be),
                                       cmocka_unit_test(things_are_seen_where_they_should_be_in_es)};
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
