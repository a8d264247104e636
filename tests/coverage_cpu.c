/* The technique `coverage` on the CPU with a point sun: against the plain sum of tests/coverage.h, against light that
 * can be worked out, and against itself. */
#include "coverage_cpu.h"

#include "base/threads.h"

struct expectation {
    int map, mesh, cycles; /* texels, vertices; waves have up to so many cycles */
    bool periodic;
    double steepness, receiver, elevation, azimuth;
};

/* No image is wider than the map: those are spread over all of it. Single precision keeps places to a few 1e-5 of a
 * texel where the ways are long, which moves that much of a cell's light. */
static void a_point_sun_is_the_plain_sum(void **state)
{
    static const struct expectation expectations[] = {
        {64, 64, 4, true, 0.2, -1, 60, 30},   {50, 37, 4, true, 0.2, -2, 90, 0},
        {37, 90, 4, true, 0.3, -3, 30, 200},  {13, 64, 3, true, 0.02, -40, 25, -70}, /* 12 tiles away */
        {1, 20, 4, true, 0.2, -1, 60, 30},    {96, 5, 1, true, 0.2, -1, 45, 10},
        {2, 64, 5, true, 0.2, -0.5, 20, 75},  {70, 70, 3, true, 0.5, -0.02, 35, 120}, /* through the floor */
        {64, 64, 4, true, 0.2, 1, 60, 30},    {61, 80, 3, true, 0.03, 8, 35, 120},
        {64, 64, 4, false, 0.2, -1, 60, 30},  {50, 37, 4, false, 0.2, -2, 90, 0},
        {37, 90, 4, false, 0.3, -3, 30, 200}, {64, 64, 4, false, 0.05, 1, 40, 300},
        {96, 5, 1, false, 0.2, -1, 45, 10},
    };
    struct fixture *fixture = *state;
    for (size_t i = 0; i < sizeof expectations / sizeof *expectations; i++) {
        const struct expectation *e = expectations + i;
        make_random(fixture, 7 + i, e->cycles, e->steepness, e->mesh, e->periodic);
        fixture->receivers[0] = e->receiver;
        fixture->sun = (struct optics_sun){.elevation = e->elevation, .azimuth = e->azimuth, .angular_radius = 0};
        trace(fixture, e->map, 1);
        double error = error_of_sum(fixture, 0, (int)(i % 3));
        if (!(error < 1e-4))
            fail_msg("case %zu: error %g", i, error);
    }
}

/* A fine map whose texels are then averaged is the coarse one, whatever is computed for each texel. */
static void fineness_changes_nothing_for_a_point_sun(void **state)
{
    struct fixture *fixture = *state;
    make_random(fixture, 5, 4, 0.2, 64, true);
    trace(fixture, 50, 1);
    double *coarse = empty_map(50);
    for (int i = 0; i < 2500; i++)
        coarse[i] = (double)fixture->map.texels[3 * i];
    for (int fineness = 1; fineness <= 8; fineness++) {
        fixture->params.fineness = fineness;
        trace(fixture, 50, 1);
        double error = error_of(fixture, 0, 0, coarse);
        if (!(error < 2e-5)) /* as above, in texels that are smaller */
            fail_msg("fineness %d: error %g", fineness, error);
    }
    free(coarse);
}

/* Low suns, dispersion, absorption: no light is lost, and none is made, to the rounding of single precision. (What is
 * thrown back comes from smoother water, so that all of it goes up.) */
static void a_map_has_the_mean_of_the_vertices_weights(void **state)
{
    static const double elevations[] = {20, 35, 60, 90};
    struct fixture *fixture = *state;
    for (int i = 0; i < 16; i++) {
        make_random(fixture, 100 + (uint64_t)i, 6, i & 8 ? 0.04 : 0.15, 50 + i, true);
        fixture->sun = (struct optics_sun){
            .elevation = elevations[i % 4], .azimuth = 77 * i, .angular_radius = i & 4 ? 0.2665 : 0};
        fixture->medium.dispersion = i & 2 ? 0.1 : 0;
        fixture->receivers[0] = i & 8 ? 0.7 : -0.2 - i;
        trace(fixture, 20 + 7 * i, 1);
        for (int c = 0; c < 3; c++) {
            const struct coverage_case sum = plain_case(fixture, 0, c);
            double wanted = 0, mean = mean_of(fixture, 0, c);
            for (int k = 0; k < sum.columns * sum.columns; k++)
                wanted += coverage_vertex(&sum, k % sum.columns, k / sum.columns).weight / (sum.columns * sum.columns);
            if (!(fabs(mean - wanted) < 2e-5))
                fail_msg("case %d, colour %d: mean %.7f instead of %.7f", i, c, mean, wanted);
        }
    }
}

