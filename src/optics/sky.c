#include "optics/sky.h"

#include "base/hash.h"
#include "base/log.h"
#include "optics/sky_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *model_name(int i)
{
    static const char *const names[] = {"clear", "overcast", "environment"};
    return i >= 0 && i < (int)(sizeof names / sizeof *names) ? names[i] : NULL;
}

const struct dpl_param optics_sky_params[] = {
    PARAM_CHOICE(struct optics_sky_settings, model, SKY_CLEAR, model_name,
                 "clear air, an even layer of clouds, or a picture of the whole sky"),
    PARAM_FLOAT(struct optics_sky_settings, turbidity, 2, 1, 10, "",
                "haze: 1 = clean air, 2 = very clear, 3 = clear, 6 = a hot and humid day, 10 = dense haze"),
    PARAM_FLOAT(struct optics_sky_settings, sun, -1, -1, 1, "",
                "share of the direct sun that clouds let pass; below 0 = none of it if overcast, otherwise all"),
    PARAM_FLOAT(struct optics_sky_settings, brightness, 1, 0, 1000, "", "times the light of sun and sky"),
    PARAM_COLOR(struct optics_sky_settings, ground, 1, "reflectance of what lies beyond the horizon", 0.12, 0.12, 0.12),
    PARAM_FLOAT(struct optics_sky_settings, turn, 0, -360, 360, "degrees",
                "turns the environment about the vertical, from +x towards +z"),
    PARAM_TEXT(struct optics_sky_settings, environment,
               "picture of the whole sky (.exr, .pfm), radiance; its left edge is at +x, its upper half is used; it "
               "should not have the sun in it"),
    PARAM_END,
};

void sky_direction(double column, double row, double direction[3])
{
    double azimuth = 2 * M_PI * column / SKY_COLUMNS, zenith = M_PI * row / SKY_ROWS;
    direction[0] = sin(zenith) * cos(azimuth);
    direction[1] = cos(zenith);
    direction[2] = sin(zenith) * sin(azimuth);
}

static uint64_t fingerprint_of(const struct optics_sky_settings *s, const struct optics_sun *sun)
{
    double numbers[12] = {s->model,     s->turbidity, s->sun,  s->brightness,      s->ground[0],
                          s->ground[1], s->ground[2], s->turn, sun->angular_radius};
    optics_sun_direction(sun, numbers + 9);
    uint64_t value = hash_bytes(hash_start, numbers, sizeof numbers);
    return hash_bytes(value, s->environment, strlen(s->environment));
}

static bool make_room(struct optics_sky *sky, const struct dpl_log *log)
{
    if (!sky->kept) {
        sky->kept = base_allocate(log, 1, sizeof *sky->kept, "sky");
        if (!sky->kept)
            return false;
        atmosphere_columns_make(&sky->kept->columns);
    }
    if (!sky->texels)
        sky->texels = base_allocate(log, (size_t)SKY_ROWS * SKY_COLUMNS * 3, sizeof(float), "sky");
    return sky->texels;
}

static void make_scattering(struct sky_kept *kept, const struct optics_sky_settings *settings)
{
    double ground = spectrum_luminance(settings->ground);
    if (kept->turbidity == settings->turbidity && kept->ground == ground)
        return;
    scattering_make(&kept->scattering, &kept->atmosphere, &kept->columns, ground);
    kept->turbidity = settings->turbidity;
    kept->ground = ground;
}

static void make_sun(struct optics_sky *sky, const struct optics_sky_settings *settings, const struct optics_sun *sun,
                     const double to_sun[3])
{
    const double point = 0.2665; /* degrees */
    double share = settings->sun >= 0 ? settings->sun : settings->model == SKY_OVERCAST ? 0 : 1;
    double radius = sin((sun->angular_radius > 0 ? sun->angular_radius : point) * M_PI / 180);
    sky_clear_sun(sky->kept, to_sun, sky->sun);
    for (int c = 0; c < 3; c++) {
        sky->sun[c] *= share * settings->brightness;
        sky->sun_radiance[c] = sky->sun[c] / (M_PI * radius * radius);
    }
}

