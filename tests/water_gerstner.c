/* Steep waves of `sines` against Gerstner's parametric surface, written out a second time. */
#include "support.h"
#include "water.h"

#include <math.h>

#define SIZE 4.0

static const struct water_model *sines(void)
{
    int i = 0;
    while (strcmp(water_models[i]->name, "sines"))
        i++;
    return water_models[i];
}

static struct water_setup setup_of(const struct wave *waves, int count)
{
    return (struct water_setup){.size = SIZE, .depth = 1000, .mesh = 64, .waves = waves, .wave_count = count};
}

/* A wave whose steepness is k A moves every point round a circle of radius A, under the crests the way it runs. */
static void a_point_goes_round_a_circle(void **state)
{
    (void)state;
    const double amplitude = 0.1, k = 2 * M_PI * 5 / SIZE, period = 2;
    const struct wave wave = {{3, -4}, amplitude, 0, period, k * amplitude};
    const struct water_setup setup = setup_of(&wave, 1);
    for (int i = 0; i < 32; i++) {
        struct water_point point = sample_point(sines(), &setup, period * i / 32, 0, 0);
        double turn = 2 * M_PI * i / 32;
        assert_true(fabs(point.height - amplitude * cos(turn)) < 1e-12);
        assert_true(fabs(point.shift[0] - 0.6 * amplitude * sin(turn)) < 1e-12);
        assert_true(fabs(point.shift[1] + 0.8 * amplitude * sin(turn)) < 1e-12);
    }
}

/* The surface is J⁻¹ ∇h steep and det J wide, by differences of the place (x + shift, height) in a second formula. */
struct place {
    double x, z, height;
};

static struct place place_of(const struct water_setup *setup, double sum, double x, double z)
{
    struct place place = {x, z, 0};
    for (int w = 0; w < setup->wave_count; w++) {
        const struct wave *wave = setup->waves + w;
        double cycles = hypot(wave->cycles[0], wave->cycles[1]);
        double angle = 2 * M_PI * (wave->cycles[0] * x + wave->cycles[1] * z) / SIZE + wave->phase * M_PI / 180;
        double shift = wave->steepness / fmax(sum, 1) * SIZE / (2 * M_PI * cycles) * sin(angle);
        place.x -= shift * wave->cycles[0] / cycles;
        place.z -= shift * wave->cycles[1] / cycles;
        place.height += wave->amplitude * cos(angle);
    }
    return place;
}

static double fill_waves(struct wave *waves, int count, double steepest)
{
    uint64_t random = 5;
    double sum = 0;
    for (int w = 0; w < count; w++) {
        waves[w] = (struct wave){{(int)(support_random(&random) % 21) - 10, (int)(support_random(&random) % 10) + 1},
                                 support_random_unit(&random) * 0.01,
                                 support_random_unit(&random) * 360,
                                 0,
                                 w % 3 ? steepest * support_random_unit(&random) : 0};
        sum += waves[w].steepness;
    }
    return sum;
}

static void check_point(const struct water_setup *setup, double sum, double x, double z)
{
    const double step = 1e-5;
    struct place here = place_of(setup, sum, x, z), ends[2][2];
    for (int side = 0; side < 2; side++) {
        ends[0][side] = place_of(setup, sum, x + (side ? step : -step), z);
        ends[1][side] = place_of(setup, sum, x, z + (side ? step : -step));
    }
    double xx = (ends[0][1].x - ends[0][0].x) / (2 * step), xz = (ends[0][1].z - ends[0][0].z) / (2 * step);
    double zx = (ends[1][1].x - ends[1][0].x) / (2 * step), zz = (ends[1][1].z - ends[1][0].z) / (2 * step);
    double rise_x = (ends[0][1].height - ends[0][0].height) / (2 * step);
    double rise_z = (ends[1][1].height - ends[1][0].height) / (2 * step);
    double area = xx * zz - xz * zx;
    struct water_point point = sample_point(sines(), setup, 0, x, z);
    assert_true(fabs(point.height - here.height) < 1e-12);
    assert_true(fabs(x + point.shift[0] - here.x) < 1e-12 && fabs(z + point.shift[1] - here.z) < 1e-12);
    assert_true(fabs(point.area - area) < 1e-7);
    if (area < 0.02)
        return; /* too near a cusp for differences */
    assert_true(fabs(point.slope[0] - (zz * rise_x - xz * rise_z) / area) < 1e-6 / area);
    assert_true(fabs(point.slope[1] - (xx * rise_z - zx * rise_x) / area) < 1e-6 / area);
}

static void slopes_and_areas_are_those_of_the_moved_surface(void **state)
{
    (void)state;
    static const struct {
        int count;
        double steepest;
    } cases[] = {{2, 0.9}, {9, 0.1}, {WATER_WAVES_MAX, 0.03}, {WATER_WAVES_MAX, 1}};
    struct wave waves[WATER_WAVES_MAX];
    for (int k = 0; k < 4; k++) {
        double sum = fill_waves(waves, cases[k].count, cases[k].steepest);
        struct water_setup setup = setup_of(waves, cases[k].count);
        for (int i = 0; i < 1000; i++)
            check_point(&setup, sum, (i * 0.618 - floor(i * 0.618) - 0.5) * SIZE, (i / 1000.0 - 0.5) * SIZE);
    }
}

/* Steepness 1, alone or as a sum that is more: the surface touches itself and never folds; slopes stay finite. */
static void nothing_folds(void **state)
{
    (void)state;
    struct wave waves[3];
    for (int w = 0; w < 3; w++)
        waves[w] = (struct wave){{4, 0}, 0.1, 0, 0, 1};
    for (int count = 1; count <= 3; count += 2) {
        struct water_setup setup = setup_of(waves, count);
        double least = 1;
        for (int i = 0; i < 4000; i++) {
            struct water_point point = sample_point(sines(), &setup, 0.3, i * SIZE / 4000, 0.2);
            least = fmin(least, point.area);
            assert_true(isfinite(point.slope[0]) && point.slope[1] == 0);
        }
        assert_true(least > -1e-12 && least < 1e-5);
    }
}

static void only_steep_waves_with_a_length_are_choppy(void **state)
{
    (void)state;
    struct wave waves[] = {{{1, 2}, 0.1, 0, 0, 0}, {{0, 0}, 0.1, 0, 0, 1}, {{0, 3}, 0, 0, 0, 0.01}};
    for (int count = 0; count <= 3; count++) {
        struct water_setup setup = setup_of(waves, count);
        assert_int_equal(sines()->shape(&setup).choppy, count == 3);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_point_goes_round_a_circle),
        cmocka_unit_test(slopes_and_areas_are_those_of_the_moved_surface),
        cmocka_unit_test(nothing_folds),
        cmocka_unit_test(only_steep_waves_with_a_length_are_choppy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
