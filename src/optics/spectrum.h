/* optics/spectrum.h: light by wavelength, and as linear red green blue (sRGB's primaries and white). */
#ifndef OPTICS_SPECTRUM_H
#define OPTICS_SPECTRUM_H

#define SPECTRUM_COUNT 16 /* wavelengths: 390, 410, … 690 nm */

/* nm */
double spectrum_wavelength(int index);

/* What the sun's light outside the atmosphere adds to red, green and blue at each wavelength; all of it together has
 * the luminance 1. */
void spectrum_sunlight(double rgb[SPECTRUM_COUNT][3]);

double spectrum_luminance(const double rgb[3]);

/* Mixes in as much grey of the same luminance as a colour that the primaries cannot show needs to have no negative
 * part. One whose luminance is not positive becomes black. */
void spectrum_fit(double rgb[3]);

#endif
