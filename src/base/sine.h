/* base/sine.h: sine and cosine without branches, for loops that the compiler turns into vector instructions. */
#ifndef BASE_SINE_H
#define BASE_SINE_H

#include <math.h>

/* Sine and cosine of that many whole turns, within 1e-13 of the number that `turns` is; |turns| < 2^51. Half the angle
 * lies within a quarter turn of 0, where few terms of the power series do. */
static inline void sine_cosine(double turns, double *sine, double *cosine)
{
    const double whole = 6755399441055744.0; /* 1.5 · 2^52: adding it leaves no room for a fraction */
    double a = M_PI * (turns - ((turns + whole) - whole)), q = a * a;
    double s = -1.0 / 121645100408832000;
    s = s * q + 1.0 / 355687428096000;
    s = s * q - 1.0 / 1307674368000;
    s = s * q + 1.0 / 6227020800;
    s = s * q - 1.0 / 39916800;
    s = s * q + 1.0 / 362880;
    s = s * q - 1.0 / 5040;
    s = s * q + 1.0 / 120;
    s = s * q - 1.0 / 6;
    s = a + a * q * s;
    double c = -1.0 / 6402373705728000;
    c = c * q + 1.0 / 20922789888000;
    c = c * q - 1.0 / 87178291200;
    c = c * q + 1.0 / 479001600;
    c = c * q - 1.0 / 3628800;
    c = c * q + 1.0 / 40320;
    c = c * q - 1.0 / 720;
    c = c * q + 1.0 / 24;
    c = c * q - 1.0 / 2;
    c = 1 + q * c;
    *sine = 2 * s * c;
    *cosine = 1 - 2 * s * s;
}

#endif
