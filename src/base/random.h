/* base/random.h: random numbers from counters: the same wherever and in whatever order they are asked for. */
#ifndef BASE_RANDOM_H
#define BASE_RANDOM_H

#include <stdint.h>

/* Mixes a number's bits (the finalizer of SplitMix64, Steele, Lea & Flood 2014). */
static inline uint64_t random_mix(uint64_t bits)
{
    bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ bits >> 27) * 0x94d049bb133111ebu;
    return bits ^ bits >> 31;
}

/* From 0 to 1, without 1. */
static inline double random_fraction(uint64_t counter)
{
    return (double)(random_mix(counter) >> 11) * 0x1p-53;
}

#endif
