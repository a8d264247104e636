/* The light of sun and sky: sums against integrals, skies against what is measured of them, pictures of skies. */
#include "sky.h"

#include "optics/scattering.h"

static const double up[3] = {0, 1, 0};

static void colours_keep_their_luminance(void **state)
{
    double rgb[SPECTRUM_COUNT][3], sum[3] = {0};
    (void)state;
    spectrum_sunlight(rgb);
    for (int w = 0; w < SPECTRUM_COUNT; w++) {
        double one[3] = {rgb[w][0], rgb[w][1], rgb[w][2]}, before = luminance(one);
        spectrum_fit(one);
        expect_share(luminance(one), before, 1e-9);
        assert_true(one[0] >= 0 && one[1] >= 0 && one[2] >= 0);
        for (int c = 0; c < 3; c++)
            sum[c] += rgb[w][c];
    }
    expect_share(luminance(sum), 1, 1e-3);
    /* the sun is close to a black body of 5900 K, whose colour is x = 0.3239, y = 0.3337 */
    expect_share(sum[0] / sum[1], 1.122, 0.02);
    expect_share(sum[2] / sum[1], 0.956, 0.02);
}

/* The way through air against the standard formula (Kasten & Young 1989), which knows that rays are bent. */
static void air_mass_is_that_of_the_tables(void **state)
{
    struct atmosphere_columns *columns = calloc(1, sizeof *columns);
    float column[ATMOSPHERE_PARTS];
    (void)state;
    atmosphere_columns_make(columns);
    for (double elevation = 1; elevation <= 90; elevation += 1) {
        double sine = sin(elevation * M_PI / 180);
        double wanted = 1 / (sine + 0.50572 * pow(elevation + 6.07995, -1.6364));
        atmosphere_column(columns, ATMOSPHERE_GROUND, sine, column);
        expect_share((double)column[ATMOSPHERE_AIR] / 8000, wanted, elevation < 5 ? 0.06 : 0.02);
    }
    free(columns);
}

/* Molecules alone take away 0.0973 of green light at 550 nm (Hansen & Travis 1974, Bodhaine et al. 1999), 300 Dobson
 * units of ozone at 600 nm 0.038; haze at turbidity 2 is an optical depth of about 0.1. */
static void air_takes_away_what_is_measured(void **state)
{
    const struct atmosphere clean = atmosphere_of(1), hazy = atmosphere_of(2);
    (void)state;
    assert_true(spectrum_wavelength(8) == 550);
    expect_share((double)clean.extinction[ATMOSPHERE_AIR][8] * 8000, 0.0973, 0.01);
    expect_share((double)clean.extinction[ATMOSPHERE_OZONE][10] * 15000, 0.0375, 0.05);
    expect_share((double)hazy.extinction[ATMOSPHERE_HAZE][8] * 1200, 0.1, 0.05);
    assert_true(clean.extinction[ATMOSPHERE_HAZE][8] * 1200 < 0.002f);
}

/* Air that only scatters, evenly in the mean, above black ground lets a share of the light through that is known in
 * closed form: Eddington's approximation, good to a hundredth or two for so little air (Shettle & Weinman 1970, eq.
 * 16). All of the light is meant, what is scattered and what is not. */
static void air_that_takes_nothing_keeps_the_light(void **state)
{
    enum { RINGS = 40, TURNS = 8 };
    struct atmosphere_columns *columns = calloc(1, sizeof *columns);
    struct scattering *scattering = calloc(1, sizeof *scattering);
    struct atmosphere atmosphere = {{{0}}};
    (void)state;
    for (int w = 0; w < SPECTRUM_COUNT; w++)
        atmosphere.extinction[ATMOSPHERE_AIR][w] = 0.025f * (float)(w + 1) / 8000; /* optical depth 0.025 to 0.4 */
    atmosphere_columns_make(columns);
    scattering_make(scattering, &atmosphere, columns, 0);
    for (double height = 0.4; height < 1; height += 0.25) {
        const double sun[3] = {sqrt(1 - height * height), height, 0};
        double down[SPECTRUM_COUNT] = {0};
        for (int r = 0; r < RINGS * TURNS; r++) {
            double y = (r / TURNS + 0.5) / RINGS, level = sqrt(1 - y * y), turn = M_PI * (r % TURNS + 0.5) / TURNS;
            const double direction[3] = {level * cos(turn), y, level * sin(turn)};
            double cosine = direction[0] * sun[0] + y * height;
            struct scattering_sum sum;
            scattering_gather(scattering, &atmosphere, columns, direction, sun, &sum);
            for (int w = 0; w < SPECTRUM_COUNT; w++) {
                double phase = 3 / (16 * M_PI) * (1 + cosine * cosine);
                double light = (double)sum.once[0][w] * phase + (double)sum.more[w];
                down[w] += light * y * 2 * M_PI / (RINGS * TURNS);
            }
        }
        for (int w = 0; w < SPECTRUM_COUNT; w++) {
            double depth = 0.025 * (w + 1), direct = exp(-depth / height);
            double known = ((2 + 3 * height) + (2 - 3 * height) * direct) / (4 + 3 * depth);
            expect_share(down[w] / height + direct, known, height < 0.5 ? 0.022 : 0.012);
        }
    }
    free(columns);
    free(scattering);
}

