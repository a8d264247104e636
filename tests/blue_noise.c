/* Blue noise: every rank once; without clumps, of which white noise is full; the same for the same seed. */
#include "support.h"

#include "base/blue_noise.h"

enum { SIDE = BLUE_NOISE_SIDE, COUNT = SIDE * SIDE };

static void ranks_are_a_permutation(void **state)
{
    (void)state;
    static int ranks[COUNT], again[COUNT], other[COUNT];
    bool seen[COUNT] = {false};
    blue_noise(0, ranks);
    blue_noise(0, again);
    blue_noise(1, other);
    assert_memory_equal(ranks, again, sizeof ranks);
    assert_true(memcmp(ranks, other, sizeof ranks) != 0);
    for (int i = 0; i < COUNT; i++) {
        assert_true(ranks[i] >= 0 && ranks[i] < COUNT && !seen[ranks[i]]);
        seen[ranks[i]] = true;
    }
}

/* Power of the waves of at most `most` periods a side, in units of what white noise has on average: 1. */
static double low_power(const double values[COUNT], int most)
{
    double sum = 0, square = 0, waves = 0;
    for (int i = 0; i < COUNT; i++)
        square += values[i] * values[i];
    for (int v = -most; v <= most; v++) {
        for (int u = -most; u <= most; u++) {
            double real = 0, imaginary = 0;
            if ((u == 0 && v == 0) || u * u + v * v > most * most)
                continue;
            for (int i = 0; i < COUNT; i++) {
                double angle = 2 * M_PI * (u * (i % SIDE) + v * (i / SIDE)) / SIDE;
                real += values[i] * cos(angle);
                imaginary += values[i] * sin(angle);
            }
            sum += real * real + imaginary * imaginary;
            waves++;
        }
    }
    return sum / waves / square;
}

/* Ranks, and those below a threshold, as values with the mean 0. Shuffled, they are white noise of the same values. */
static void low_frequencies_are_missing(void **state)
{
    (void)state;
    static int ranks[COUNT];
    static double values[COUNT];
    uint64_t random = 9;
    blue_noise(3, ranks);
    for (int threshold = 0; threshold <= 3; threshold++) {
        int below = COUNT * threshold / 4; /* 0: the ranks themselves */
        for (int i = 0; i < COUNT; i++)
            values[i] = threshold ? (ranks[i] < below) - threshold / 4.0 : (ranks[i] + 0.5) / COUNT - 0.5;
        double blue = low_power(values, 8);
        for (int i = COUNT - 1; i > 0; i--) {
            int j = (int)(support_random_unit(&random) * (i + 1));
            double kept = values[i];
            values[i] = values[j];
            values[j] = kept;
        }
        double white = low_power(values, 8);
        assert_true(fabs(white - 1) < 0.3); /* 196 waves, of which half are independent: 1 ± 0.1 */
        assert_true(blue < 0.1 * white);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ranks_are_a_permutation),
        cmocka_unit_test(low_frequencies_are_missing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
