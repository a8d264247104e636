/* PFM: "PF", size, byte order, then RGB floats, bottom row first. */
#include "base/log.h"
#include "io/format.h"

#include <errno.h>
#include <string.h>

static bool write_pfm(FILE *stream, const struct dpl_image *image, const struct dpl_image_format *format,
                      const char *path, const struct dpl_log *log)
{
    (void)format;
    const unsigned one = 1;
    bool little_endian = *(const unsigned char *)&one == 1;
    size_t count = (size_t)image->width * (size_t)image->channels;
    bool ok = fprintf(stream, "PF\n%d %d\n%s\n", image->width, image->height, little_endian ? "-1.0" : "1.0") > 0;
    for (int y = image->height - 1; ok && y >= 0; y--)
        ok = fwrite(image->pixels + (size_t)y * count, sizeof(float), count, stream) == count;
    return ok || base_fail(log, DPL_REASON_FILE_WRITE, "%s: cannot be written: %s", path, strerror(errno));
}

const struct io_format io_pfm = {".pfm", write_pfm};
