/* dapple/image.h: pictures and maps in memory, and in files.
 *
 * Row 0 is the top row of the picture; in a map of the floor it is the row of the smallest z. Values are linear and
 * unclamped floats; what a file format cannot hold is said at dpl_image_save(). */
#ifndef DAPPLE_IMAGE_H
#define DAPPLE_IMAGE_H

#include "dapple/log.h"

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

#define DPL_IMAGE_SIDE_MAX 16384 /* pixels, width and height */

struct dpl_image {
    int width, height; /* pixels, 1 to DPL_IMAGE_SIDE_MAX */
    int channels;      /* 3 */
    float *pixels;     /* height × width × channels, owned by the image */
};

/* Returns an image full of zeros, or NULL where the size is out of range or memory is short. */
DPL_API struct dpl_image *dpl_image_create(int width, int height, const struct dpl_log *log);
/* NULL is allowed. */
DPL_API void dpl_image_destroy(struct dpl_image *image);

/* How a file is written. {0} is a good start: 8 bits, black at 0, white at 1. */
struct dpl_image_format {
    int bits;           /* PNG: 8 or 16 a channel; 0 means 8. EXR and PFM always hold 32-bit floats. */
    float black, white; /* PNG: the values stored as 0 and as the largest number; both 0 means 0 and 1 */
};

/* Writes the image as the name's ending says: .png (clamped to black … white), .exr (RGB, 32-bit float), .pfm
 * (colour, 32-bit float, bottom row first as that format wants). The file appears whole or not at all: it is
 * written beside its place under another name, then renamed. `format` may be NULL. */
DPL_API bool dpl_image_save(const struct dpl_image *image, const char *path, const struct dpl_image_format *format,
                            const struct dpl_log *log);

/* True where the ending is one that dpl_image_save() knows; otherwise the reason is logged. */
DPL_API bool dpl_image_format_known(const char *path, const struct dpl_log *log);

#ifdef __cplusplus
}
#endif

#endif
