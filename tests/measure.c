/* Measures of one image against another, against values worked out by hand and against the authors' own ꟻLIP. */
#include "support.h"

#include <math.h>

#define WIDTH 96
#define HEIGHT 64

/* Waves and a ramp, 0 to 1; `shift` moves the waves of the first channel. */
static struct dpl_image *make_waves(double shift)
{
    struct dpl_image *image = dpl_image_create(WIDTH, HEIGHT, NULL);
    assert_non_null(image);
    for (int j = 0; j < HEIGHT; j++)
        for (int i = 0; i < WIDTH; i++) {
            float *pixel = image->pixels + (j * WIDTH + i) * 3;
            pixel[0] = (float)(0.5 + 0.5 * sin(0.21 * i + 0.13 * j + shift));
            pixel[1] = (float)(0.5 + 0.5 * sin(0.005 * i * j));
            pixel[2] = (float)i / WIDTH;
        }
    return image;
}

static struct dpl_image *make_plain(double red, double green, double blue)
{
    const double color[3] = {red, green, blue};
    struct dpl_image *image = dpl_image_create(WIDTH, HEIGHT, NULL);
    assert_non_null(image);
    for (int i = 0; i < WIDTH * HEIGHT * 3; i++)
        image->pixels[i] = (float)color[i % 3];
    return image;
}

static void scale(struct dpl_image *image, double factor)
{
    for (int i = 0; i < WIDTH * HEIGHT * 3; i++)
        image->pixels[i] = (float)(image->pixels[i] * factor);
}

static struct dpl_measure measure(const struct dpl_image *image, const struct dpl_image *reference, bool fit)
{
    struct dpl_measure result;
    assert_true(dpl_measure_map(image, reference, fit, 0, &result, NULL));
    return result;
}

static void alike(void **state)
{
    (void)state;
    struct dpl_image *image = make_waves(0);
    for (int fit = 0; fit < 2; fit++) {
        struct dpl_measure result = measure(image, image, fit);
        assert_true(result.error == 0 && result.p99 == 0 && result.energy == 1 && result.gain == 1);
    }
    dpl_image_destroy(image);
}

static void known_errors(void **state)
{
    (void)state;
    struct dpl_image *image = make_plain(1, 2, 3), *reference = make_plain(2, 2, 2);
    struct dpl_measure result = measure(image, reference, false);
    const double tolerance = 1e-7; /* a difference passes through a float */
    assert_float_equal(result.error, sqrt(2.0 / 12), tolerance);
    assert_float_equal(result.p99, 0.5, tolerance);
    assert_float_equal(result.energy, 1, tolerance);
    assert_float_equal(result.gain, 1, tolerance);
    result = measure(image, reference, true);
    assert_float_equal(result.gain, 12.0 / 14, tolerance);
    assert_float_equal(result.energy, 12.0 / 14, tolerance);
    assert_float_equal(result.error, sqrt((12 - 144.0 / 14) / 12), tolerance);
    assert_float_equal(result.p99, (2 - 12.0 / 14) / 2, tolerance);
    dpl_image_destroy(image);
    dpl_image_destroy(reference);
}

/* The gain of least error is found, and with it a map that differs by a factor alone has no error. */
static void fitted_gain(void **state)
{
    (void)state;
    struct dpl_image *image = make_waves(0), *reference = make_waves(0);
    scale(image, 0.3);
    assert_true(fabs(measure(image, reference, false).error - 0.7) < 1e-6); /* floats have 24 bits */
    struct dpl_measure fitted = measure(image, reference, true);
    assert_true(fitted.error < 1e-6 && fabs(fitted.gain - 1 / 0.3) < 1e-5 && fabs(fitted.energy - 1) < 1e-6);
    dpl_image_destroy(image);
    dpl_image_destroy(reference);
}