/* Irradiance is the integral of the texels and of what is looked up between them; the ground throws its share back. */
static void irradiance_is_the_integral(void **state)
{
    struct fixture *fixture = *state;
    for (int model = SKY_CLEAR; model <= SKY_OVERCAST; model++) {
        double sum[3], ground[3];
        fixture->settings.model = model;
        make(fixture);
        plain_irradiance(&fixture->sky, up, true, sum);
        optics_sky_radiance(&fixture->sky, (const double[3]){0.6, -0.8, 0}, ground);
        for (int c = 0; c < 3; c++) {
            expect_share(sum[c], fixture->sky.irradiance[c], 0.003);
            double level = fixture->sky.irradiance[c] + fixture->sky.sun[c] * sin(60 * M_PI / 180);
            expect_share(ground[c], level * 0.12 / M_PI, 1e-5);
        }
    }
}

/* What is seen just above the horizon has nothing of the ground in it. */
static void the_horizon_is_sharp(void **state)
{
    struct fixture *fixture = *state;
    make(fixture);
    for (double azimuth = 0.7; azimuth < 360; azimuth += 10 * 360.0 / SKY_COLUMNS) {
        double above[3], higher[3], below[3], direction[3];
        direction_of(1e-6, azimuth, direction);
        optics_sky_radiance(&fixture->sky, direction, above);
        direction_of(90.0 / SKY_ROWS, azimuth, direction);
        optics_sky_radiance(&fixture->sky, direction, higher);
        direction_of(-1e-6, azimuth, direction);
        optics_sky_radiance(&fixture->sky, direction, below);
        for (int c = 0; c < 3; c++) {
            expect_share(above[c], higher[c], 1e-6);
            expect_share(below[c], (double)fixture->sky.texels[(SKY_ROWS - 1) * SKY_COLUMNS * 3 + c], 1e-6);
        }
        assert_true(luminance(above) > 1.2 * luminance(below));
    }
}

/* Of a clear day at noon: a blue zenith, a paler and brighter horizon, and the sky's share of the light. */
static void noon_is_blue(void **state)
{
    struct fixture *fixture = *state;
    for (double turbidity = 2; turbidity <= 3; turbidity += 0.5) {
        double away[3], horizon[3], direction[3];
        fixture->settings.turbidity = turbidity;
        make(fixture);
        direction_of(75, fixture->sun.azimuth + 180, direction);
        optics_sky_radiance(&fixture->sky, direction, away);
        direction_of(4, fixture->sun.azimuth + 180, direction);
        optics_sky_radiance(&fixture->sky, direction, horizon);
        assert_true(away[2] > 1.8 * away[0] && away[2] > away[1] && away[1] > away[0]);
        assert_true(luminance(horizon) > 1.5 * luminance(away));
        assert_true(horizon[2] / horizon[0] < 0.8 * away[2] / away[0]);
        double sky = luminance(fixture->sky.irradiance);
        double sun = luminance(fixture->sky.sun) * sin(fixture->sun.elevation * M_PI / 180);
        assert_true(sky / (sky + sun) > 0.10 && sky / (sky + sun) < 0.25);
        /* some 130 klx outside make 95 to 110 klx on the ground */
        assert_true(sky + sun > 0.70 * sin(M_PI / 3) && sky + sun < 0.92 * sin(M_PI / 3));
    }
}

static void a_low_sun_is_red(void **state)
{
    struct fixture *fixture = *state;
    double glow[3], other[3], direction[3];
    fixture->sun.elevation = 3;
    make(fixture);
    assert_true(fixture->sky.sun[0] > 2 * fixture->sky.sun[1] && fixture->sky.sun[1] > 2 * fixture->sky.sun[2]);
    direction_of(3, fixture->sun.azimuth, direction);
    optics_sky_radiance(&fixture->sky, direction, glow);
    direction_of(3, fixture->sun.azimuth + 180, direction);
    optics_sky_radiance(&fixture->sky, direction, other);
    assert_true(glow[0] > 2 * glow[2] && luminance(glow) > 3 * luminance(other));
    double radius = 0.2665 * M_PI / 180;
    expect_share(fixture->sky.sun_radiance[0] * M_PI * radius * radius, fixture->sky.sun[0], 1e-4);
    double wide = fixture->sky.sun_radiance[0];
    fixture->sun.angular_radius = 0;
    make(fixture);
    expect_share(fixture->sky.sun_radiance[0], wide, 1e-9);
}

/* A sun that is turned by a quarter turns the sky by a quarter, texel by texel; and where the columns meet there is no
 * edge. */
