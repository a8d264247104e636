/* io/format.h: the interface of a picture format, and the list of them. One file per format. */
#ifndef IO_FORMAT_H
#define IO_FORMAT_H

#include "dapple/image.h"

#include <stdio.h>

struct io_format {
    const char *ending; /* ".png" */
    /* Writes to the stream; the caller opens, closes and renames. `format` is complete: no zero stands for a default.
     * `path` is for messages only. */
    bool (*write)(FILE *stream, const struct dpl_image *image, const struct dpl_image_format *format, const char *path,
                  const struct dpl_log *log);
};

extern const struct io_format io_png, io_exr, io_pfm;

/* Reads a PNG of any kind as a new image, values 0 to 1 as stored (no gamma). Returns NULL, with the reason logged. */
struct dpl_image *io_png_read(const char *path, const struct dpl_log *log);

#endif
