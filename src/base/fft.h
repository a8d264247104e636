/* base/fft.h: the discrete Fourier transform of square grids of complex numbers, through kissfft. */
#ifndef BASE_FFT_H
#define BASE_FFT_H

#include "dapple/log.h"

#include <stdbool.h>

/* A plan, kept by who transforms again and again. */
struct fft;

/* For grids of side × side, side ≥ 1: fast where it is a product of twos, threes and fives. Forwards the sign in the
 * exponent is -, inverse it is +. Returns NULL, with the reason logged. */
struct fft *fft_create(int side, bool inverse, const struct dpl_log *log);

/* Transforms the grid in place, unnormalised: forwards and back multiplies it by side². Rows follow each other; an
 * entry is a real and an imaginary part; frequency k of either axis stands at k, -k at side - k. Runs in threads, with
 * the same result whatever their number; one plan serves one call at a time. */
void fft_run(const struct fft *fft, float (*grid)[2]);

/* NULL is allowed. */
void fft_destroy(struct fft *fft);

#endif
