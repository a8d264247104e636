/* base/threads.h: which of how many OpenMP threads this is; one where there is no OpenMP. */
#ifndef BASE_THREADS_H
#define BASE_THREADS_H

#ifdef _OPENMP
#include <omp.h>
static inline int threads_most(void)
{
    return omp_get_max_threads();
}
static inline int threads_index(void)
{
    return omp_get_thread_num();
}
#else
static inline int threads_most(void)
{
    return 1;
}
static inline int threads_index(void)
{
    return 0;
}
#endif

#endif
