/* io/format.h: the interface of a picture format, and the list of them. One file per format. */
#ifndef IO_FORMAT_H
#define IO_FORMAT_H

#include "dapple/image.h"

#include <stddef.h>
#include <stdio.h>

struct io_format {
    const char *ending; /* ".png" */
    /* Writes to the stream; the caller opens, closes and renames. `format` is complete: no zero stands for a default.
     * `path` is for messages only. */
    bool (*write)(FILE *stream, const struct dpl_image *image, const struct dpl_image_format *format, const char *path,
                  const struct dpl_log *log);
    /* Reads a whole file that may hold anything; a zero byte follows its last. Returns NULL, with the reason logged. */
    struct dpl_image *(*read)(const char *bytes, size_t length, const char *path, const struct dpl_log *log);
};

extern const struct io_format io_png, io_exr, io_pfm;

/* Reads a picture as a new image, by the format that its name's ending says; one of a single channel is read as grey.
 * Row 0 is the top row. PNG, of any kind: values 0 to 1 as stored (no gamma), no alpha. EXR: scan lines of the first
 * part; R, G and B, or else Y, or else the only channel there is. EXR and PFM may hold values that are not finite.
 * Returns NULL, with the reason logged. */
struct dpl_image *io_read(const char *path, const struct dpl_log *log);

/* True where an image may have the size that a file says of itself; otherwise the reason is logged. */
bool io_size_fits(long long width, long long height, const char *path, const struct dpl_log *log);

#endif
