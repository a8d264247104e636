#include "measure/pair.h"

#include "base/log.h"

#include <math.h>

size_t pair_count(const struct dpl_image *image)
{
    return (size_t)image->width * (size_t)image->height * (size_t)image->channels;
}

static bool check_finite(const struct dpl_image *image, const char *name, const struct dpl_log *log)
{
    size_t count = pair_count(image);
    for (size_t i = 0; i < count; i++) {
        size_t texel = i / (size_t)image->channels, width = (size_t)image->width;
        if (!isfinite(image->pixels[i]))
            return base_fail(log, DPL_REASON_RANGE, "%s: not finite: \"%f\" at column %zu, row %zu", name,
                             (double)image->pixels[i], texel % width, texel / width);
    }
    return true;
}

bool pair_check(const struct dpl_image *image, const struct dpl_image *reference, const struct dpl_log *log)
{
    if (image->width != reference->width || image->height != reference->height)
        return base_fail(log, DPL_REASON_VALUE,
                         "image to measure: size: \"%d × %d\" (accepted: the reference's, %d × %d)", image->width,
                         image->height, reference->width, reference->height);
    return check_finite(image, "image to measure", log) && check_finite(reference, "reference", log);
}
