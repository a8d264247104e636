/* Two techniques in one picture: each part is what its technique draws alone, and what differs is shown and measured.
 */
#include "support.h"

#include <math.h>

#define WIDTH 96
#define HEIGHT 64

struct fixture {
    struct support_log log;
    struct dpl_gl *gl;
    struct dpl_renderer *renderer;
    struct dpl_scene *scene;
};

static const char scene_text[] = "[water]\nmodel = sines\n[wave.1]\ncycles = 2 1\namplitude = 0.02\n"
                                 "[caustics]\nmap = 64\nmesh = 64\n[reference]\nphotons = 16\n";

static void start(struct fixture *fixture, bool es)
{
    *fixture = (struct fixture){0};
    const struct dpl_log *log = support_log_start(&fixture->log);
    fixture->gl = support_gl(es, log);
    fixture->renderer = dpl_renderer_create(fixture->gl, DPL_DEVICE_AUTO, log);
    fixture->scene = support_scene(scene_text, log);
}

static void finish(struct fixture *fixture)
{
    assert_int_equal(fixture->log.errors, 0);
    dpl_renderer_destroy(fixture->renderer);
    dpl_scene_destroy(fixture->scene);
    dpl_gl_destroy(fixture->gl);
}

static int technique(const char *name)
{
    int i = 0;
    while (strcmp(dpl_technique(i).name, name))
        i++;
    return i;
}

static struct dpl_image *picture(struct fixture *fixture, const char *name, const struct dpl_compare *compare)
{
    support_set(fixture->scene, "caustics.technique", "%s", name);
    dpl_renderer_compare(fixture->renderer, compare);
    struct dpl_image *image = dpl_renderer_picture(fixture->renderer, fixture->scene, 1, WIDTH, HEIGHT);
    assert_non_null(image);
    return image;
}

/* Pixels of columns from … to - 1 that are not the same in both. */
static int different(const struct dpl_image *a, const struct dpl_image *b, int from, int to)
{
    int count = 0;
    for (int j = 0; j < HEIGHT; j++)
        for (int i = from; i < to; i++)
            count += memcmp(a->pixels + (j * WIDTH + i) * 3, b->pixels + (j * WIDTH + i) * 3, 3 * sizeof(float)) != 0;
    return count;
}

static void check_split(bool es)
{
    struct fixture fixture;
    start(&fixture, es);
    struct dpl_compare compare = {.technique = technique("reference")};
    struct dpl_image *left = picture(&fixture, "multi-sample", &compare);
    struct dpl_image *right = picture(&fixture, "reference", &compare);
    assert_true(different(left, right, 0, WIDTH) > WIDTH * HEIGHT / 4);
    compare.mode = DPL_COMPARE_SPLIT;
    const double places[] = {-1, 0, 0.25, 0.5, 1, 7};
    for (size_t p = 0; p < sizeof places / sizeof *places; p++) {
        compare.place = places[p];
        int edge = (int)lround(fmin(fmax(places[p], 0), 1) * WIDTH);
        struct dpl_image *split = picture(&fixture, "multi-sample", &compare);
        assert_int_equal(different(split, left, 0, edge), 0);
        assert_int_equal(different(split, right, edge, WIDTH), 0);
        dpl_image_destroy(split);
    }
    dpl_image_destroy(left);
    dpl_image_destroy(right);
    finish(&fixture);
}

static void each_part_is_what_its_technique_draws(void **state)
{
    (void)state;
    check_split(false);
}

static void each_part_is_what_its_technique_draws_es(void **state)
{
    (void)state;
    check_split(true);
}

/* The pixel in the middle of the picture, which shows the floor. */
static void middle_of_difference(struct fixture *fixture, const char *name, double gain, float color[3])
{
    struct dpl_compare compare = {DPL_COMPARE_DIFFERENCE, technique("reference"), 0, gain, 1};
    struct dpl_image *image = picture(fixture, name, &compare);
    memcpy(color, image->pixels + (HEIGHT / 2 * WIDTH + WIDTH / 2) * 3, 3 * sizeof *color);
    dpl_image_destroy(image);
}

static void differences_have_their_colors(void **state)
{
    struct fixture fixture;
    float color[3], expected[3];
    const double tolerance = 0.05; /* colours change by up to 1 over a difference of 1, and the noise is 2 % */
    const double gains[] = {1, 0, 0.5, 2};
    (void)state;
    start(&fixture, false);
    /* Of flat water the map is 1: the difference of the reference from itself is the gain less 1. */
    support_set(fixture.scene, "wave.1.amplitude", "0");
    support_set(fixture.scene, "reference.photons", "1000000");
    support_set(fixture.scene, "reference.noise", "2");
    for (size_t i = 0; i < sizeof gains / sizeof *gains; i++) {
        middle_of_difference(&fixture, "reference", gains[i], color);
        dpl_false_color(DPL_COLORS_DIFFERENCE, gains[i] - 1, expected);
        for (int c = 0; c < 3; c++)
            assert_float_equal(color[c], expected[c], tolerance);
    }
    finish(&fixture);
}

