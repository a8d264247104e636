/* PNG through libpng: 8 or 16 bits a channel, RGB, no gamma chunk: values are stored as they are. */
#include "base/log.h"
#include "io/format.h"

#include <errno.h>
#include <math.h>
#include <png.h>
#include <stdlib.h>
#include <string.h>

struct png_report {
    const struct dpl_log *log;
    const char *path;
    enum dpl_reason reason;
};

static void report_error(png_structp png, png_const_charp text)
{
    const struct png_report *report = png_get_error_ptr(png);
    base_fail(report->log, report->reason, "%s: %s", report->path, text);
    png_longjmp(png, 1);
}

static void ignore_warning(png_structp png, png_const_charp text)
{
    (void)png;
    (void)text;
}

/* One row of floats as big-endian bytes, rounded to the nearest. */
static void quantise_row(const float *row, int count, const struct dpl_image_format *format, png_byte *bytes)
{
    float largest = format->bits == 16 ? 65535.0f : 255.0f;
    for (int i = 0; i < count; i++) {
        float value = (row[i] - format->black) / (format->white - format->black);
        value = value > 0.0f ? fminf(value, 1.0f) : 0.0f;
        unsigned level = (unsigned)(value * largest + 0.5f);
        if (format->bits == 16)
            *bytes++ = (png_byte)(level >> 8);
        *bytes++ = (png_byte)(level & 255);
    }
}

static bool write_png(FILE *stream, const struct dpl_image *image, const struct dpl_image_format *format,
                      const char *path, const struct dpl_log *log)
{
    struct png_report report = {log, path, DPL_REASON_FILE_WRITE};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &report, report_error, ignore_warning);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    int count = image->width * image->channels;
    png_byte *bytes = base_allocate(log, (size_t)count, 2, path);
    if (!info || !bytes || setjmp(png_jmpbuf(png))) {
        png_destroy_write_struct(&png, &info);
        free(bytes);
        return false;
    }
    png_init_io(png, stream);
    png_set_IHDR(png, info, (png_uint_32)image->width, (png_uint_32)image->height, format->bits, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(png, 4);
    png_write_info(png, info);
    for (int y = 0; y < image->height; y++) {
        quantise_row(image->pixels + (size_t)y * (size_t)count, count, format, bytes);
        png_write_row(png, bytes);
    }
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    free(bytes);
    return true;
}

const struct io_format io_png = {".png", write_png};

struct dpl_image *io_png_read(const char *path, const struct dpl_log *log)
{
    png_image png = {.version = PNG_IMAGE_VERSION};
    if (!png_image_begin_read_from_file(&png, path)) {
        base_fail(log, DPL_REASON_FILE_READ, "%s: cannot be read as PNG: %s", path, png.message);
        return NULL;
    }
    png.format = PNG_FORMAT_RGB;
    struct dpl_image *image = NULL;
    if (png.width <= DPL_IMAGE_SIDE_MAX && png.height <= DPL_IMAGE_SIDE_MAX)
        image = dpl_image_create((int)png.width, (int)png.height, log);
    else
        base_fail(log, DPL_REASON_LIMIT, "%s: too large: %u × %u (at most %d each)", path, png.width, png.height,
                  DPL_IMAGE_SIDE_MAX);
    png_byte *bytes = image ? base_allocate(log, PNG_IMAGE_SIZE(png), 1, path) : NULL;
    if (!bytes || !png_image_finish_read(&png, NULL, bytes, 0, NULL)) {
        if (bytes)
            base_fail(log, DPL_REASON_FILE_READ, "%s: cannot be read as PNG: %s", path, png.message);
        png_image_free(&png);
        dpl_image_destroy(image);
        image = NULL;
    }
    for (size_t i = 0; image && i < PNG_IMAGE_SIZE(png); i++)
        image->pixels[i] = (float)bytes[i] / 255.0f;
    free(bytes);
    return image;
}
