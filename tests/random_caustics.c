/* Light by wave theory: the waves' correlation, weak scattering in closed form, rays. */
#include "support.h"

#include "light/random_caustics.h"

#include <math.h>

static const struct random_caustics_recipe recipe = {
    .side = 64,
    .frames = 16,
    .seed = 1,
    .colors = 1,
    .tile = 4,
    .loop = 4,
    .correlation = 0.3,
    .height = 0.02,
    .depth = 1,
    .ior = 4.0 / 3,
};

static void begin(struct random_caustics *caustics, const struct random_caustics_recipe *changed)
{
    assert_true(random_caustics_begin(caustics, changed, NULL));
}

/* The mean product of heights `shift` texels apart along both axes, of all frames. */
static double covariance(struct random_caustics *caustics, int shift)
{
    int side = caustics->recipe.side;
    double sum = 0;
    for (int frame = 0; frame < caustics->recipe.frames; frame++) {
        random_caustics_heights(caustics, frame);
        for (int j = 0; j < side; j++)
            for (int i = 0; i < side; i++)
                sum += (double)caustics->heights[j * side + i] *
                       (double)(caustics->heights[j * side + (i + shift) % side] +
                                caustics->heights[(j + shift) % side * side + i]) /
                       2;
    }
    return sum / side / side / caustics->recipe.frames;
}

static void heights_have_the_wanted_correlation(void **state)
{
    struct random_caustics caustics = {0};
    (void)state;
    begin(&caustics, &recipe);
    for (int shift = 0; shift < 12; shift++) {
        double wanted = exp(-pow(shift * recipe.tile / recipe.side / recipe.correlation, 2));
        double found = covariance(&caustics, shift) / recipe.height / recipe.height;
        if (fabs(found - wanted) > 0.03)
            fail_msg("%d: %f (%f)", shift, found, wanted);
    }
    random_caustics_finish(&caustics);
}

/* The end of the loop is its start; a finer grid has the same waves; another seed has others. */
static void waves_repeat_and_do_not_depend_on_the_grid(void **state)
{
    struct random_caustics coarse = {0}, fine = {0};
    struct random_caustics_recipe finer = recipe;
    (void)state;
    finer.side = 2 * recipe.side;
    begin(&coarse, &recipe);
    begin(&fine, &finer);
    random_caustics_heights(&coarse, recipe.frames);
    random_caustics_heights(&fine, 0);
    for (int j = 0; j < recipe.side; j++)
        for (int i = 0; i < recipe.side; i++)
            assert_true(fabs((double)(coarse.heights[j * recipe.side + i] - fine.heights[2 * (j * finer.side + i)])) <
                        1e-4 * recipe.height);
    finer.seed++;
    float before = fine.heights[0];
    begin(&fine, &finer);
    random_caustics_heights(&fine, 0);
    assert_true(fine.heights[0] != before);
    random_caustics_finish(&coarse);
    random_caustics_finish(&fine);
}

static double variance_of_light(struct random_caustics *caustics)
{
    int count = caustics->recipe.side * caustics->recipe.side;
    float *light = calloc((size_t)count, sizeof *light);
    double sum = 0, squares = 0;
    for (int frame = 0; frame < caustics->recipe.frames; frame++) {
        random_caustics_light(caustics, frame, light);
        for (int i = 0; i < count; i++) {
            sum += (double)light[i];
            squares += pow((double)light[i], 2);
        }
    }
    free(light);
    sum /= (double)count * caustics->recipe.frames;
    return squares / ((double)count * caustics->recipe.frames) / sum / sum - 1;
}

/* Weak scattering: a screen whose phases have the variance v and the correlation exp(-r²/ℓ²) gives, by the integral of
 * 4 sin²(π λ z f²) over their spectrum, the scintillation index 2 v D²/(1 + D²), D = 2 λ z/(π ℓ²), λ in the water. */
static void scintillation_is_that_of_weak_scattering(void **state)
{
    static const double depths[] = {1, 4, 12};
    (void)state;
    for (int i = 0; i < 3; i++) {
        double found = 0;
        struct random_caustics caustics = {0};
        struct random_caustics_recipe weak = recipe;
        weak.height = 0.001;
        weak.wavelength = 0.02;
        weak.depth = depths[i];
        for (weak.seed = 1; weak.seed <= 3; weak.seed++) {
            begin(&caustics, &weak);
            found += variance_of_light(&caustics) / 3;
        }
        double phase = 2 * M_PI * (weak.ior - 1) * weak.height / weak.wavelength;
        double d = 2 * weak.wavelength / weak.ior * weak.depth / (M_PI * weak.correlation * weak.correlation);
        double wanted = 2 * phase * phase * d * d / (1 + d * d);
        if (fabs(found / wanted - 1) > 0.03)
            fail_msg("depth %g: %g (%g)", weak.depth, found, wanted);
        random_caustics_finish(&caustics);
    }
}

/* Just below the waves light gathers under crests as rays do: 1 - (1 - 1/n) depth Δh. */
static void light_gathers_under_crests_as_rays_do(void **state)
{
    struct random_caustics caustics = {0};
    struct random_caustics_recipe shallow = recipe;
    int side = shallow.side = 128;
    double spacing = shallow.tile / side, squares = 0, errors = 0;
    float *light = calloc((size_t)(side * side), sizeof *light);
    (void)state;
    shallow.correlation = 0.5;
    shallow.depth = 0.05;
    begin(&caustics, &shallow);
    random_caustics_light(&caustics, 3, light);
    const float *h = caustics.heights;
    for (int j = 0; j < side; j++) {
        for (int i = 0; i < side; i++) {
            double around = (double)(h[j * side + (i + 1) % side] + h[j * side + (i + side - 1) % side] +
                                     h[(j + 1) % side * side + i] + h[(j + side - 1) % side * side + i]);
            double bend = (around - 4 * (double)h[j * side + i]) / spacing / spacing;
            double wanted = -(1 - 1 / shallow.ior) * shallow.depth * bend;
            squares += wanted * wanted;
            errors += pow((double)light[j * side + i] - 1 - wanted, 2);
        }
    }
    assert_true(sqrt(squares) / side > 0.005);
    if (sqrt(errors / squares) > 0.03)
        fail_msg("off by %g", sqrt(errors / squares));
    free(light);
    random_caustics_finish(&caustics);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(heights_have_the_wanted_correlation),
        cmocka_unit_test(waves_repeat_and_do_not_depend_on_the_grid),
        cmocka_unit_test(scintillation_is_that_of_weak_scattering),
        cmocka_unit_test(light_gathers_under_crests_as_rays_do),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
