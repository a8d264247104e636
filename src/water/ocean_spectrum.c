/* How much of the sea's height each wave has: measured spectra.
 *
 * The density by wave number is S(ω) · dω/dk / k · D(θ): energy by frequency, as measured, brought to wave numbers by
 * the dispersion relation of the water's depth, and shared out over the directions. */
#include "water/ocean.h"

#include <math.h>

#define PHILLIPS 0.0081 /* Phillips' constant (1958) */

double ocean_frequency(double k, double depth, double *group)
{
    double deep = tanh(k * depth), frequency = sqrt(WATER_GRAVITY * k * deep);
    if (group)
        *group = frequency > 0 ? WATER_GRAVITY * (deep + k * depth * (1 - deep * deep)) / (2 * frequency) : 0;
    return frequency;
}

/* Frequency at which a young sea has most energy (Hasselmann et al. 1973). */
static double peak_frequency(const struct ocean *ocean)
{
    return 22 * cbrt(WATER_GRAVITY * WATER_GRAVITY / (ocean->wind_speed * ocean->fetch));
}

/* JONSWAP, m²s (Hasselmann et al. 1973): fetch and wind fix the energy and the peak. */
static double jonswap(const struct ocean *ocean, double frequency)
{
    double peak = peak_frequency(ocean), lower = pow(peak / frequency, 4);
    if (!(lower < 500)) /* the exponential below is 0 */
        return 0;
    double alpha = 0.076 * pow(ocean->wind_speed * ocean->wind_speed / (WATER_GRAVITY * ocean->fetch), 0.22);
    double width = frequency <= peak ? 0.07 : 0.09, off = (frequency / peak - 1) / width;
    return alpha * WATER_GRAVITY * WATER_GRAVITY / pow(frequency, 5) * exp(-1.25 * lower) *
           pow(ocean->peak_enhancement, exp(-0.5 * off * off));
}

/* The share of a deep sea's energy that shallow water bears (Kitaigorodskii et al. 1975). */
static double depth_share(double k, double depth)
{
    double deep = tanh(k * depth);
    return deep * deep / (1 + 2 * k * depth / sinh(2 * k * depth));
}

/* Share of a direction, 1/rad: β / 2 · sech²(β θ), normalised over the circle (Donelan, Hamilton & Hui 1985; above 1.6
 * times the peak's frequency Banner 1990). */
static double direction_share(const struct ocean *ocean, double frequency, double angle)
{
    double ratio = frequency / peak_frequency(ocean), beta;
    if (ratio < 0.95)
        beta = 2.61 * pow(ratio, 1.3);
    else if (ratio < 1.6)
        beta = 2.28 * pow(ratio, -1.3);
    else
        beta = pow(10, -0.4 + 0.8393 * exp(-0.567 * log(ratio * ratio)));
    beta /= ocean->spreading;
    return beta / (2 * tanh(beta * M_PI) * pow(cosh(beta * angle), 2));
}

/* m⁴ (Tessendorf 2001): Phillips' equilibrium k⁻⁴, cut off where waves would be faster than the wind; cos² of the
 * angle to the wind, of which the half that runs against it is left out. */
static double phillips(const struct ocean *ocean, double k, double angle)
{
    double longest = ocean->wind_speed * ocean->wind_speed / WATER_GRAVITY, along = cos(angle);
    if (along <= 0)
        return 0;
    return PHILLIPS / 2 / pow(k, 4) * exp(-1 / pow(k * longest, 2)) * 2 / M_PI * along * along;
}

double ocean_density(const struct ocean *ocean, double depth, double kx, double kz)
{
    double k = hypot(kx, kz), angle = remainder(atan2(kz, kx) - ocean->wind_direction * M_PI / 180, 2 * M_PI);
    double kept = exp(-pow(k * ocean->smoothing, 2)); /* Tessendorf 2001, eq. 24 */
    if (ocean->spectrum == OCEAN_PHILLIPS)
        return kept * phillips(ocean, k, angle);
    double group, frequency = ocean_frequency(k, depth, &group), energy = kept * jonswap(ocean, frequency);
    if (energy == 0)
        return 0;
    if (ocean->spectrum == OCEAN_TMA)
        energy *= depth_share(k, depth);
    return energy * group / k * direction_share(ocean, frequency, angle);
}
