/* measure/space.h: colour spaces. XYZ is in units of white. */
#ifndef MEASURE_SPACE_H
#define MEASURE_SPACE_H

/* A displayable value, 0 to 1, as sRGB stores it, and back (IEC 61966-2-1). What lies outside is clamped. */
double space_srgb_encode(double linear);
double space_srgb_decode(double stored);

void space_linear_to_xyz(const double linear[3], double xyz[3]);
void space_xyz_to_linear(const double xyz[3], double linear[3]);

/* L*a*b* (CIE 1976). */
void space_linear_to_lab(const double linear[3], double lab[3]);

/* Oklab (Ottosson 2020): lightness 0 to 1, from green to red, from blue to yellow. */
void space_oklab_to_linear(const double oklab[3], double linear[3]);

#endif
