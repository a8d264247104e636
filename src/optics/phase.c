#include "optics/phase.h"

#include <math.h>

double optics_phase(double cosine, double anisotropy)
{
    double g = anisotropy, square = (1 - g) * (1 - g) + 2 * g * (1 - cosine);
    return (1 - g * g) / (4 * M_PI * square * sqrt(square));
}

double optics_phase_backward(double anisotropy)
{
    const double even = 1e-4; /* as below */
    double g = anisotropy;
    return fabs(g) < even ? 0.5 : (1 - g) / (2 * g) * ((1 + g) / sqrt(1 + g * g) - 1);
}

double optics_phase_cosine(double u, double anisotropy)
{
    const double even = 1e-4; /* below it the closed form divides by nearly nothing */
    double g = anisotropy;
    if (fabs(g) < even)
        return 2 * u - 1;
    double part = (1 - g * g) / (1 - g + 2 * g * u);
    return fmin(fmax((1 + g * g - part * part) / (2 * g), -1), 1);
}
