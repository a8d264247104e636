/* All rows, then all columns. Columns are copied out in blocks as wide as a line of the cache, so that each line is
 * fetched once for all of them. */
#include "base/fft.h"

#include "base/log.h"
#include "base/threads.h"

#include <assert.h>
#include <kiss_fft.h>
#include <stdlib.h>
#include <string.h>

#define BLOCK 8 /* columns, 64 bytes */

struct fft {
    int side, threads; /* `threads`: that there is room for */
    kiss_fft_cfg plan;
    kiss_fft_cpx *lines; /* threads × (BLOCK + 1) × side */
};

struct fft *fft_create(int side, bool inverse, const struct dpl_log *log)
{
    assert(side >= 1);
    struct fft *fft = base_allocate(log, 1, sizeof *fft, "Fourier transform");
    if (!fft)
        return NULL;
    fft->side = side;
    fft->threads = threads_most();
    fft->lines =
        base_allocate(log, (size_t)fft->threads * (BLOCK + 1) * (size_t)side, sizeof *fft->lines, "Fourier transform");
    size_t size = 0;
    kiss_fft_alloc(side, inverse, NULL, &size);
    fft->plan = fft->lines ? base_allocate(log, 1, size, "Fourier transform") : NULL;
    if (fft->plan && kiss_fft_alloc(side, inverse, fft->plan, &size))
        return fft;
    fft_destroy(fft);
    return NULL;
}

void fft_run(const struct fft *fft, float (*grid)[2])
{
    size_t side = (size_t)fft->side;
    kiss_fft_cpx *cells = (kiss_fft_cpx *)grid;
    _Static_assert(sizeof *cells == sizeof *grid, "a complex number of kissfft is two floats");
#pragma omp parallel num_threads(fft->threads)
    {
        kiss_fft_cpx *lines = fft->lines + (size_t)threads_index() * (BLOCK + 1) * side, *done = lines + BLOCK * side;
#pragma omp for
        for (size_t j = 0; j < side; j++) {
            kiss_fft(fft->plan, cells + j * side, done);
            memcpy(cells + j * side, done, side * sizeof *done);
        }
#pragma omp for
        for (size_t from = 0; from < side; from += BLOCK) {
            size_t count = side - from < BLOCK ? side - from : BLOCK;
            for (size_t j = 0; j < side; j++)
                for (size_t i = 0; i < count; i++)
                    lines[i * side + j] = cells[j * side + from + i];
            for (size_t i = 0; i < count; i++) {
                kiss_fft(fft->plan, lines + i * side, done);
                memcpy(lines + i * side, done, side * sizeof *done);
            }
            for (size_t j = 0; j < side; j++)
                for (size_t i = 0; i < count; i++)
                    cells[j * side + from + i] = lines[i * side + j];
        }
    }
}

void fft_destroy(struct fft *fft)
{
    if (!fft)
        return;
    free(fft->plan);
    free(fft->lines);
    free(fft);
}
