/* The photon tracer against light that can be worked out: plane waves, whose map follows from the way of each ray along
 * one axis, lenses, and means. Laws are written a second time, in angles. */
#include "plane_wave.h"
#include "reference.h"

/* The mean of each column of the map, against the mean over places of the sun's disc. */
static void expect_columns(struct fixture *fixture, double tolerance)
{
    int side = fixture->task.side;
    for (int r = 0; r < fixture->task.receiver_count; r++) {
        for (int c = 0; c < 3; c++) {
            double columns[SIDE_MAX];
            const struct plane_wave wave = {
                .size = SIZE,
                .cycles = fixture->waves[0].cycles[0],
                .amplitude = fixture->waves[0].amplitude,
                .ior = fixture->medium.ior + (c - 1) * fixture->medium.dispersion / 2,
                .absorption = fixture->medium.absorption[c],
            };
            wave_columns(&wave, &fixture->sun, fixture->receivers[r], side, columns);
            photons_read(&fixture->photons, r, fixture->map);
            for (int i = 0; i < side; i++) {
                double sum = 0, wanted = columns[i];
                for (int j = 0; j < side; j++)
                    sum += (double)fixture->map[(j * side + i) * 3 + c] / side;
                if (!(fabs(sum - wanted) <= tolerance * fmax(wanted, 1)))
                    fail_msg("%.4f instead of %.4f: column %d, colour %d, receiver %g m, sun %g°", sum, wanted, i, c,
                             fixture->receivers[r], fixture->sun.elevation);
            }
        }
    }
}

/* Folds and all, to the noise of 20000 photons a column where they bunch: from a third of the focal depth, 2.5 m, to
 * three times it, and thrown back onto ceilings. */
static void a_plane_wave_gives_the_sum_over_its_folds(void **state)
{
    static const double receivers[] = {-0.84, -2.5, -7.6, 0.3, 1};
    struct fixture *fixture = *state;
    memcpy(fixture->receivers, receivers, sizeof receivers);
    fixture->waves[0] = (struct wave){{2, 0}, 0.04, 0, 0, 0};
    fixture->setup.wave_count = 1;
    fixture->task.receiver_count = 5;
    fixture->task.side = 32;
    for (int i = 0; i < 6; i++) {
        fixture->sun = (struct optics_sun){.elevation = i % 3 == 0   ? 90
                                                        : i % 3 == 1 ? 50
                                                                     : 40,
                                           .azimuth = i % 3 == 1 ? 0 : 200,
                                           .angular_radius = i < 3 ? 0 : 1};
        fixture->medium.dispersion = i % 3 == 2 ? 0.2 : 0;
        trace(fixture, 80);
        expect_columns(fixture, 0.02);
    }
}

/* The mean over a grid of rays of the weights that the map's units are made of. */
static double mean_weight(const struct fixture *fixture, double y, int color)
{
    const int side = 300;
    double light[3], sum = 0;
    optics_sun_direction(&fixture->sun, light);
    double tilt = M_PI / 2 - asin(light[1]), ior = fixture->medium.ior, sigma = fixture->medium.absorption[color];
    double flat_out = asin(sin(tilt) / ior), flat_way = -y / cos(flat_out);
    for (int k = 0; k < side * side; k++) {
        double x = SIZE * (k % side) / side, z = SIZE * (k / side) / side, h = 0, slope[2] = {0};
        for (int w = 0; w < fixture->setup.wave_count; w++) {
            const struct wave *wave = fixture->waves + w;
            double kx = 2 * M_PI * wave->cycles[0] / SIZE, kz = 2 * M_PI * wave->cycles[1] / SIZE;
            double angle = kx * x + kz * z + wave->phase * M_PI / 180;
            h += wave->amplitude * cos(angle);
            slope[0] -= wave->amplitude * kx * sin(angle);
            slope[1] -= wave->amplitude * kz * sin(angle);
        }
        double facing = light[1] - light[0] * slope[0] - light[2] * slope[1];
        double length = sqrt(1 + slope[0] * slope[0] + slope[1] * slope[1]), in = acos(facing / length);
        double out = asin(sin(in) / ior); /* the ray leaves along (sin out / sin in) (−light) and −the normal's rest */
        double down = (light[1] - cos(in) / length) / sin(in) * sin(out) + cos(out) / length;
        sum += facing / light[1] * (1 - fresnel(in, out)) / (1 - fresnel(tilt, flat_out)) *
               exp(-sigma * ((h - y) / down - flat_way));
    }
    return sum / (side * side);
}

static void a_map_has_the_mean_of_its_rays_weights(void **state)
{
    static const double elevations[] = {35, 60, 85};
    struct fixture *fixture = *state;
    const struct wave waves[] = {{{3, 1}, 0.03, 40, 0, 0}, {{-2, 4}, 0.02, -90, 0, 0}, {{5, 3}, 0.01, 180, 0, 0}};
    memcpy(fixture->waves, waves, sizeof waves);
    fixture->setup.wave_count = 3;
    fixture->task.side = 32;
    for (int i = 0; i < 3; i++) {
        fixture->sun = (struct optics_sun){.elevation = elevations[i], .azimuth = 100 * i, .angular_radius = 0};
        trace(fixture, 100);
        for (int c = 0; c < 3; c++) {
            double mean = read_mean(fixture, 0, c), wanted = mean_weight(fixture, -1, c);
            if (!(fabs(mean - wanted) < 1e-4))
                fail_msg("%.6f instead of %.6f, colour %d, sun %g°", mean, wanted, c, elevations[i]);
        }
    }
}