/* Noise of the reference that has nothing to do with the image's error does not show. */
static void noise_is_taken_out(void **state)
{
    (void)state;
    struct dpl_image *image = make_plain(1, 1, 1), *reference = make_plain(1, 1, 1);
    struct dpl_measure result;
    const double error = 0.01, noise = 0.05;
    for (int i = 0; i < WIDTH * HEIGHT * 3; i++) {
        image->pixels[i] += (float)(i & 2 ? error : -error);
        reference->pixels[i] += (float)(i & 1 ? noise : -noise);
    }
    double size = sqrt(1 + noise * noise);
    assert_true(dpl_measure_map(image, reference, false, noise / size, &result, NULL));
    assert_true(fabs(result.error - error / size) < 1e-6); /* floats near 1 */
    assert_true(dpl_measure_map(image, reference, false, 1, &result, NULL));
    assert_true(result.error == 0);
    dpl_image_destroy(image);
    dpl_image_destroy(reference);
}

/* The 99th percentile is the largest difference but for the one in a hundred that lie above it. */
static void percentile(void **state)
{
    (void)state;
    struct dpl_image *image = make_plain(1, 1, 1), *reference = make_plain(1, 1, 1);
    const int count = WIDTH * HEIGHT * 3, rank = (count * 99 + 99) / 100, above = count - rank;
    const double rank_share = (double)rank / count;
    for (int i = 0; i < above; i++)
        image->pixels[(i * 7919) % count] = -100;
    assert_true(measure(image, reference, false).p99 == 0);
    image->pixels[(above * 7919) % count] = 1.25f;
    assert_true(measure(image, reference, false).p99 == 0.25);
    for (int i = 0; i < count; i++)
        image->pixels[(i * 7919) % count] = 1 + (float)(i + 1) / (float)count;
    assert_float_equal(measure(image, reference, false).p99, rank_share, 1e-6); /* floats near 2 */
    dpl_image_destroy(image);
    dpl_image_destroy(reference);
}

static void refused(void **state)
{
    (void)state;
    struct support_log log;
    struct dpl_measure result;
    double mean;
    struct dpl_image *image = make_waves(0), *reference = make_waves(0);
    struct dpl_image *other = dpl_image_create(WIDTH, HEIGHT + 1, NULL);
    support_log_start(&log);
    assert_false(dpl_measure_map(other, reference, false, 0, &result, &log.log));
    EXPECT_ERROR(&log, DPL_REASON_VALUE, "size", "96 × 65", "96 × 64");
    assert_false(dpl_measure_flip(other, reference, 67, &mean, &log.log));
    EXPECT_ERROR(&log, DPL_REASON_VALUE, "size");
    assert_null(dpl_measure_colors(other, reference, 1, 1, DPL_COLORS_DIFFERENCE, &log.log));
    EXPECT_ERROR(&log, DPL_REASON_VALUE, "size");
    image->pixels[(5 * WIDTH + 7) * 3 + 1] = NAN;
    assert_false(dpl_measure_map(image, reference, false, 0, &result, &log.log));
    EXPECT_ERROR(&log, DPL_REASON_RANGE, "image to measure: not finite", "column 7, row 5");
    assert_false(dpl_measure_map(reference, image, true, 0, &result, &log.log));
    EXPECT_ERROR(&log, DPL_REASON_RANGE, "reference: not finite");
    scale(reference, 0);
    assert_false(dpl_measure_map(reference, reference, false, 0, &result, &log.log));
    EXPECT_ERROR(&log, DPL_REASON_RANGE, "reference: mean", "above 0");
    assert_false(dpl_measure_flip(reference, reference, NAN, &mean, &log.log));
    EXPECT_ERROR(&log, DPL_REASON_RANGE, "pixels per degree", "10 to 1000");
    dpl_image_destroy(image);
    dpl_image_destroy(reference);
    dpl_image_destroy(other);
}

static double flip(const struct dpl_image *picture, const struct dpl_image *reference, double pixels_per_degree)
{
    double mean = -1;
    assert_true(dpl_measure_flip(picture, reference, pixels_per_degree, &mean, NULL));
    return mean;
}

