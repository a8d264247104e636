/* optics/refraction.h: what happens to a ray at the surface and in the water. optics/refraction.glsl is its twin.
 *
 * Vectors are unit vectors; x, y (up), z. */
#ifndef OPTICS_REFRACTION_H
#define OPTICS_REFRACTION_H

#include <stdbool.h>

/* Direction of the light that enters a medium of refractive index `ior` from air, by Snell's law in vector form
 * (Heckbert 1989). `to_light` points back along the incoming ray, `normal` out of the medium; their product is not
 * negative. An index of 1 or more always lets light in. */
void optics_refract(const double to_light[3], const double normal[3], double ior, double out[3]);

/* The other way: direction in which a ray leaves the medium for air (Foley et al. 1996). `ray` points along the ray
 * inside, `normal` out of the medium; their product is not negative. False where all light is thrown back inside: from
 * water at more than 48.6°. */
bool optics_refract_out(const double ray[3], const double normal[3], double ior, double out[3]);

/* Direction of the light that is thrown back. */
void optics_reflect(const double to_light[3], const double normal[3], double out[3]);

/* Share of unpolarised light that is thrown back where it arrives from air at an angle of that cosine, 0 to 1 (Fresnel
 * 1823). The rest enters. */
double optics_fresnel_reflectance(double cosine, double ior);

/* Share of the light that is left after a path of that length in metres; absorption coefficient in 1/m (Bouguer 1729).
 * A negative length, a path that is shorter than another, gains light: at most exp(OPTICS_GAIN_MOST), so that sums stay
 * finite in black water. */
#define OPTICS_GAIN_MOST 8.0
double optics_transmittance(double absorption, double length);

#endif
