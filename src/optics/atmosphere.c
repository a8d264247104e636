#include "optics/atmosphere.h"

#include "base/exponential.h"

#include <math.h>

#define AIR_HEIGHT 8000.0  /* m, in which the density of air falls by e (Bruneton & Neyret 2008) */
#define HAZE_HEIGHT 1200.0 /* likewise */

/* Ozone absorbs, cm² a molecule × 1e21, means over 20 nm at 233 K (Serdyuchenko et al. 2014). */
static const double ozone[SPECTRUM_COUNT] = {0.0047, 0.0214, 0.0699, 0.1949, 0.4297, 0.8384, 1.541, 2.447,
                                             3.296,  4.469,  4.550,  4.662,  3.478,  2.450,  1.663, 1.076};

struct atmosphere atmosphere_of(double turbidity)
{
    struct atmosphere atmosphere;
    const double ozone_peak = 300 * 2.687e16 / 15000;     /* molecules over 1 cm² for each metre: 300 Dobson units */
    double haze = fmax(0.04608 * turbidity - 0.04586, 0); /* Preetham et al. 1999, appendix A.1 */
    for (int w = 0; w < SPECTRUM_COUNT; w++) {
        double l = spectrum_wavelength(w) / 1000, square = 1 / (l * l); /* µm */
        /* optical depth of all air at sea level (Hansen & Travis 1974, eq. 2.29) */
        double air = 0.008569 * square * square * (1 + 0.0113 * square + 0.00013 * square * square);
        atmosphere.extinction[ATMOSPHERE_AIR][w] = (float)(air / AIR_HEIGHT);
        atmosphere.extinction[ATMOSPHERE_HAZE][w] = (float)(haze * pow(l, -1.3) / HAZE_HEIGHT); /* Ångström 1929 */
        atmosphere.extinction[ATMOSPHERE_OZONE][w] = (float)(ozone[w] * 1e-21 * ozone_peak);
    }
    return atmosphere;
}

/* Ozone: a tent from 10 to 40 km with its ridge at 25 km. */
void atmosphere_density(double radius, float density[ATMOSPHERE_PARTS])
{
    double height = fmax(radius - ATMOSPHERE_GROUND, 0);
    density[ATMOSPHERE_AIR] = exponential((float)(-height / AIR_HEIGHT));
    density[ATMOSPHERE_HAZE] = exponential((float)(-height / HAZE_HEIGHT));
    density[ATMOSPHERE_OZONE] = (float)fmax(1 - fabs(height - 25e3) / 15e3, 0);
}

/* m from a place on a sphere of the top's radius down to where a ray touches the ground. */
static double longest(void)
{
    return sqrt(ATMOSPHERE_TOP * ATMOSPHERE_TOP - ATMOSPHERE_GROUND * ATMOSPHERE_GROUND);
}

double atmosphere_path(double radius, double cosine, bool *meets_ground)
{
    double sine_square = radius * radius * (1 - cosine * cosine);
    double ground = ATMOSPHERE_GROUND * ATMOSPHERE_GROUND - sine_square;
    *meets_ground = cosine < 0 && ground > 0;
    if (*meets_ground)
        return fmax(-radius * cosine - sqrt(ground), 0);
    return fmax(-radius * cosine + sqrt(fmax(ATMOSPHERE_TOP * ATMOSPHERE_TOP - sine_square, 0)), 0);
}

/* Places in the table go with the distance to the horizon and with the length of the path, between the shortest and
 * the longest that there is (Bruneton & Neyret 2008, section 4). */
static void integrate(double radius, double cosine, double length, float column[ATMOSPHERE_PARTS])
{
    const int steps = 48;
    double sum[ATMOSPHERE_PARTS] = {0};
    for (int i = 0; i < steps; i++) {
        float density[ATMOSPHERE_PARTS];
        double share = (i + 0.5) / steps, along = length * share * share;
        double weight = 2 * share / steps * length;
        atmosphere_density(sqrt(radius * radius + along * along + 2 * radius * cosine * along), density);
        for (int p = 0; p < ATMOSPHERE_PARTS; p++)
            sum[p] += (double)density[p] * weight;
    }
    for (int p = 0; p < ATMOSPHERE_PARTS; p++)
        column[p] = (float)sum[p];
}

void atmosphere_columns_make(struct atmosphere_columns *columns)
{
#pragma omp parallel for
    for (int h = 0; h < ATMOSPHERE_HEIGHTS; h++) {
        double tangent = longest() * h / (ATMOSPHERE_HEIGHTS - 1);
        double radius = sqrt(tangent * tangent + ATMOSPHERE_GROUND * ATMOSPHERE_GROUND);
        double shortest = ATMOSPHERE_TOP - radius;
        for (int a = 0; a < ATMOSPHERE_ANGLES; a++) {
            double length = shortest + (tangent + longest() - shortest) * a / (ATMOSPHERE_ANGLES - 1);
            double cosine = length > 0 ? (ATMOSPHERE_TOP * ATMOSPHERE_TOP - radius * radius - length * length) /
                                             (2 * radius * length)
                                       : 1;
            integrate(radius, fmin(fmax(cosine, -1), 1), length, columns->column[h][a]);
        }
    }
}

void atmosphere_column(const struct atmosphere_columns *columns, double radius, double cosine,
                       float column[ATMOSPHERE_PARTS])
{
    double tangent = sqrt(fmax(radius * radius - ATMOSPHERE_GROUND * ATMOSPHERE_GROUND, 0));
    double above = fmax(cosine, -tangent / radius), shortest = ATMOSPHERE_TOP - radius;
    double reach = ATMOSPHERE_TOP * ATMOSPHERE_TOP - radius * radius * (1 - above * above);
    double length = -radius * above + sqrt(fmax(reach, 0)), span = tangent + longest() - shortest;
    double h = fmin(fmax(tangent / longest(), 0), 1) * (ATMOSPHERE_HEIGHTS - 1);
    double a = span > 0 ? fmin(fmax((length - shortest) / span, 0), 1) * (ATMOSPHERE_ANGLES - 1) : 0;
    int row = (int)fmin(h, ATMOSPHERE_HEIGHTS - 2), place = (int)fmin(a, ATMOSPHERE_ANGLES - 2);
    float up = (float)(h - row), on = (float)(a - place);
    for (int p = 0; p < ATMOSPHERE_PARTS; p++) {
        float low = columns->column[row][place][p] * (1 - on) + columns->column[row][place + 1][p] * on;
        float high = columns->column[row + 1][place][p] * (1 - on) + columns->column[row + 1][place + 1][p] * on;
        column[p] = low * (1 - up) + high * up;
    }
}

double atmosphere_sun_share(double radius, double cosine)
{
    const double disc = 0.00465; /* rad, half the sun's width */
    double dip = ATMOSPHERE_GROUND / fmax(radius, ATMOSPHERE_GROUND);
    double above = cosine + sqrt(1 - dip * dip); /* nearly the angle above the horizon */
    double share = fmin(fmax(above / (2 * disc) + 0.5, 0), 1);
    return share * share * (3 - 2 * share);
}