/* Sideways motion that neither folds the surface nor leaves it as it was: light from patches that are pressed together
 * or drawn apart. */
static void choppy_water_is_the_plain_sum(void **state)
{
    static const struct plane_wave waves[] = {
        {{2, 1}, 0.015, 0.5, 2}, {{-1, 3}, 0.01, 2, 1.5}, {{4, 0}, 0.005, -1, -1}, {{0, -5}, 0.005, 0.1, 1}};
    struct fixture *fixture = *state;
    for (int i = 0; i < 8; i++) {
        make_waves(fixture, waves, 4, 48 + 9 * i, i % 2 == 0);
        fixture->sun = (struct optics_sun){.elevation = 90 - 6 * i, .azimuth = 50 * i, .angular_radius = 0};
        fixture->receivers[0] = i & 4 ? 0.1 : -1 - i;
        trace(fixture, 60 - i, 1);
        double error = error_of_sum(fixture, 0, i % 3);
        if (!(error < 5e-5)) /* as for still points */
            fail_msg("case %d: error %g", i, error);
    }
}

/* Bounded water, a map of 60 texels of the tile, and one of 90 of the same size that starts 10 and 20 texels before it:
 * the same light, and what the first map's edge cut off. */
static void a_window_shows_the_same_light(void **state)
{
    struct fixture *fixture = *state;
    static float tile[60 * 60 * 3];
    double error = 0, beyond = 0;
    make_random(fixture, 5, 6, 0.2, 70, false);
    trace(fixture, 60, 1);
    memcpy(tile, fixture->map.texels, sizeof tile);
    fixture->window = (struct ray_window){-SIZE / 2 - 10 * SIZE / 60, -SIZE / 2 - 20 * SIZE / 60, SIZE * 1.5};
    trace(fixture, 90, 1);
    for (int j = 0; j < 90; j++) {
        for (int i = 0; i < 90; i++) {
            double light = (double)fixture->map.texels[(j * 90 + i) * 3];
            bool inside = i >= 10 && i < 70 && j >= 20 && j < 80;
            if (inside)
                error = fmax(error, fabs(light - (double)tile[((j - 20) * 60 + i - 10) * 3]));
            else
                beyond += light / 3600;
        }
    }
    assert_true(error < 1e-3);                 /* single precision at the brightest */
    assert_true(beyond > 0.2 && beyond < 0.3); /* it went 0.35 m along x and 0.2 m along z, of 2 m: 0.257 */
}

/* How far the map of flat water whose points only slide is from 1 anywhere. */
static double worst_of_sliding(struct fixture *fixture, int mesh)
{
    static const struct plane_wave waves[] = {{{1, 0}, 0.1, 0.3, 1}, {{1, 2}, 0.03, 0.3, 1}};
    double worst = 0;
    make_waves(fixture, waves, 2, mesh, true);
    for (int i = 0; i < mesh * mesh * 3; i++)
        fixture->surface.texels[i] = 0;
    trace(fixture, 64, 1);
    for (int i = 0; i < 64 * 64 * 3; i++)
        worst = fmax(worst, fabs((double)fixture->map.texels[i] - 1));
    return worst;
}

/* All light is where it was, but for what balancing moves: shifts' steepness, 0.5 here, × (wave number × spacing)² /
 * 12, which falls with the square of the mesh. */
static void water_that_slides_stays_flat(void **state)
{
    struct fixture *fixture = *state;
    for (int k = 0; k < 2; k++) {
        fixture->sun.angular_radius = k;
        double coarse = worst_of_sliding(fixture, 64), fine = worst_of_sliding(fixture, 128);
        if (!(coarse < 2e-3 && fine < 0.3 * coarse))
            fail_msg("off by %g, and %g with a finer mesh", coarse, fine);
    }
}