/* The brightest texel of a map along x, z or both. */
static void find_brightest(struct fixture *fixture, int receiver, int color, int place[2])
{
    int side = fixture->task.side, best = 0;
    photons_read(&fixture->photons, receiver, fixture->map);
    for (int i = 0; i < side * side; i++)
        if (fixture->map[3 * i + color] > fixture->map[3 * best + color])
            best = i;
    place[0] = best % side;
    place[1] = best / side;
}

/* Small waves from straight above gather at n / ((n - 1) A k²) below the crest. */
static void a_crest_is_a_lens_of_known_focal_length(void **state)
{
    struct fixture *fixture = *state;
    double n = 1.333, k = 2 * M_PI / SIZE, amplitude = 0.01, focus = n / ((n - 1) * amplitude * k * k) - amplitude;
    double brightest = 0, at = 0;
    fixture->waves[0] = (struct wave){{1, 0}, amplitude, 0, 0, 0};
    fixture->setup.wave_count = 1;
    fixture->sun = (struct optics_sun){.elevation = 90, .azimuth = 0, .angular_radius = 0};
    fixture->medium = (struct water_medium){.ior = n};
    fixture->task.receiver_count = 9;
    fixture->task.side = 63; /* a texel in the very middle */
    for (int r = 0; r < 9; r++)
        fixture->receivers[r] = -focus * (0.6 + 0.1 * r);
    trace(fixture, 16);
    for (int r = 0; r < 9; r++) {
        double middle = 0;
        photons_read(&fixture->photons, r, fixture->map);
        for (int j = 0; j < 63; j++)
            middle += (double)fixture->map[(j * 63 + 31) * 3] / 63;
        if (middle > brightest) {
            brightest = middle;
            at = -fixture->receivers[r];
        }
    }
    assert_true(fabs(at / focus - 1) < 0.11); /* a step; a texel's width favours the next one below */
}

/* The sun in +x sends the light of a crest towards -x, by depth × tan of the refracted angle; likewise along z; what
 * is thrown back goes the same way. */
static void light_goes_away_from_the_sun(void **state)
{
    static const double receivers[] = {-0.5, 0.25};
    struct fixture *fixture = *state;
    memcpy(fixture->receivers, receivers, sizeof receivers);
    fixture->medium = (struct water_medium){.ior = 1.333};
    fixture->setup.wave_count = 2;
    fixture->task.receiver_count = 2;
    fixture->task.side = 40;
    for (int azimuth = 0; azimuth < 360; azimuth += 90) {
        double angle = azimuth * M_PI / 180, up = 40 * M_PI / 180, crest = 0.05;
        fixture->waves[0] = (struct wave){{1, 0}, crest, 0, 0, 0};
        fixture->waves[1] = (struct wave){{0, 1}, crest, 0, 0, 0};
        fixture->sun = (struct optics_sun){.elevation = 40, .azimuth = azimuth, .angular_radius = 0}; /* = up */
        trace(fixture, 30);
        for (int r = 0; r < 2; r++) {
            /* a trough gathers what is thrown back: half a tile away */
            double from = r == 0 ? 0 : -1;
            double shift = r == 0 ? -(0.5 + 2 * crest) * tan(asin(cos(up) / 1.333)) : -(0.25 + 2 * crest) / tan(up);
            int place[2];
            find_brightest(fixture, r, 1, place);
            for (int axis = 0; axis < 2; axis++) {
                double wanted = from + shift * (axis == 0 ? cos(angle) : sin(angle));
                double off = (place[axis] + 0.5) / 40 * SIZE - SIZE / 2 - wanted;
                off -= SIZE * round(off / SIZE);
                if (fabs(off) > 0.2) /* slanted light bends a lens's focus; a wrong sign is 0.4 to 1 off */
                    fail_msg("%.3f m off along %c, receiver %g, azimuth %d", off, "xz"[axis], receivers[r], azimuth);
            }
        }
    }
}

/* Blue is bent more than red: its light lands nearer to where it entered. */
static void blue_is_bent_more_than_red(void **state)
{
    struct fixture *fixture = *state;
    int red[2], blue[2];
    fixture->waves[0] = (struct wave){{1, 0}, 0.05, 0, 0, 0};
    fixture->setup.wave_count = 1;
    fixture->sun = (struct optics_sun){.elevation = 40, .azimuth = 0, .angular_radius = 0};
    fixture->medium = (struct water_medium){.ior = 1.4, .dispersion = 0.3};
    fixture->task.side = 64;
    trace(fixture, 20);
    find_brightest(fixture, 0, 0, red);
    find_brightest(fixture, 0, 2, blue);
    assert_true(red[0] < blue[0] && blue[0] < 32);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_plane_wave_gives_the_sum_over_its_folds, setup, teardown),
        cmocka_unit_test_setup_teardown(a_map_has_the_mean_of_its_rays_weights, setup, teardown),
        cmocka_unit_test_setup_teardown(a_crest_is_a_lens_of_known_focal_length, setup, teardown),
        cmocka_unit_test_setup_teardown(light_goes_away_from_the_sun, setup, teardown),
        cmocka_unit_test_setup_teardown(blue_is_bent_more_than_red, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
