/* reference/draws.h: the random numbers of one path, from counters alone.
 *
 * The first numbers of a path step evenly over the paths of the same start (a low-discrepancy sequence, Roberts 2018,
 * "The unreasonable effectiveness of quasirandom sequences", with a start of its own for each pixel, Cranley &
 * Patterson 1976); those after them are plainly random. */
#ifndef REFERENCE_DRAWS_H
#define REFERENCE_DRAWS_H

#include "base/random.h"

struct draws {
    uint64_t start; /* of a pixel or a point */
    uint64_t path;  /* which of its paths */
    unsigned dimension;
};

/* The next number, 0 to 1 without 1. */
static inline double draws_next(struct draws *draws)
{
    /* 1/φ^k, φ^9 = φ + 1, in parts of 2^64 */
    static const uint64_t steps[8] = {0xebedeed9d803c815u, 0xd96eb1a810caaf5fu, 0xc862b36daf790dd5u,
                                      0xb8acd90c142fe10bu, 0xaa324f90ded86b69u, 0x9cda5e693fea10afu,
                                      0x908e3d2c82567a73u, 0x8538ecb5bd456ea3u};
    const uint64_t odd = 0x9e3779b97f4a7c15u;
    uint64_t dimension = draws->dimension++, bits = random_mix((draws->start ^ random_mix(dimension + 1)) + odd);
    bits = dimension < 8 ? bits + draws->path * steps[dimension] : random_mix(bits + (draws->path + 1) * odd);
    return (double)(bits >> 11) * 0x1p-53;
}

#endif