/* RMS of the map with a mesh of `mesh` vertices a side from the `wanted` one. */
static double error_of_mesh(struct fixture *fixture, const struct plane_wave *waves, int mesh, const double *wanted)
{
    make_waves(fixture, waves, 3, mesh, true);
    trace(fixture, 64, 1);
    return error_of(fixture, 0, 1, wanted);
}

/* Where the light of crests focuses, at n / ((n - 1) × 1.18/m) = 3.4 m for the three waves that meet in the middle.
 * Meshes of 32, 64 and 128 against one of 768, whose own error is then 1/36 of the last one's: 16 times less for two
 * doublings at least, 0.1 % at the end (measured), and five times that where vertices are not balanced. */
static void errors_fall_with_the_square_of_the_mesh(void **state)
{
    static const struct plane_wave waves[] = {{{2, 1}, 0.016, 0, 0}, {{-1, 3}, 0.008, 0, 0}, {{1, -2}, 0.008, 0, 0}};
    struct fixture *fixture = *state;
    double wanted[64 * 64], errors[3], plain[64 * 64] = {0};
    fixture->receivers[0] = -3.4;
    make_waves(fixture, waves, 3, 768, true);
    trace(fixture, 64, 1);
    for (int i = 0; i < 64 * 64; i++)
        wanted[i] = (double)fixture->map.texels[3 * i + 1];
    for (int k = 0; k < 3; k++)
        errors[k] = error_of_mesh(fixture, waves, 32 << k, wanted);
    struct coverage_case c = plain_case(fixture, 0, 1);
    c.balanced = false;
    coverage_map(&c, 1, plain);
    double exact = 0, squares = 0;
    for (int i = 0; i < 64 * 64; i++) {
        exact += pow(plain[i] - wanted[i], 2);
        squares += wanted[i] * wanted[i];
    }
    exact = sqrt(exact / squares);
    if (!(errors[0] > 16 * errors[2] && errors[2] < 2e-3 && errors[2] < 0.3 * exact))
        fail_msg("errors %g, %g, %g; %g where vertices stay", errors[0], errors[1], errors[2], exact);
}

/* Column by column: the light of one wave, from straight above, refracted onto a floor or thrown back onto a ceiling,
 * by a fine walk along the wave; before the focus and behind it. The mesh of 256 has errors of 3e-3 in bright columns,
 * by measurement. */
static void one_wave_gives_the_sum_over_its_folds(void **state)
{
    static const double receivers[] = {-0.7, -3, 0.2, 1.3};
    const struct plane_wave wave = {{2, 0}, 0.03, 0.4, 0};
    struct fixture *fixture = *state;
    memcpy(fixture->receivers, receivers, sizeof receivers);
    fixture->sun.elevation = 90;
    fixture->medium = (struct water_medium){.ior = 1.333};
    make_waves(fixture, &wave, 1, 256, true);
    for (int r = 0; r < 4; r++) {
        double columns[50] = {0};
        fixture->receivers[0] = receivers[r];
        trace(fixture, 50, 1);
        for (int i = 0; i < 200000; i++) {
            double vertex[5], x = (i + 0.5) / 200000 * SIZE;
            wave_vertex(&wave, 1, x - SIZE / 2, 0, vertex);
            double in = fmax(fabs(atan(vertex[1])), 1e-7), bent = asin(sin(in) / 1.333), away = vertex[1] < 0 ? 1 : -1;
            double back = (pow(sin(in - bent) / sin(in + bent), 2) + pow(tan(in - bent) / tan(in + bent), 2)) / 2;
            double flat = pow(0.333 / 2.333, 2), turned = receivers[r] < 0 ? -(in - bent) : 2 * in;
            double to = x + away * tan(turned) * fabs(receivers[r] - vertex[0]);
            double weight = receivers[r] < 0 ? (1 - back) / (1 - flat) : back / flat;
            columns[((int)floor(to / SIZE * 50) + 500) % 50] += weight * 50 / 200000;
        }
        for (int i = 0; i < 2500; i++)
            if (!(fabs((double)fixture->map.texels[3 * i] - columns[i % 50]) < 5e-3 * fmax(columns[i % 50], 1)))
                fail_msg("%g instead of %g: column %d, receiver %g", (double)fixture->map.texels[3 * i],
                         columns[i % 50], i % 50, receivers[r]);
    }
}