/* The sky's irradiance on level ground; exact for texels that are even. Then the ground, which throws it back. */
static void make_ground(struct optics_sky *sky, const struct optics_sky_settings *settings, const double to_sun[3])
{
    sky->irradiance[0] = sky->irradiance[1] = sky->irradiance[2] = 0;
    for (int j = 0; j < SKY_HORIZON; j++) {
        double top = sin(M_PI * j / SKY_ROWS), bottom = sin(M_PI * (j + 1) / SKY_ROWS);
        double share = (bottom * bottom - top * top) / 2 * 2 * M_PI / SKY_COLUMNS;
        for (int i = 0; i < SKY_COLUMNS * 3; i++)
            sky->irradiance[i % 3] += share * (double)sky->texels[j * SKY_COLUMNS * 3 + i];
    }
    float ground[3];
    for (int c = 0; c < 3; c++)
        ground[c] = (float)(settings->ground[c] * (sky->irradiance[c] + sky->sun[c] * to_sun[1]) / M_PI);
    for (int i = SKY_HORIZON * SKY_COLUMNS * 3; i < SKY_ROWS * SKY_COLUMNS * 3; i++)
        sky->texels[i] = ground[i % 3];
}

bool optics_sky_make(struct optics_sky *sky, const struct optics_sky_settings *settings, const struct optics_sun *sun,
                     const struct dpl_log *log)
{
    uint64_t fingerprint = fingerprint_of(settings, sun);
    if (sky->texels && sky->fingerprint == fingerprint)
        return true;
    double to_sun[3];
    optics_sun_direction(sun, to_sun);
    if (!make_room(sky, log) ||
        (settings->model == SKY_ENVIRONMENT && !sky_environment_read(sky->kept, settings->environment, log)))
        return false;
    sky->kept->atmosphere = atmosphere_of(settings->turbidity);
    if (settings->model == SKY_CLEAR) {
        make_scattering(sky->kept, settings);
        sky_clear_draw(sky->kept, to_sun, sky->texels);
    } else if (settings->model == SKY_OVERCAST) {
        sky_overcast_draw(to_sun, sky->texels);
    } else {
        sky_environment_draw(sky->kept, settings->turn, sky->texels);
    }
    for (int i = 0; i < SKY_HORIZON * SKY_COLUMNS * 3; i++)
        sky->texels[i] *= (float)settings->brightness;
    make_sun(sky, settings, sun, to_sun);
    make_ground(sky, settings, to_sun);
    sky->fingerprint = fingerprint;
    return true;
}

void optics_sky_radiance(const struct optics_sky *sky, const double direction[3], double radiance[3])
{
    int above = direction[1] >= 0, first = above ? 0 : SKY_HORIZON, last = first + SKY_HORIZON - 1;
    double turns = atan2(direction[2], direction[0]) / (2 * M_PI);
    double column = (turns < 0 ? turns + 1 : turns) * SKY_COLUMNS - 0.5, left = floor(column);
    double row = acos(fmin(fmax(direction[1], -1), 1)) / M_PI * SKY_ROWS - 0.5;
    row = fmin(fmax(row, first), last);
    int i = ((int)left + SKY_COLUMNS) % SKY_COLUMNS, next = (i + 1) % SKY_COLUMNS;
    int j = (int)row, below = j < last ? j + 1 : j;
    double on = column - left, down = row - j;
    for (int c = 0; c < 3; c++) {
        const float *high = sky->texels + j * SKY_COLUMNS * 3 + c, *low = sky->texels + below * SKY_COLUMNS * 3 + c;
        radiance[c] = ((double)high[i * 3] * (1 - on) + (double)high[next * 3] * on) * (1 - down) +
                      ((double)low[i * 3] * (1 - on) + (double)low[next * 3] * on) * down;
    }
}

void optics_sky_finish(struct optics_sky *sky)
{
    if (sky->kept)
        free(sky->kept->picture);
    free(sky->kept);
    free(sky->texels);
    *sky = (struct optics_sky){0};
}
