/* base/blue_noise.h: ranks of a square of texels such that those below any threshold lie evenly, without clumps. */
#ifndef BASE_BLUE_NOISE_H
#define BASE_BLUE_NOISE_H

#define BLUE_NOISE_SIDE 64

/* Fills side × side ranks, a permutation of 0 … side² - 1, that repeat without a seam: each next texel is the one
 * farthest from those before it, by a sum of Gaussians (the void of Ulichney 1993, "The void-and-cluster method"). */
void blue_noise(int seed, int ranks[BLUE_NOISE_SIDE * BLUE_NOISE_SIDE]);

#endif
