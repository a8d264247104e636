#include "measure/space.h"

#include <math.h>

static const double white[3] = {0.95042855, 1, 1.08890037}; /* D65, that of sRGB */

double space_srgb_encode(double linear)
{
    double value = fmin(fmax(linear, 0), 1);
    return value <= 0.0031308 ? 12.92 * value : 1.055 * pow(value, 1 / 2.4) - 0.055;
}

double space_srgb_decode(double stored)
{
    double value = fmin(fmax(stored, 0), 1);
    return value <= 0.04045 ? value / 12.92 : pow((value + 0.055) / 1.055, 2.4);
}

void space_linear_to_xyz(const double linear[3], double xyz[3])
{
    double r = linear[0], g = linear[1], b = linear[2];
    xyz[0] = (0.41238656 * r + 0.35759149 * g + 0.18045049 * b) / white[0];
    xyz[1] = 0.21263682 * r + 0.71518298 * g + 0.07218020 * b;
    xyz[2] = (0.01933062 * r + 0.11919716 * g + 0.95037259 * b) / white[2];
}

void space_xyz_to_linear(const double xyz[3], double linear[3])
{
    double x = xyz[0] * white[0], y = xyz[1], z = xyz[2] * white[2];
    linear[0] = 3.24100323 * x - 1.53739897 * y - 0.49861588 * z;
    linear[1] = -0.96922425 * x + 1.87592998 * y + 0.04155423 * z;
    linear[2] = 0.05563942 * x - 0.20401121 * y + 1.05714898 * z;
}

void space_linear_to_lab(const double linear[3], double lab[3])
{
    const double knee = 6.0 / 29;
    double f[3];
    space_linear_to_xyz(linear, f);
    for (int c = 0; c < 3; c++)
        f[c] = f[c] > knee * knee * knee ? cbrt(f[c]) : f[c] / (3 * knee * knee) + 4.0 / 29;
    lab[0] = 116 * f[1] - 16;
    lab[1] = 500 * (f[0] - f[1]);
    lab[2] = 200 * (f[1] - f[2]);
}

void space_oklab_to_linear(const double oklab[3], double linear[3])
{
    double l = pow(oklab[0] + 0.3963377774 * oklab[1] + 0.2158037573 * oklab[2], 3);
    double m = pow(oklab[0] - 0.1055613458 * oklab[1] - 0.0638541728 * oklab[2], 3);
    double s = pow(oklab[0] - 0.0894841775 * oklab[1] - 1.2914855480 * oklab[2], 3);
    linear[0] = +4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s;
    linear[1] = -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s;
    linear[2] = -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s;
}
