/* Pictures: every look draws every kind of water; the pool's colours against its formulas, in OpenGL 3.3 and in OpenGL
 * ES 3.0. */
#include "support.h"

#include "scene/look.h"

#include <math.h>

struct fixture {
    struct support_log log;
    struct dpl_gl *gl;
    struct dpl_renderer *renderer;
};

static void start(struct fixture *fixture, bool es)
{
    *fixture = (struct fixture){0};
    const struct dpl_log *log = support_log_start(&fixture->log);
    fixture->gl = support_gl(es, log);
    fixture->renderer = dpl_renderer_create(fixture->gl, DPL_DEVICE_AUTO, log);
}

static void finish(struct fixture *fixture)
{
    assert_int_equal(fixture->log.errors, 0);
    dpl_renderer_destroy(fixture->renderer);
    dpl_gl_destroy(fixture->gl);
}

/* Some of it is brighter than the rest, and all of it can be shown. */
static void check_picture(struct fixture *fixture, const struct dpl_scene *scene)
{
    struct dpl_image *image = dpl_renderer_picture(fixture->renderer, scene, 0.7, 48, 32);
    float least = 1, most = 0;
    assert_non_null(image);
    for (int i = 0; i < 48 * 32 * 3; i++) {
        assert_true(image->pixels[i] >= 0 && image->pixels[i] <= 1);
        least = fminf(least, image->pixels[i]);
        most = fmaxf(most, image->pixels[i]);
    }
    assert_true(most > least + 0.1f);
    dpl_image_destroy(image);
}

/* Whatever the water, from above and from below, with the ball and without. */
static void check_looks(struct fixture *fixture)
{
    static const char *const waters[] = {
        "[water]\nmodel = sines\n[wave.1]\ncycles = 2 1\namplitude = 0.05\n",
        "[water]\nmodel = collard\n[caustics]\nslices = 3\n",
        "[water]\nmodel = ripples\n[ripples]\nside = 40\n[caustics]\nwindow = light\nslices = 2\n",
    };
    for (int w = 0; w < 3; w++) {
        struct dpl_scene *scene = support_scene(waters[w], &fixture->log.log);
        support_set(scene, "caustics.map", "32");
        support_set(scene, "sphere.position", "-0.4 -0.6 0.2");
        support_set(scene, "look.path-traced.passes", "1");
        support_set(scene, "look.path-traced.mesh", "128");
        for (int i = 0; scene_looks[i]; i++) {
            support_set(scene, "render.look", "%s", scene_looks[i]->name);
            /* looks without meshes to show draw all the same */
            support_set(scene, "render.wireframe", scene_looks[i]->linear ? "yes" : "no");
            for (int below = 0; below < 2; below++) {
                support_set(scene, "camera.position", "0.3 %g 0.9", below ? -0.6 : 0.9);
                support_set(scene, "sphere.radius", "%g", below ? 0 : 0.25);
                check_picture(fixture, scene);
                support_set(scene, "sphere.radius", "%g", below ? 0.25 : 0);
                check_picture(fixture, scene);
            }
        }
        dpl_scene_destroy(scene);
    }
}

#define SIZE 4.0
#define DEPTH 1.3
#define IOR 1.4
#define EYE 2.5 /* m above the water, looking straight down, -z up in the picture */
#define PIXELS 64
static const char flat_pool[] =
    "[scene]\nsize = 4\ndepth = 1.3\n[water]\nmodel = sines\nior = 1.4\n[sun]\nelevation = 90\n"
    "angular_radius = 0\n[caustics]\nmap = 32\n[render]\nlook = pool\n[look.pool]\n"
    "tiles = 1\ntile_contrast = 0\ntile_color = 0.7 0.7 0.7\nrim = 0\nground = 0 0 0\n"
    "sky_zenith = 0.5 0.5 0.5\nsky_horizon = 0.5 0.5 0.5\nsun_exponent = 100000\n";

