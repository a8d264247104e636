/* base/vector.h: loops that the compiler turns into vector instructions.
 *
 * A function marked VECTOR_CLONES is compiled twice, for every x86-64 and for those with AVX2, and the machine picks
 * one when the program starts. Conditions, fmaxf() and fminf() keep a loop from becoming vectors; what stands below
 * does not. */
#ifndef BASE_VECTOR_H
#define BASE_VECTOR_H

#include <math.h>

#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && __GNUC__ >= 12 &&                          \
    !defined(__SANITIZE_ADDRESS__)
#define VECTOR_CLONES __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define VECTOR_CLONES
#endif

/* Part of a function marked VECTOR_CLONES, and of each of its copies. */
#define VECTOR_PART static inline __attribute__((always_inline))

/* x where it is positive, otherwise 0; exact. */
VECTOR_PART float vector_positive(float x)
{
    return 0.5f * (x + fabsf(x));
}

/* x between two ends, with the rounding of a sum. */
VECTOR_PART float vector_clamp(float x, float least, float most)
{
    return most - vector_positive(most - (least + vector_positive(x - least)));
}

#endif
