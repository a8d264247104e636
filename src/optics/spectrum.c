#include "optics/spectrum.h"

#include <math.h>

/* W/(m² nm) outside the atmosphere, means over 20 nm (ASTM G-173, 2003). */
static const double sunlight[SPECTRUM_COUNT] = {1.080, 1.729, 1.651, 1.973, 2.021, 1.946, 1.873, 1.881,
                                                1.851, 1.834, 1.798, 1.725, 1.664, 1.563, 1.534, 1.461};

double spectrum_wavelength(int index)
{
    return 390 + 20 * index;
}

static double lobe(double wavelength, double middle, double below, double above)
{
    double x = (wavelength - middle) / (wavelength < middle ? below : above);
    return exp(-x * x / 2);
}

/* The standard observer of 1931, X Y Z (Wyman, Sloan & Shirley 2013, table 1). */
static void match_color(double w, double xyz[3])
{
    xyz[0] =
        1.056 * lobe(w, 599.8, 37.9, 31.0) + 0.362 * lobe(w, 442.0, 16.0, 26.7) - 0.065 * lobe(w, 501.1, 20.4, 26.2);
    xyz[1] = 0.821 * lobe(w, 568.8, 46.9, 40.5) + 0.286 * lobe(w, 530.9, 16.3, 31.1);
    xyz[2] = 1.217 * lobe(w, 437.0, 11.8, 36.0) + 0.681 * lobe(w, 459.0, 26.0, 13.8);
}

/* IEC 61966-2-1. */
static void to_rgb(const double xyz[3], double rgb[3])
{
    static const double matrix[3][3] = {
        {3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}};
    for (int c = 0; c < 3; c++)
        rgb[c] = matrix[c][0] * xyz[0] + matrix[c][1] * xyz[1] + matrix[c][2] * xyz[2];
}

void spectrum_sunlight(double rgb[SPECTRUM_COUNT][3])
{
    double luminance = 0;
    for (int w = 0; w < SPECTRUM_COUNT; w++) {
        double xyz[3];
        match_color(spectrum_wavelength(w), xyz);
        luminance += xyz[1] * sunlight[w];
        to_rgb(xyz, rgb[w]);
    }
    for (int w = 0; w < SPECTRUM_COUNT; w++)
        for (int c = 0; c < 3; c++)
            rgb[w][c] *= sunlight[w] / luminance;
}

double spectrum_luminance(const double rgb[3])
{
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

void spectrum_fit(double rgb[3])
{
    double luminance = spectrum_luminance(rgb), least = fmin(fmin(rgb[0], rgb[1]), rgb[2]);
    double kept = luminance > 0 ? fmin(luminance / (luminance - fmin(least, 0)), 1) : 0;
    for (int c = 0; c < 3; c++)
        rgb[c] = fmax(luminance + (rgb[c] - luminance) * kept, 0);
}
