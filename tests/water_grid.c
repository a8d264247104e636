/* Water known as heights on a grid: what lies between the vertices, and beyond the edges. */
#include "support.h"
#include "water.h"

#include "water/grid.h"

#include <math.h>

enum { SIDE = 12 };
static const double size = 3;

static double spacing_of(const struct height_grid *grid)
{
    return grid->size / (grid->periodic ? grid->side : grid->side - 1);
}

static void sample_grid(const struct height_grid *grid, double x, double z, double out[3])
{
    struct water_points points = {.count = 1, .x = &x, .z = &z, .height = out, .slope_x = out + 1, .slope_z = out + 2};
    grid_sample(grid, &points);
}

/* Random heights of -1 to 1 m. */
static struct height_grid random_grid(bool periodic, float heights[SIDE * SIDE])
{
    uint64_t random = 17;
    for (int i = 0; i < SIDE * SIDE; i++)
        heights[i] = (float)(2 * support_random_unit(&random) - 1);
    return (struct height_grid){SIDE, periodic, size, heights};
}

/* Catmull-Rom's own promise: polynomials of second degree come out as they are, inside. */
static void a_paraboloid_is_exact(void **state)
{
    (void)state;
    float heights[SIDE * SIDE];
    struct height_grid grid = {SIDE, false, size, heights};
    double spacing = spacing_of(&grid);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double x = i % SIDE * spacing - size / 2, z = i / SIDE * spacing - size / 2;
        heights[i] = (float)(0.3 + 0.2 * x - 0.1 * z + 0.05 * x * x - 0.08 * z * z + 0.03 * x * z);
    }
    uint64_t random = 5;
    for (int i = 0; i < 200; i++) {
        double x = (support_random_unit(&random) - 0.5) * (size - 2 * spacing), out[3];
        double z = (support_random_unit(&random) - 0.5) * (size - 2 * spacing);
        sample_grid(&grid, x, z, out);
        assert_true(fabs(out[0] - (0.3 + 0.2 * x - 0.1 * z + 0.05 * x * x - 0.08 * z * z + 0.03 * x * z)) < 1e-7);
        assert_true(fabs(out[1] - (0.2 + 0.1 * x + 0.03 * z)) < 1e-6);
        assert_true(fabs(out[2] - (-0.1 - 0.16 * z + 0.03 * x)) < 1e-6);
    }
}

static void vertices_and_samples_agree(void **state)
{
    (void)state;
    for (int periodic = 0; periodic < 2; periodic++) {
        float heights[SIDE * SIDE];
        struct height_grid grid = random_grid(periodic, heights);
        struct surface surface = {0};
        double spacing = spacing_of(&grid);
        assert_true(surface_resize(&surface, SIDE, SIDE, periodic, false, size, NULL));
        grid_fill(&grid, &surface);
        for (int i = 0; i < SIDE * SIDE; i++) {
            double out[3];
            sample_grid(&grid, i % SIDE * spacing - size / 2, i / SIDE * spacing - size / 2, out);
            for (int c = 0; c < 3; c++)
                assert_true(fabs(out[c] - (double)surface.texels[3 * i + c]) < 2e-6);
        }
        surface_finish(&surface);
    }
}

/* Across edges of cells and of the grid, where a wrong stencil would show as a step. */
static void slopes_are_the_derivative_everywhere(void **state)
{
    (void)state;
    for (int periodic = 0; periodic < 2; periodic++) {
        float heights[SIDE * SIDE];
        struct height_grid grid = random_grid(periodic, heights);
        uint64_t random = 99;
        for (int i = 0; i < 2000; i++) {
            double x = (support_random_unit(&random) - 0.5) * 2 * size, step = 1e-5, here[3], before[3], after[3];
            double z = (support_random_unit(&random) - 0.5) * 2 * size;
            sample_grid(&grid, x, z, here);
            sample_grid(&grid, x - step, z, before);
            sample_grid(&grid, x + step, z, after);
            assert_true(fabs((after[0] - before[0]) / (2 * step) - here[1]) < 1e-3);
            sample_grid(&grid, x, z - step, before);
            sample_grid(&grid, x, z + step, after);
            assert_true(fabs((after[0] - before[0]) / (2 * step) - here[2]) < 1e-3);
        }
    }
}

static void beyond_the_edge_water_repeats_or_stays(void **state)
{
    (void)state;
    float heights[SIDE * SIDE];
    for (int periodic = 0; periodic < 2; periodic++) {
        struct height_grid grid = random_grid(periodic, heights);
        for (int j = 0; j < SIDE; j++) {
            double z = j * spacing_of(&grid) - size / 2, here[3], there[3];
            sample_grid(&grid, size / 2 - 1e-3 * periodic, z, here);
            sample_grid(&grid, periodic ? -size / 2 - 1e-3 : 1e9, z, there);
            assert_true(fabs(here[0] - there[0]) < 1e-9);
            assert_true(periodic || there[1] == 0);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_paraboloid_is_exact),
        cmocka_unit_test(vertices_and_samples_agree),
        cmocka_unit_test(slopes_are_the_derivative_everywhere),
        cmocka_unit_test(beyond_the_edge_water_repeats_or_stays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
