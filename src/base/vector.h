/* base/vector.h: loops that the compiler turns into vector instructions.
 *
 * A function marked VECTOR_CLONES is compiled twice, for every x86-64 and for those with AVX2, and the machine picks
 * one when the program starts. */
#ifndef BASE_VECTOR_H
#define BASE_VECTOR_H

#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && __GNUC__ >= 12 &&                          \
    !defined(__SANITIZE_ADDRESS__)
#define VECTOR_CLONES __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define VECTOR_CLONES
#endif

#endif
