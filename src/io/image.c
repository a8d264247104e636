#include "dapple/image.h"

#include "base/file.h"
#include "base/log.h"
#include "io/format.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Bytes: the largest image as floats, and as much again for what else a file may hold. */
#define FILE_SIZE_MAX ((size_t)DPL_IMAGE_SIDE_MAX * DPL_IMAGE_SIDE_MAX * 3 * sizeof(float) * 2)

static const struct io_format *const formats[] = {&io_png, &io_exr, &io_pfm, NULL};

struct dpl_image *dpl_image_create(int width, int height, const struct dpl_log *log)
{
    if (width < 1 || height < 1 || width > DPL_IMAGE_SIDE_MAX || height > DPL_IMAGE_SIDE_MAX) {
        base_fail(log, DPL_REASON_LIMIT, "image size out of range: %d × %d (1 to %d each)", width, height,
                  DPL_IMAGE_SIDE_MAX);
        return NULL;
    }
    struct dpl_image *image = base_allocate(log, 1, sizeof *image, "image");
    if (!image)
        return NULL;
    *image = (struct dpl_image){.width = width, .height = height, .channels = 3};
    image->pixels = base_allocate(log, (size_t)width * (size_t)height * 3, sizeof(float), "image");
    if (image->pixels)
        return image;
    free(image);
    return NULL;
}

void dpl_image_destroy(struct dpl_image *image)
{
    if (image)
        free(image->pixels);
    free(image);
}

static const struct io_format *find_format(const char *path, const struct dpl_log *log)
{
    const char *ending = strrchr(path, '.');
    for (int i = 0; ending && formats[i]; i++)
        if (!strcasecmp(ending, formats[i]->ending))
            return formats[i];
    base_fail(log, DPL_REASON_FILE_FORMAT, "%s: no picture format has the ending \"%s\" (accepted: .png, .exr, .pfm)",
              path, ending ? ending : "");
    return NULL;
}

bool dpl_image_format_known(const char *path, const struct dpl_log *log)
{
    return find_format(path, log) != NULL;
}

bool io_size_fits(long long width, long long height, const char *path, const struct dpl_log *log)
{
    return (width >= 1 && height >= 1 && width <= DPL_IMAGE_SIDE_MAX && height <= DPL_IMAGE_SIDE_MAX) ||
           base_fail(log, DPL_REASON_LIMIT, "%s: image size out of range: %lld × %lld (1 to %d each)", path, width,
                     height, DPL_IMAGE_SIDE_MAX);
}

struct dpl_image *io_read(const char *path, const struct dpl_log *log)
{
    const struct io_format *entry = find_format(path, log);
    size_t length = 0;
    char *bytes = entry ? file_read(path, FILE_SIZE_MAX, &length, log) : NULL;
    struct dpl_image *image = bytes ? entry->read(bytes, length, path, log) : NULL;
    free(bytes);
    return image;
}

bool dpl_image_save(const struct dpl_image *image, const char *path, const struct dpl_image_format *format,
                    const struct dpl_log *log)
{
    const struct io_format *entry = find_format(path, log);
    struct file_writer writer;
    if (!entry || !file_begin(&writer, path, log))
        return false;
    struct dpl_image_format complete = format ? *format : (struct dpl_image_format){0};
    if (complete.bits != 16)
        complete.bits = 8;
    if (complete.black == complete.white) {
        complete.black = 0;
        complete.white = 1;
    }
    return file_end(&writer, entry->write(writer.stream, image, &complete, path, log), log);
}