static void maps_are_measured(void **state)
{
    struct fixture fixture;
    struct dpl_measure measure, expected;
    (void)state;
    start(&fixture, false);
    assert_false(dpl_renderer_measure(fixture.renderer, &measure));
    EXPECT_ERROR(&fixture.log, DPL_REASON_UNSUPPORTED, "nothing to measure");
    struct dpl_compare compare = {DPL_COMPARE_SPLIT, technique("reference"), 0.5, 1, 1};
    dpl_image_destroy(picture(&fixture, "multi-sample", &compare));
    assert_true(dpl_renderer_measure(fixture.renderer, &measure));
    assert_true(dpl_renderer_noise(fixture.renderer) > 0);
    struct dpl_image *map = dpl_renderer_map(fixture.renderer, fixture.scene, 1);
    assert_true(dpl_renderer_noise(fixture.renderer) == 0);
    support_set(fixture.scene, "caustics.technique", "reference");
    struct dpl_image *reference = dpl_renderer_map(fixture.renderer, fixture.scene, 1);
    assert_true(dpl_measure_map(map, reference, true, dpl_renderer_noise(fixture.renderer), &expected, NULL));
    assert_true(measure.error == expected.error && measure.p99 == expected.p99 && measure.gain == expected.gain);
    assert_true(measure.error > 0.05 && measure.gain != 1);
    dpl_image_destroy(map);
    dpl_image_destroy(reference);
    finish(&fixture);
}

static bool stop(void *user, double done)
{
    *(double *)user = done;
    return false;
}

/* What refines its map step by step goes on with each picture of the same time, and starts anew with another. */
static void a_still_reference_gets_better(void **state)
{
    struct fixture fixture;
    struct dpl_compare compare = {DPL_COMPARE_SPLIT, technique("reference"), 0.5, 1, 1};
    double done = 0, noise = INFINITY;
    (void)state;
    start(&fixture, false);
    support_set(fixture.scene, "reference.photons", "100000");
    dpl_renderer_progress(fixture.renderer, stop, &done);
    for (int i = 0; i < 8; i++) {
        double before = done;
        dpl_image_destroy(picture(&fixture, "multi-sample", &compare));
        assert_true(done > before && done < 1);
        if (i % 4 == 3) { /* chance makes single steps uneven */
            assert_true(dpl_renderer_noise(fixture.renderer) < noise);
            noise = dpl_renderer_noise(fixture.renderer);
        }
    }
    double before = done;
    dpl_image_destroy(dpl_renderer_picture(fixture.renderer, fixture.scene, 1.1, WIDTH, HEIGHT));
    assert_true(done < before);
    finish(&fixture);
}

/* Radiance is that of the scene's technique, whatever pictures compare, and of any size. */
static void radiance_is_not_compared(void **state)
{
    struct fixture fixture;
    struct dpl_compare compare = {.technique = technique("reference"), .gain = 1, .range = 1};
    (void)state;
    start(&fixture, false);
    support_set(fixture.scene, "render.look", "physical");
    support_set(fixture.scene, "render.quality", "low");
    struct dpl_image *alone = dpl_renderer_radiance(fixture.renderer, fixture.scene, 1, WIDTH, HEIGHT);
    for (int mode = DPL_COMPARE_SPLIT; mode <= DPL_COMPARE_DIFFERENCE; mode++) {
        compare.mode = (enum dpl_comparison)mode;
        dpl_renderer_compare(fixture.renderer, &compare);
        struct dpl_image *large = dpl_renderer_radiance(fixture.renderer, fixture.scene, 1, 8 * WIDTH, HEIGHT);
        struct dpl_image *beside = dpl_renderer_radiance(fixture.renderer, fixture.scene, 1, WIDTH, HEIGHT);
        assert_int_equal(different(alone, beside, 0, WIDTH), 0);
        dpl_image_destroy(beside);
        dpl_image_destroy(large);
    }
    dpl_image_destroy(alone);
    finish(&fixture);
}

int main(void)
{
    if (!support_has_gl())
        return SUPPORT_SKIPPED;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_part_is_what_its_technique_draws),
        cmocka_unit_test(each_part_is_what_its_technique_draws_es),
        cmocka_unit_test(differences_have_their_colors),
        cmocka_unit_test(maps_are_measured),
        cmocka_unit_test(a_still_reference_gets_better),
        cmocka_unit_test(radiance_is_not_compared),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
