#include "optics/sun.h"

#include "base/sine.h"

const struct dpl_param optics_sun_params[] = {
    PARAM_FLOAT(struct optics_sun, elevation, 60, 1, 90, "degrees",
                "height of the sun above the horizon; 90 = overhead"),
    PARAM_FLOAT(struct optics_sun, azimuth, 30, -360, 360, "degrees", "direction towards the sun, from +x towards +z"),
    PARAM_FLOAT(struct optics_sun, angular_radius, 0.2665, 0, 10, "degrees", "half the sun's width; 0 = a point"),
    PARAM_END,
};

static const double degree = M_PI / 180;

void optics_sun_direction(const struct optics_sun *sun, double out[3])
{
    struct optics_disc disc = optics_sun_disc(sun);
    for (int i = 0; i < 3; i++)
        out[i] = disc.middle[i];
}

struct optics_disc optics_sun_disc(const struct optics_sun *sun)
{
    double elevation = sun->elevation * degree, azimuth = sun->azimuth * degree;
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
