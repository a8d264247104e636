/* tests/sky.h: a sky at its defaults, for the tests of it. */
#ifndef TESTS_SKY_H
#define TESTS_SKY_H

#include "support.h"

#include "optics/sky.h"

struct fixture {
    struct support_log log;
    struct optics_sky_settings settings;
    struct optics_sun sun;
    struct optics_sky sky;
};

static inline int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    support_log_start(&fixture->log);
    param_defaults(optics_sky_params, &fixture->settings);
    param_defaults(optics_sun_params, &fixture->sun);
    *state = fixture;
    return 0;
}

static inline int teardown(void **state)
{
    struct fixture *fixture = *state;
    int errors = fixture->log.errors;
    optics_sky_finish(&fixture->sky);
    free(fixture);
    return errors;
}

static inline void make(struct fixture *fixture)
{
    assert_true(optics_sky_make(&fixture->sky, &fixture->settings, &fixture->sun, &fixture->log.log));
}

static inline double luminance(const double rgb[3])
{
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

static inline void direction_of(double elevation, double azimuth, double out[3])
{
    const double degree = M_PI / 180;
    out[0] = cos(elevation * degree) * cos(azimuth * degree);
    out[1] = sin(elevation * degree);
    out[2] = cos(elevation * degree) * sin(azimuth * degree);
}

/* On a surface with that normal, by a plain sum over directions, all of them or those above the horizon. */
static inline void plain_irradiance(const struct optics_sky *sky, const double normal[3], bool above, double sum[3])
{
    enum { RINGS = 300, TURNS = 240 };
    sum[0] = sum[1] = sum[2] = 0;
    for (int r = 0; r < RINGS; r++) {
        double height = 1 - (r + 0.5) * 2 / RINGS, level = sqrt(1 - height * height);
        for (int t = 0; t < TURNS && (height > 0 || !above); t++) {
            double turn = 2 * M_PI * (t + 0.5) / TURNS, radiance[3];
            const double direction[3] = {level * cos(turn), height, level * sin(turn)};
            double cosine = direction[0] * normal[0] + direction[1] * normal[1] + direction[2] * normal[2];
            if (cosine <= 0)
                continue;
            optics_sky_radiance(sky, direction, radiance);
            for (int c = 0; c < 3; c++)
                sum[c] += radiance[c] * cosine * 4 * M_PI / (RINGS * TURNS);
        }
    }
}

static inline void expect_share(double value, double wanted, double tolerance)
{
    if (!(fabs(value - wanted) <= tolerance * fabs(wanted)))
        fail_msg("%.9g instead of %.9g", value, wanted);
}

#endif
