/* measure/pair.h: the checks that every measure of two images starts with. */
#ifndef MEASURE_PAIR_H
#define MEASURE_PAIR_H

#include "dapple/image.h"

#include <stddef.h>

/* True where the images are of one size and hold finite values; otherwise the reason is logged. */
bool pair_check(const struct dpl_image *image, const struct dpl_image *reference, const struct dpl_log *log);

/* Numbers in an image. */
size_t pair_count(const struct dpl_image *image);

#endif