/* Slices of one pass are the maps of each receiver alone. */
static void slices_are_maps_of_their_own(void **state)
{
    static const double receivers[] = {-1.2, -0.9, -0.6, -0.3};
    struct fixture *fixture = *state;
    make_random(fixture, 3, 5, 0.2, 60, true);
    fixture->medium.dispersion = 0.02;
    for (int k = 0; k < 2; k++) {
        fixture->sun.angular_radius = 0.5 * k;
        memcpy(fixture->receivers, receivers, sizeof receivers);
        trace(fixture, 40, 4);
        float *together = copy_of(fixture);
        for (int r = 0; r < 4; r++) {
            fixture->receivers[0] = receivers[r];
            trace(fixture, 40, 1);
            assert_memory_equal(fixture->map.texels, together + r * 4800, sizeof(float[4800]));
        }
        free(together);
    }
}

/* Each colour of dispersed light is that colour of a medium with its index. */
static void colours_are_maps_of_their_own(void **state)
{
    struct fixture *fixture = *state;
    make_random(fixture, 4, 5, 0.2, 60, true);
    for (int k = 0; k < 2; k++) {
        double ior[3];
        fixture->sun.angular_radius = 0.5 * k;
        fixture->medium = (struct water_medium){.ior = 1.333, .dispersion = 0.02, .absorption = {0.35, 0.07, 0.03}};
        water_refractive_indices(&fixture->medium, ior);
        assert_true(ior[0] < ior[1] && ior[1] < ior[2]);
        trace(fixture, 40, 1);
        float *together = copy_of(fixture);
        for (int c = 0; c < 3; c++) {
            fixture->medium.ior = ior[c];
            fixture->medium.dispersion = 0;
            trace(fixture, 40, 1);
            for (int i = 0; i < 1600; i++)
                assert_true(fixture->map.texels[3 * i + c] == together[3 * i + c]);
        }
        free(together);
    }
}

/* Maps in which threads would show: bands, folds, a bounded surface, several colours. */
static void any_number_of_threads_gives_the_same_bytes(void **state)
{
    struct fixture *fixture = *state;
    for (int k = 0; k < 4; k++) {
        make_random(fixture, 9, 6, 0.25, 90, k % 2 == 0);
        fixture->sun.angular_radius = k / 2;
        fixture->medium.dispersion = k == 3 ? 0.02 : 0;
        trace(fixture, 200, 1);
        float *first = copy_of(fixture);
        for (int threads = 1; threads <= 5; threads++) {
#ifdef _OPENMP
            omp_set_num_threads(threads);
#endif
            trace(fixture, 200, 1);
            assert_memory_equal(fixture->map.texels, first, sizeof(float[3 * 200 * 200]));
        }
        free(first);
    }
#ifdef _OPENMP
    omp_set_num_threads(omp_get_num_procs());
#endif
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_point_sun_is_the_plain_sum, setup, teardown),
        cmocka_unit_test_setup_teardown(fineness_changes_nothing_for_a_point_sun, setup, teardown),
        cmocka_unit_test_setup_teardown(a_map_has_the_mean_of_the_vertices_weights, setup, teardown),
        cmocka_unit_test_setup_teardown(choppy_water_is_the_plain_sum, setup, teardown),
        cmocka_unit_test_setup_teardown(a_window_shows_the_same_light, setup, teardown),
        cmocka_unit_test_setup_teardown(water_that_slides_stays_flat, setup, teardown),
        cmocka_unit_test_setup_teardown(errors_fall_with_the_square_of_the_mesh, setup, teardown),
        cmocka_unit_test_setup_teardown(one_wave_gives_the_sum_over_its_folds, setup, teardown),
        cmocka_unit_test_setup_teardown(slices_are_maps_of_their_own, setup, teardown),
        cmocka_unit_test_setup_teardown(colours_are_maps_of_their_own, setup, teardown),
        cmocka_unit_test_setup_teardown(any_number_of_threads_gives_the_same_bytes, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