/* What a pixel shows that sees the floor of calm water, its tile's middle and nothing else; NAN where it sees other
 * things. */
static double floor_green(int column, int row)
{
    double x = (2 * (column + 0.5) / PIXELS - 1) * tan(M_PI / 8), z = (2 * (row + 0.5) / PIXELS - 1) * tan(M_PI / 8);
    double length = hypot(x, z), sine = length / sqrt(1 + length * length) / IOR;
    double tangent = sine / sqrt(1 - sine * sine), way = EYE + DEPTH * tangent / fmax(length, 1e-9);
    double half = SIZE / 2, place[3] = {x * way / half, -1, z * way / half};
    if (fabs(place[0]) > 0.8 || fabs(place[2]) > 0.8)
        return NAN;
    double around = 0.5 / sqrt(place[0] * place[0] + 1 + place[2] * place[2]), sun = 2 * 0.2;
    double share = 0.25 + 0.75 * pow(1 - 1 / sqrt(1 + length * length), 3);
    return (1 - share) * 0.7 * (around + sun) + share * 0.5; /* tint_above's green is 1 */
}

static void check_floor(struct fixture *fixture)
{
    int seen = 0;
    struct dpl_scene *scene = support_scene(flat_pool, &fixture->log.log);
    support_set(scene, "camera.position", "0 %g 0", EYE);
    support_set(scene, "camera.target", "0 0 0");
    struct dpl_image *image = dpl_renderer_picture(fixture->renderer, scene, 0, PIXELS, PIXELS);
    assert_non_null(image);
    for (int row = 0; row < PIXELS; row += 3) {
        for (int column = 0; column < PIXELS; column += 3) {
            double expected = floor_green(column, row);
            double found = (double)image->pixels[(row * PIXELS + column) * 3 + 1];
            if (isnan(expected))
                continue;
            seen++;
            if (fabs(found - expected) > 0.01)
                fail_msg("pixel %d, %d: %.4f instead of %.4f", column, row, found, expected);
        }
    }
    assert_true(seen > 200);
    dpl_image_destroy(image);
    dpl_scene_destroy(scene);
}

/* From below the sky stands in a circle, asin(1 / index) wide; around it the water mirrors the floor, which is dark
 * here. */
static void check_window(struct fixture *fixture)
{
    enum { WIDTH = 256 };
    const double edge = tan(asin(1 / IOR)) / tan(60 * M_PI / 180), pixel = 2.0 / WIDTH;
    struct dpl_scene *scene = support_scene(flat_pool, &fixture->log.log);
    support_set(scene, "scene.depth", "0.2");
    support_set(scene, "look.pool.ambient", "0");
    support_set(scene, "look.pool.caustic", "0");
    support_set(scene, "camera.field_of_view", "120");
    support_set(scene, "camera.position", "0 -0.19 0");
    support_set(scene, "camera.target", "0 0 0");
    struct dpl_image *image = dpl_renderer_picture(fixture->renderer, scene, 0, WIDTH, WIDTH);
    assert_non_null(image);
    for (int column = 0; column < WIDTH; column++) {
        double from_middle = fabs((column + 0.5) * pixel - 1);
        float seen = image->pixels[(WIDTH / 2 * WIDTH + column) * 3 + 1];
        if (from_middle < edge - pixel)
            assert_true(seen > 0.02f);
        if (from_middle > edge + pixel)
            assert_true(seen < 0.01f);
    }
    dpl_image_destroy(image);
    dpl_scene_destroy(scene);
}

static void check(bool es)
{
    struct fixture fixture;
    start(&fixture, es);
    check_looks(&fixture);
    check_floor(&fixture);
    check_window(&fixture);
    finish(&fixture);
}

static void pictures_are_right(void **state)
{
    (void)state;
    check(false);
}

static void pictures_are_right_in_es(void **state)
{
    (void)state;
    check(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_are_right),
        cmocka_unit_test(pictures_are_right_in_es),
    };
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