static void the_sky_goes_round(void **state)
{
    struct fixture *fixture = *state;
    const size_t count = (size_t)SKY_ROWS * SKY_COLUMNS * 3;
    float *before = malloc(count * sizeof *before);
    fixture->sun.elevation = 12;
    make(fixture);
    memcpy(before, fixture->sky.texels, count * sizeof *before);
    fixture->sun.azimuth += 90;
    make(fixture);
    for (int j = 0; j < SKY_ROWS; j++) {
        double step = 0, seam = 0;
        for (int i = 0; i < SKY_COLUMNS * 3; i++) {
            const float *row = fixture->sky.texels + j * SKY_COLUMNS * 3;
            float was = before[j * SKY_COLUMNS * 3 + (i + SKY_COLUMNS * 9 / 4) % (SKY_COLUMNS * 3)];
            expect_share((double)row[i], (double)was, 1e-5);
            double change = fabs((double)row[i] - (double)row[(i + 3) % (SKY_COLUMNS * 3)]);
            step = fmax(step, i < SKY_COLUMNS * 3 - 3 ? change : 0);
            seam = fmax(seam, i < SKY_COLUMNS * 3 - 3 ? 0 : change);
        }
        assert_true(seam <= step);
    }
    free(before);
}

/* Whatever is asked for, light is a number and not negative. */
static void light_is_never_less_than_nothing(void **state)
{
    struct fixture *fixture = *state;
    for (int i = 0; i < 32; i++) {
        fixture->settings = (struct optics_sky_settings){.model = i & 16 ? SKY_OVERCAST : SKY_CLEAR,
                                                         .turbidity = i & 1 ? 10 : 1,
                                                         .sun = 1,
                                                         .brightness = i & 2 ? 1000 : 1,
                                                         .ground = {i & 4 ? 1 : 0, 0, 1}};
        fixture->sun.elevation = i & 8 ? 1 : 90;
        make(fixture);
        for (int t = 0; t < SKY_ROWS * SKY_COLUMNS * 3; t++)
            assert_true(isfinite(fixture->sky.texels[t]) && fixture->sky.texels[t] >= 0);
        for (int c = 0; c < 3; c++)
            assert_true(isfinite(fixture->sky.sun_radiance[c]) && fixture->sky.sun[c] >= 0);
        assert_true(luminance(fixture->sky.sun) > 0 && luminance(fixture->sky.irradiance) > 0);
    }
}

/* Moon & Spencer 1942; no sun unless it is asked for. */
static void clouds_are_brightest_overhead(void **state)
{
    struct fixture *fixture = *state;
    double zenith[3], low[3], direction[3];
    make(fixture);
    double clear = fixture->sky.sun[0];
    fixture->settings.model = SKY_OVERCAST;
    make(fixture);
    optics_sky_radiance(&fixture->sky, up, zenith);
    direction_of(30, 200, direction);
    optics_sky_radiance(&fixture->sky, direction, low);
    expect_share(low[1] / zenith[1], 2.0 / 3, 1e-3);
    expect_share(fixture->sky.irradiance[1], (300 + 21000 * sin(M_PI / 3)) / 133100, 1e-3);
    assert_true(fixture->sky.sun[0] == 0 && fixture->sky.sun_radiance[2] == 0);
    fixture->settings.sun = 0.25;
    make(fixture);
    expect_share(fixture->sky.sun[0], clear / 4, 1e-9);
}

/* The number changes with all that changes the light, and only then. */
static void the_fingerprint_tells_skies_apart(void **state)
{
    struct fixture *fixture = *state;
    make(fixture);
    uint64_t first = fixture->sky.fingerprint, seen[5];
    float *texels = fixture->sky.texels, value = texels[0];
    texels[0] = -1; /* a sky that is made anew overwrites it */
    make(fixture);
    assert_true(fixture->sky.fingerprint == first && texels[0] == -1);
    double *const numbers[] = {&fixture->settings.turbidity, &fixture->settings.ground[1], &fixture->settings.sun,
                               &fixture->settings.brightness, &fixture->sun.azimuth};
    for (int i = 0; i < 5; i++) {
        double before = *numbers[i];
        *numbers[i] = before * 0.5 + 0.75;
        make(fixture);
        seen[i] = fixture->sky.fingerprint;
        *numbers[i] = before;
        for (int k = 0; k < i; k++)
            assert_true(seen[i] != seen[k]);
        assert_true(seen[i] != first);
    }
    make(fixture);
    assert_true(fixture->sky.fingerprint == first && fixture->sky.texels[0] == value);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(colours_keep_their_luminance),
        cmocka_unit_test(air_mass_is_that_of_the_tables),
        cmocka_unit_test(air_takes_away_what_is_measured),
        cmocka_unit_test(air_that_takes_nothing_keeps_the_light),
        cmocka_unit_test_setup_teardown(the_horizon_is_sharp, setup, teardown),
        cmocka_unit_test_setup_teardown(irradiance_is_the_integral, setup, teardown),
        cmocka_unit_test_setup_teardown(noon_is_blue, setup, teardown),
        cmocka_unit_test_setup_teardown(a_low_sun_is_red, setup, teardown),
        cmocka_unit_test_setup_teardown(the_sky_goes_round, setup, teardown),
        cmocka_unit_test_setup_teardown(light_is_never_less_than_nothing, setup, teardown),
        cmocka_unit_test_setup_teardown(clouds_are_brightest_overhead, setup, teardown),
        cmocka_unit_test_setup_teardown(the_fingerprint_tells_skies_apart, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
