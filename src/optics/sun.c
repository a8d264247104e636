#include "optics/sun.h"

#include <math.h>

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
    optics_sun_place(sun, (const double[2]){0, 0}, out);
}

/* A disc at right angles to the middle direction: the sine of a place's angle grows with its distance from the middle,
 * so equal areas of the disc stand for equal shares of the irradiance on it. */
void optics_sun_place(const struct optics_sun *sun, const double disc[2], double out[3])
{
    double elevation = sun->elevation * degree, azimuth = sun->azimuth * degree;
    double up = cos(elevation), middle = sin(elevation), radius = sin(sun->angular_radius * degree);
    double a = disc[0] * radius, b = disc[1] * radius, c = sqrt(1 - a * a - b * b);
    double along = c * up - a * middle; /* horizontally, towards the sun */
    out[0] = along * cos(azimuth) - b * sin(azimuth);
    out[1] = c * middle + a * up;
    out[2] = along * sin(azimuth) + b * cos(azimuth);
}
