/* The photon tracer where its map is known without a formula: flat water, edges, ends of ranges. */
#include "reference.h"

static void expect_ones(struct fixture *fixture, int receiver, double tolerance)
{
    for (int c = 0; c < 3; c++) {
        double mean = read_mean(fixture, receiver, c);
        if (!(fabs(mean - 1) < 4e-5)) /* what is left of drawing the sun's places */
            fail_msg("mean %.7f of colour %d, receiver %d, sun %g°", mean, c, receiver, fixture->sun.elevation);
        for (int i = 0; i < fixture->task.side * fixture->task.side; i++)
            if (!(fabs((double)fixture->map[3 * i + c] - 1) < tolerance))
                fail_msg("%.4f at sun %g°", (double)fixture->map[3 * i + c], fixture->sun.elevation);
    }
}

/* Below and above the water, with all that makes weights. Means are exact but for drawing the sun's places; texels
 * to five standard deviations of chance with 800 photons each, 5/√800. */
static void flat_water_gives_one_everywhere(void **state)
{
    static const double elevations[] = {5, 30, 60, 90}, receivers[] = {-1, -0.3, -2.5, 0.7, 3};
    struct fixture *fixture = *state;
    memcpy(fixture->receivers, receivers, sizeof receivers);
    fixture->task.receiver_count = 5;
    for (int i = 0; i < 8; i++) {
        fixture->sun = (struct optics_sun){
            .elevation = elevations[i % 4], .azimuth = 30 + 70 * i, .angular_radius = i < 4 ? 0.2665 : 0};
        fixture->medium.dispersion = i % 2 ? 0.1 : 0;
        trace(fixture, 100);
        for (int r = 0; r < 5; r++)
            expect_ones(fixture, r, 0.18);
    }
    fixture->medium.ior = 1; /* nothing is bent, nothing thrown back */
    fixture->medium.dispersion = 0;
    trace(fixture, 100);
    for (int r = 0; r < 5; r++) {
        if (receivers[r] < 0)
            expect_ones(fixture, r, 0.18);
        else
            assert_true(read_mean(fixture, r, 0) == 0);
    }
}

/* Water that moves sideways and does nothing else: crowded where it moves together, each patch then smaller. */
static void sample_sliding(const void *state, const struct water_setup *setup, double time, struct water_points *points)
{
    (void)state;
    (void)time;
    for (int i = 0; i < points->count; i++) {
        double k = 2 * M_PI / setup->size, angle = k * points->x[i];
        points->height[i] = points->slope_x[i] = points->slope_z[i] = 0;
        points->shift_x[i] = 0.2 * sin(angle);
        points->shift_z[i] = 0;
        points->area[i] = 1 + 0.2 * k * cos(angle);
    }
}

static struct water_shape sliding_shape(const struct water_setup *setup)
{
    (void)setup;
    return (struct water_shape){.periodic = true, .choppy = true};
}

static void water_that_slides_stays_flat(void **state)
{
    static const struct water_model sliding = {.name = "sliding", .shape = sliding_shape, .sample = sample_sliding};
    struct fixture *fixture = *state;
    fixture->task.model = &sliding;
    fixture->sun.elevation = 50;
    trace(fixture, 100);
    expect_ones(fixture, 0, 0.18);
}

static struct water_shape bounded_shape(const struct water_setup *setup)
{
    (void)setup;
    return (struct water_shape){0};
}

static void sample_flat(const void *state, const struct water_setup *setup, double time, struct water_points *points)
{
    (void)state;
    (void)setup;
    (void)time;
    for (int i = 0; i < points->count; i++)
        points->height[i] = points->slope_x[i] = points->slope_z[i] = 0;
}

/* The sun in +x: no light comes in at that edge of a bounded tile, and what leaves at the other is lost. */
static void bounded_water_has_edges(void **state)
{
    static const struct water_model bounded = {.name = "bounded", .shape = bounded_shape, .sample = sample_flat};
    struct fixture *fixture = *state;
    fixture->task.model = &bounded;
    fixture->sun = (struct optics_sun){.elevation = 45, .azimuth = 0, .angular_radius = 0};
    fixture->receivers[0] = -0.8; /* shifts by 0.501 m: 4 of 16 texels */
    trace(fixture, 50);
    photons_read(&fixture->photons, 0, fixture->map);
    for (int i = 0; i < 256; i++)
        assert_true(i % 16 > 11 ? fixture->map[3 * i] == 0
                                : fabs((double)fixture->map[3 * i] - 1) < 0.18 || i % 16 == 11);
}

