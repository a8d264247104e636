/* The sky under an even layer of clouds: the same all round, three times as bright overhead as at the horizon. */
#include "optics/sky_parts.h"

#include <math.h>

/* Moon & Spencer 1942, since 1955 the CIE's standard overcast sky, as bright as the mean of measurements: 300 lx and
 * 21000 lx × the sine of the sun's elevation on level ground (Krochmann & Seidl 1974), where the sun outside the
 * atmosphere gives 133100 lx. Clouds scatter all colours alike, and their light is close to sRGB's white. */
void sky_overcast_draw(const double to_sun[3], float *texels)
{
    double ground = (300 + 21000 * fmax(to_sun[1], 0)) / 133100;
    double zenith = ground * 9 / (7 * M_PI); /* the integral of cosine × (1 + 2 sine) / 3 is 7 π / 9 */
    for (int j = 0; j < SKY_HORIZON; j++) {
        double direction[3];
        sky_direction(0, j + 0.5, direction);
        for (int i = 0; i < SKY_COLUMNS * 3; i++)
            texels[j * SKY_COLUMNS * 3 + i] = (float)(zenith * (1 + 2 * direction[1]) / 3);
    }
}
