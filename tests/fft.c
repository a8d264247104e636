/* The Fourier transform against the sum that it stands for, in double precision. */
#include "support.h"

#include "base/fft.h"
#include "base/threads.h"

#include <complex.h>
#include <math.h>

#define SIDE_MAX 45

static void fill(float (*grid)[2], int count)
{
    uint64_t random = 7;
    for (int i = 0; i < count; i++)
        for (int part = 0; part < 2; part++)
            grid[i][part] = (float)support_random_unit(&random) - 0.5f;
}

/* One entry of the transform, as defined. */
static double complex entry_of(float (*grid)[2], int side, int row, int column, bool inverse)
{
    double complex sum = 0;
    for (int j = 0; j < side; j++) {
        for (int i = 0; i < side; i++) {
            double angle = (inverse ? 2 : -2) * M_PI * ((row * j + column * i) % side) / side;
            sum += ((double)grid[j * side + i][0] + I * (double)grid[j * side + i][1]) * cexp(I * angle);
        }
    }
    return sum;
}

static void every_entry_is_the_sum_that_defines_it(void **state)
{
    static const int sides[] = {1, 2, 7, 16, 18, 45};
    float before[SIDE_MAX * SIDE_MAX][2], grid[SIDE_MAX * SIDE_MAX][2];
    (void)state;
    for (int k = 0; k < 12; k++) {
        int side = sides[k / 2], step = side > 20 ? 11 : 1;
        struct fft *fft = fft_create(side, k % 2, NULL);
        fill(before, side * side);
        memcpy(grid, before, sizeof grid);
        fft_run(fft, grid);
        for (int i = 0; i < side * side; i += step) {
            double complex wanted = entry_of(before, side, i / side, i % side, k % 2);
            assert_true(fabs((double)grid[i][0] - creal(wanted)) < 1e-5 * side);
            assert_true(fabs((double)grid[i][1] - cimag(wanted)) < 1e-5 * side);
        }
        fft_destroy(fft);
    }
}

/* Also where there are now more threads than the plan was made for. */
static void threads_do_not_show(void **state)
{
    const int side = 40;
    float grids[2][40 * 40][2];
    (void)state;
    for (int k = 0; k < 2; k++) {
#ifdef _OPENMP
        omp_set_num_threads(1);
#endif
        struct fft *fft = fft_create(side, false, NULL);
#ifdef _OPENMP
        omp_set_num_threads(1 + 4 * k);
#endif
        fill(grids[k], side * side);
        fft_run(fft, grids[k]);
        fft_destroy(fft);
    }
    assert_memory_equal(grids[0], grids[1], sizeof grids[0]);
    fft_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_entry_is_the_sum_that_defines_it),
        cmocka_unit_test(threads_do_not_show),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
