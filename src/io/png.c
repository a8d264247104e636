/* PNG through libpng. Written: 8 or 16 bits a channel, RGB, no gamma chunk: values are stored as they are. Read: any
 * kind, as if it had none. */
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
    const char *what; /* opens the message */
    enum dpl_reason reason;
};

static void report_error(png_structp png, png_const_charp text)
{
    const struct png_report *report = png_get_error_ptr(png);
    base_fail(report->log, report->reason, "%s: %s%s", report->path, report->what, text);
    png_longjmp(png, 1);
}

/* libpng itself says nothing where it gets no memory to begin with. */
static bool fail_memory(const struct dpl_log *log, const char *path)
{
    return base_fail(log, DPL_REASON_LIMIT, "out of memory for %s: libpng has none", path);
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
    struct png_report report = {log, path, "", DPL_REASON_FILE_WRITE};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &report, report_error, ignore_warning);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    if (!info) {
        png_destroy_write_struct(&png, &info);
        return fail_memory(log, path);
    }
    int count = image->width * image->channels;
    png_byte *bytes = base_allocate(log, (size_t)count, 2, path);
    if (!bytes || setjmp(png_jmpbuf(png))) {
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

/* A file in memory that is being read. */
struct png_reading {
    struct png_report report;
    const char *bytes;
    size_t left; /* of the bytes */
    png_structp png;
    png_infop info;
    png_byte *levels; /* as decoded, 1 or 2 bytes each, big-endian */
    png_bytep *rows;  /* into them */
    struct dpl_image *image;
};

static void read_bytes(png_structp png, png_bytep bytes, png_size_t size)
{
    struct png_reading *reading = png_get_io_ptr(png);
    if (size > reading->left)
        png_error(png, "cut short");
    memcpy(bytes, reading->bytes, size);
    reading->bytes += size;
    reading->left -= size;
}

/* Whatever the file has becomes red, green and blue of 8 or 16 bits. */
static void read_header(struct png_reading *reading)
{
    png_structp png = reading->png;
    png_set_read_fn(png, reading, read_bytes);
    png_read_info(png, reading->info);
    png_set_expand(png);
    png_set_gray_to_rgb(png);
    png_set_strip_alpha(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, reading->info);
}

/* libpng comes back to the first line of this by a jump where the file is broken. */
static bool read_levels(struct png_reading *reading)
{
    if (setjmp(png_jmpbuf(reading->png)))
        return false;
    read_header(reading);
    const struct png_report *report = &reading->report;
    png_uint_32 width = png_get_image_width(reading->png, reading->info);
    png_uint_32 height = png_get_image_height(reading->png, reading->info);
    if (!io_size_fits(width, height, report->path, report->log))
        return false;
    size_t stride = png_get_rowbytes(reading->png, reading->info);
    reading->image = dpl_image_create((int)width, (int)height, report->log);
    reading->levels = base_allocate(report->log, height, stride, report->path);
    reading->rows = base_allocate(report->log, height, sizeof *reading->rows, report->path);
    if (!reading->image || !reading->levels || !reading->rows)
        return false;
    for (size_t y = 0; y < height; y++)
        reading->rows[y] = reading->levels + y * stride;
    png_read_image(reading->png, reading->rows);
    png_read_end(reading->png, NULL);
    return true;
}

static struct dpl_image *read_png(const char *bytes, size_t length, const char *path, const struct dpl_log *log)
{
    struct png_reading reading = {
        .report = {log, path, "cannot be read as PNG: ", DPL_REASON_FILE_FORMAT}, .bytes = bytes, .left = length};
    reading.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading.report, report_error, ignore_warning);
    reading.info = reading.png ? png_create_info_struct(reading.png) : NULL;
    bool ok = reading.info ? read_levels(&reading) : fail_memory(log, path);
    if (!ok) {
        dpl_image_destroy(reading.image);
        reading.image = NULL;
    }
    size_t count = ok ? (size_t)reading.image->width * (size_t)reading.image->height * 3 : 0;
    bool deep = ok && png_get_bit_depth(reading.png, reading.info) == 16;
    for (size_t i = 0; i < count; i++)
        reading.image->pixels[i] = deep ? (float)(reading.levels[2 * i] << 8 | reading.levels[2 * i + 1]) / 65535.0f
                                        : (float)reading.levels[i] / 255.0f;
    png_destroy_read_struct(&reading.png, &reading.info, NULL);
    free(reading.levels);
    free(reading.rows);
    return reading.image;
}

const struct io_format io_png = {".png", write_png, read_png};
