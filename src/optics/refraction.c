#include "optics/refraction.h"

#include <math.h>

void optics_refract(const double to_light[3], const double normal[3], double ior, double out[3])
{
    double cosine = to_light[0] * normal[0] + to_light[1] * normal[1] + to_light[2] * normal[2];
    double inside = sqrt(fmax(ior * ior - 1 + cosine * cosine, 0)); /* ior × cosine of the angle of refraction */
    for (int i = 0; i < 3; i++)
        out[i] = ((cosine - inside) * normal[i] - to_light[i]) / ior;
}

bool optics_refract_out(const double ray[3], const double normal[3], double ior, double out[3])
{
    double cosine = ray[0] * normal[0] + ray[1] * normal[1] + ray[2] * normal[2];
    double outside = 1 - ior * ior * (1 - cosine * cosine); /* squared cosine of the angle in air */
    if (outside < 0)
        return false;
    for (int i = 0; i < 3; i++)
        out[i] = ior * ray[i] + (sqrt(outside) - ior * cosine) * normal[i];
    return true;
}

void optics_reflect(const double to_light[3], const double normal[3], double out[3])
{
    double cosine = to_light[0] * normal[0] + to_light[1] * normal[1] + to_light[2] * normal[2];
    for (int i = 0; i < 3; i++)
        out[i] = 2 * cosine * normal[i] - to_light[i];
}

double optics_fresnel_reflectance(double cosine, double ior)
{
    double inside = sqrt(fmax(ior * ior - 1 + cosine * cosine, 0)); /* as above */
    if (inside + cosine <= 0)
        return 1; /* grazing, and no step of the index: 0 / 0 */
    double across = (cosine - inside) / (cosine + inside);
    double along = (ior * ior * cosine - inside) / (ior * ior * cosine + inside);
    return (across * across + along * along) / 2;
}

double optics_transmittance(double absorption, double length)
{
    return exp(fmin(-absorption * length, OPTICS_GAIN_MOST));
}
