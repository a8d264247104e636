#include "optics/sun.h"

#include "base/sine.h"
#include "optics/sun_clock.h"

static const char *by_name(int i)
{
    static const char *const names[] = {"angles", "clock"};
    return i >= 0 && i < (int)(sizeof names / sizeof *names) ? names[i] : NULL;
}

const struct dpl_param optics_sun_params[] = {
    PARAM_FLOAT(struct optics_sun, elevation, 60, SUN_LOWEST, 90, "degrees",
                "height of the sun above the horizon; 90 = overhead"),
    PARAM_FLOAT(struct optics_sun, azimuth, 30, -360, 360, "degrees", "direction towards the sun, from +x towards +z"),
    PARAM_FLOAT(struct optics_sun, angular_radius, 0.2665, 0, 10, "degrees", "half the sun's width; 0 = a point"),
    PARAM_CHOICE(struct optics_sun, by, SUN_BY_ANGLES, by_name,
                 "by its elevation and azimuth above, or by date, hour and place below, where +x is east and -z north; "
                 "lower than 1 degree it stays at 1"),
    PARAM_INTS(struct optics_sun, date, 3, 1, 3000, "", "year, month and day; months and days beyond the last count on",
               2024, 6, 21),
    PARAM_FLOAT(struct optics_sun, hour, 12, 0, 24, "h", "time of day, by the local clock"),
    PARAM_FLOAT(struct optics_sun, time_zone, 0, -14, 14, "h", "that the local clock is ahead of universal time"),
    PARAM_FLOAT(struct optics_sun, latitude, 45, -90, 90, "degrees", "of the place, north"),
    PARAM_FLOAT(struct optics_sun, longitude, 0, -180, 180, "degrees", "of the place, east"),
    PARAM_END,
};

static const double degree = M_PI / 180;

void optics_sun_angles(const struct optics_sun *sun, double *elevation, double *azimuth)
{
    *elevation = sun->elevation;
    *azimuth = sun->azimuth;
    if (sun->by != SUN_BY_CLOCK)
        return;
    const struct sun_clock clock = {sun->date, sun->hour, sun->time_zone, sun->latitude, sun->longitude};
    double bearing;
    sun_clock_read(&clock, elevation, &bearing);
    *elevation = fmin(fmax(*elevation, SUN_LOWEST), 90);
    *azimuth = bearing - 90;
}

void optics_sun_direction(const struct optics_sun *sun, double out[3])
{
    struct optics_disc disc = optics_sun_disc(sun);
    for (int i = 0; i < 3; i++)
        out[i] = disc.middle[i];
}

struct optics_disc optics_sun_disc(const struct optics_sun *sun)
{
    double elevation, azimuth;
    optics_sun_angles(sun, &elevation, &azimuth);
    elevation *= degree;
    azimuth *= degree;
    double radius = sin(sun->angular_radius * degree);
    return (struct optics_disc){
        .middle = {cos(elevation) * cos(azimuth), sin(elevation), cos(elevation) * sin(azimuth)},
        .up = {-radius * sin(elevation) * cos(azimuth), radius * cos(elevation),
               -radius * sin(elevation) * sin(azimuth)},
        .across = {-radius * sin(azimuth), 0, radius * cos(azimuth)},
        .radius = radius,
    };
}

/* A disc at right angles to the middle direction: the sine of a place's angle grows with its distance from the middle,
 * so equal areas of the disc stand for equal shares of the irradiance on it. */
void optics_disc_place(const struct optics_disc *disc, const double place[2], double out[3])
{
    double square = disc->radius * disc->radius * (place[0] * place[0] + place[1] * place[1]);
    for (int i = 0; i < 3; i++)
        out[i] = sqrt(1 - square) * disc->middle[i] + place[0] * disc->up[i] + place[1] * disc->across[i];
}

void optics_disc_spread(double u, double v, double place[2])
{
    double sine, cosine, radius = sqrt(u);
    sine_cosine(v, &sine, &cosine);
    place[0] = radius * cosine;
    place[1] = radius * sine;
}