/* A map of what lies twice as wide where the light of bounded flat water falls: 1 in the middle, 0 around it. */
static void a_window_follows_the_light(void **state)
{
    static const struct water_model bounded = {.name = "bounded", .shape = bounded_shape, .sample = sample_flat};
    struct fixture *fixture = *state;
    const struct ray_window window = {-SIZE - 0.8 * tan(asin(cos(M_PI / 4) / 1.333)), -SIZE, 2 * SIZE};
    fixture->task.model = &bounded;
    fixture->task.windows = &window;
    fixture->sun = (struct optics_sun){.elevation = 45, .azimuth = 0, .angular_radius = 0};
    fixture->receivers[0] = -0.8;
    trace(fixture, 100);
    photons_read(&fixture->photons, 0, fixture->map);
    for (int i = 0; i < 256; i++) {
        bool lit = i % 16 >= 4 && i % 16 < 12 && i / 16 >= 4 && i / 16 < 12;
        assert_true(lit ? fabs((double)fixture->map[3 * i] - 1) < 0.1 : fixture->map[3 * i] < 0.1f);
    }
}

/* Water that stands lower than its receiver, as a trough below the floor does: what it gets is straight above. */
static void sample_low(const void *state, const struct water_setup *setup, double time, struct water_points *points)
{
    sample_flat(state, setup, time, points);
    for (int i = 0; i < points->count; i++)
        points->height[i] = -0.5;
}

static void water_beyond_its_receiver_lights_it_straight(void **state)
{
    static const struct water_model low = {.name = "low", .shape = bounded_shape, .sample = sample_low};
    struct fixture *fixture = *state;
    fixture->task.model = &low;
    fixture->sun = (struct optics_sun){.elevation = 45, .azimuth = 20, .angular_radius = 0};
    fixture->medium = (struct water_medium){.ior = 1.333};
    fixture->receivers[0] = -0.3;
    trace(fixture, 3);
    photons_read(&fixture->photons, 0, fixture->map);
    for (int i = 0; i < 256 * 3; i++)
        assert_true(fabs((double)fixture->map[i] - 1) < 1e-5); /* parts of a photon */
}

/* Steep water through the floor and through the ceiling, sun at the horizon, all absorption: no sum breaks. */
static void nothing_is_ever_infinite(void **state)
{
    static const double receivers[] = {-1e-6, -0.05, -1000, 1e-6, 0.05, 1000};
    struct fixture *fixture = *state;
    memcpy(fixture->receivers, receivers, sizeof receivers);
    fixture->task.receiver_count = 6;
    fixture->setup.wave_count = 2;
    for (int i = 0; i < 16; i++) {
        fixture->waves[0] = (struct wave){{3, 1}, i & 1 ? 100 : 0.1, 0, 0, 0};
        fixture->waves[1] = (struct wave){{256, -256}, i & 1 ? 1 : 0.01, 0, 0, 0};
        fixture->sun = (struct optics_sun){.elevation = i & 2 ? 1 : 90, .azimuth = 0, .angular_radius = i & 4 ? 10 : 0};
        fixture->medium =
            (struct water_medium){.ior = 1 + (i & 8) / 4.0, .dispersion = i & 1 ? 0.5 : 0, .absorption = {0, 1, 100}};
        trace(fixture, 2);
        for (int r = 0; r < 6; r++)
            for (int c = 0; c < 3; c++)
                read_mean(fixture, r, c);
        assert_true(isfinite(photons_noise(&fixture->photons)));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(flat_water_gives_one_everywhere, setup, teardown),
        cmocka_unit_test_setup_teardown(water_that_slides_stays_flat, setup, teardown),
        cmocka_unit_test_setup_teardown(bounded_water_has_edges, setup, teardown),
        cmocka_unit_test_setup_teardown(a_window_follows_the_light, setup, teardown),
        cmocka_unit_test_setup_teardown(water_beyond_its_receiver_lights_it_straight, setup, teardown),
        cmocka_unit_test_setup_teardown(nothing_is_ever_infinite, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
