/* PFM: "PF", size, byte order, then RGB floats, bottom row first; "Pf" is the same in grey, and is only read. */
#include "base/log.h"
#include "io/format.h"

#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static bool machine_is_little_endian(void)
{
    const unsigned one = 1;
    return *(const unsigned char *)&one == 1;
}

static bool write_pfm(FILE *stream, const struct dpl_image *image, const struct dpl_image_format *format,
                      const char *path, const struct dpl_log *log)
{
    (void)format;
    size_t count = (size_t)image->width * (size_t)image->channels;
    bool ok = fprintf(stream, "PF\n%d %d\n%s\n", image->width, image->height,
                      machine_is_little_endian() ? "-1.0" : "1.0") > 0;
    for (int y = image->height - 1; ok && y >= 0; y--)
        ok = fwrite(image->pixels + (size_t)y * count, sizeof(float), count, stream) == count;
    return ok || base_fail(log, DPL_REASON_FILE_WRITE, "%s: cannot be written: %s", path, strerror(errno));
}

struct pfm_header {
    int channels; /* 1 or 3 */
    long width, height;
    bool little_endian;
    size_t size; /* bytes, of the header itself */
};

#define DIGITS "0123456789"

/* Skips white space and a number such as -1.0 or 1e-3, which strtod() would read with the point of the host's locale.
 * Returns its sign, as -1 or 1; 0 where there is none, or where it is 0. */
static int skip_number(const char **text)
{
    const char *at = *text + strspn(*text, " \t\r\n");
    int sign = *at == '-' ? -1 : 1;
    at += *at == '-' || *at == '+';
    const char *first = at;
    at += strspn(at, DIGITS);
    at += *at == '.';
    at += strspn(at, DIGITS);
    bool is_zero = first + strspn(first, "0.") >= at;
    if (*at == 'e' || *at == 'E') {
        at++;
        at += *at == '-' || *at == '+';
        at += strspn(at, DIGITS);
    }
    *text = at;
    return is_zero ? 0 : sign;
}

/* The header is text, and one white space ends it. A zero byte follows the file's last, so that no number is read
 * beyond it. */
static bool read_header(struct pfm_header *header, const char *bytes, size_t length)
{
    char *end;
    if (length < 3 || bytes[0] != 'P' || (bytes[1] != 'F' && bytes[1] != 'f'))
        return false;
    header->channels = bytes[1] == 'F' ? 3 : 1;
    header->width = strtol(bytes + 2, &end, 10);
    header->height = strtol(end, &end, 10);
    const char *after = end;
    int order = skip_number(&after); /* its size means nothing here */
    header->little_endian = order < 0;
    header->size = (size_t)(after - bytes) + 1;
    return order != 0 && *after && strchr(" \t\r\n", *after);
}

static float float_from(const char *bytes, bool swapped)
{
    uint32_t word;
    memcpy(&word, bytes, sizeof word);
    if (swapped)
        word = word >> 24 | (word >> 8 & 0xff00) | (word << 8 & 0xff0000) | word << 24;
    float value;
    memcpy(&value, &word, sizeof value);
    return value;
}

static struct dpl_image *read_pfm(const char *bytes, size_t length, const char *path, const struct dpl_log *log)
{
    struct pfm_header header;
    if (!read_header(&header, bytes, length)) {
        base_fail(log, DPL_REASON_FILE_FORMAT, "%s: cannot be read as PFM: no such header", path);
        return NULL;
    }
    if (!io_size_fits(header.width, header.height, path, log))
        return NULL;
    size_t wanted = (size_t)header.width * (size_t)header.height * (size_t)header.channels * sizeof(float);
    if (length - header.size != wanted) {
        base_fail(log, DPL_REASON_FILE_FORMAT, "%s: %zu bytes of values (%ld × %ld × %d values are %zu)", path,
                  length - header.size, header.width, header.height, header.channels, wanted);
        return NULL;
    }
    struct dpl_image *image = dpl_image_create((int)header.width, (int)header.height, log);
    if (!image)
        return NULL;
    bool swapped = header.little_endian != machine_is_little_endian();
    size_t row = (size_t)header.width * (size_t)header.channels;
    for (size_t y = 0; y < (size_t)header.height; y++) {
        const char *line = bytes + header.size + ((size_t)header.height - 1 - y) * row * sizeof(float);
        float *pixels = image->pixels + y * (size_t)header.width * 3;
        for (size_t i = 0; i < (size_t)header.width * 3; i++)
            pixels[i] = float_from(line + (header.channels == 3 ? i : i / 3) * sizeof(float), swapped);
    }
    return image;
}

const struct io_format io_pfm = {".pfm", write_pfm, read_pfm};