static void flip_properties(void **state)
{
    (void)state;
    struct dpl_image *waves = make_waves(0), *near = make_waves(0.1), *far = make_waves(0.8);
    struct dpl_image *black = make_plain(0, 0, 0), *white = make_plain(1, 1, 1);
    struct dpl_image *green = make_plain(0, 1, 0), *blue = make_plain(0, 0, 1);
    assert_true(flip(waves, waves, 67) == 0);
    assert_true(flip(waves, far, 67) == flip(far, waves, 67));
    assert_true(flip(waves, near, 67) < flip(waves, far, 67));
    assert_float_equal(flip(green, blue, 67), 1, 1e-6); /* the largest distance of all, by definition */
    /* Lightness differs by 100: 0.95 + 0.05 (100^0.7 - k) / (m - k) with k = 0.4 m, m = 41.28 */
    assert_float_equal(flip(black, white, 67), 0.9674, 5e-5);
    struct dpl_image *all[] = {waves, near, far, black, white, green, blue};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        dpl_image_destroy(all[i]);
}

/* Values by the authors' FLIP.h, version 1.6, of the same pictures. It computes in floats: six digits. */
static void flip_as_the_authors(void **state)
{
    (void)state;
    struct dpl_image *waves = make_waves(0), *moved = make_waves(0.4), *darker = make_waves(0);
    const double tolerance = 5e-6;
    scale(darker, 0.8);
    assert_float_equal(flip(moved, waves, 20), 0.279899, tolerance);
    assert_float_equal(flip(moved, waves, 67), 0.289951, tolerance);
    assert_float_equal(flip(moved, waves, 150), 0.266326, tolerance);
    assert_float_equal(flip(darker, waves, 67), 0.634949, tolerance);
    dpl_image_destroy(waves);
    dpl_image_destroy(moved);
    dpl_image_destroy(darker);
}

static double lightness(enum dpl_color_map map, double number)
{
    float color[3];
    dpl_false_color(map, number, color);
    return 0.2126 * pow(color[0], 2.2) + 0.7152 * pow(color[1], 2.2) + 0.0722 * pow(color[2], 2.2);
}

static void false_colors(void **state)
{
    (void)state;
    float color[3];
    dpl_false_color(DPL_COLORS_DIFFERENCE, -1, color);
    assert_true(color[2] > color[0] + 0.3f);
    dpl_false_color(DPL_COLORS_DIFFERENCE, 5, color);
    assert_true(color[0] > color[2] + 0.3f);
    dpl_false_color(DPL_COLORS_DIFFERENCE, 0, color);
    assert_true(color[0] > 0.998f && color[1] > 0.998f && color[2] > 0.998f);
    for (int i = 0; i < 100; i++) {
        double from = i / 100.0, to = (i + 1) / 100.0;
        assert_true(lightness(DPL_COLORS_MAGNITUDE, from) < lightness(DPL_COLORS_MAGNITUDE, to));
        assert_true(lightness(DPL_COLORS_DIFFERENCE, from) > lightness(DPL_COLORS_DIFFERENCE, to));
        assert_true(lightness(DPL_COLORS_DIFFERENCE, -from) > lightness(DPL_COLORS_DIFFERENCE, -to));
    }
    struct dpl_image *image = make_plain(1, 1, 1), *reference = make_plain(1, 2, 3);
    struct dpl_image *colors = dpl_measure_colors(image, reference, 2, 2, DPL_COLORS_DIFFERENCE, NULL);
    assert_non_null(colors); /* (2 - 1 + 2 - 2 + 2 - 3) / 3 is 0: white */
    assert_true(colors->pixels[0] > 0.998f && colors->pixels[1] > 0.998f);
    dpl_image_destroy(colors);
    colors = dpl_measure_colors(image, reference, 1, 2, DPL_COLORS_MAGNITUDE, NULL);
    assert_non_null(colors);
    dpl_false_color(DPL_COLORS_MAGNITUDE, 0.5, color);
    assert_float_equal(colors->pixels[0], color[0], 1e-6);
    dpl_image_destroy(colors);
    dpl_image_destroy(image);
    dpl_image_destroy(reference);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(alike),           cmocka_unit_test(known_errors),
        cmocka_unit_test(fitted_gain),     cmocka_unit_test(noise_is_taken_out),
        cmocka_unit_test(percentile),      cmocka_unit_test(refused),
        cmocka_unit_test(flip_properties), cmocka_unit_test(flip_as_the_authors),
        cmocka_unit_test(false_colors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
