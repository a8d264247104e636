/* A sky from a picture of the whole of it: as wide as all azimuths, as high as from the zenith to the nadir. */
#include "base/log.h"
#include "io/format.h"
#include "optics/sky_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool check(const struct dpl_image *image, const char *path, const struct dpl_log *log)
{
    size_t count = (size_t)image->width * (size_t)image->height * 3;
    for (size_t i = 0; i < count; i++)
        if (!isfinite(image->pixels[i]))
            return base_fail(log, DPL_REASON_FILE_FORMAT,
                             "%s: not a number, or infinite, in row %zu (accepted: finite radiances)", path,
                             i / 3 / (size_t)image->width);
    return true;
}

/* The mean of a part of the picture, in pixels from its corner, each as much as it is large in the sky; the picture
 * goes on round in x. What is negative counts as 0. */
static void average(const struct dpl_image *image, double left, double top, double width, double height, float mean[3])
{
    double sum[3] = {0}, area = 0;
    for (int y = (int)floor(top); y < top + height && y < image->height; y++) {
        double from = fmax(y, top) * M_PI / image->height, to = fmin(y + 1, top + height) * M_PI / image->height;
        double high = cos(from) - cos(to);
        for (int x = (int)floor(left); x < left + width; x++) {
            double share = high * (fmin(x + 1, left + width) - fmax(x, left));
            const float *pixel = image->pixels + ((size_t)y * (size_t)image->width + (size_t)(x % image->width)) * 3;
            for (int c = 0; c < 3; c++)
                sum[c] += share * fmax((double)pixel[c], 0);
            area += share;
        }
    }
    for (int c = 0; c < 3; c++)
        mean[c] = area > 0 ? (float)(sum[c] / area) : 0;
}

/* Widens what a texel covers to a pixel, so that a small picture is drawn smooth. */
static void resample(const struct dpl_image *image, float *texels)
{
    double wide = (double)image->width / SKY_COLUMNS, high = (double)image->height / SKY_ROWS;
    double width = fmax(wide, 1), height = fmax(high, 1);
    for (int j = 0; j < SKY_HORIZON; j++) {
        double top = fmin(fmax((j + 0.5) * high - height / 2, 0), fmax(image->height / 2.0 - height, 0));
        for (int i = 0; i < SKY_COLUMNS; i++) {
            double left = (i + 0.5) * wide - width / 2 + image->width; /* not negative */
            average(image, left, top, width, height, texels + (j * SKY_COLUMNS + i) * 3);
        }
    }
}

bool sky_environment_read(struct sky_kept *kept, const char *path, const struct dpl_log *outer)
{
    struct base_named_log named = {.name = "sky.environment", .outer = outer};
    const struct dpl_log *log = base_name_log(&named);
    if (kept->picture && !strcmp(kept->path, path))
        return true;
    if (!*path)
        return base_fail(log, DPL_REASON_VALUE, "no picture is named (accepted: a .exr or .pfm file)");
    struct dpl_image *image = io_read(path, log);
    bool ok = image && check(image, path, log);
    float *picture = ok ? base_allocate(log, (size_t)SKY_HORIZON * SKY_COLUMNS * 3, sizeof(float), "sky") : NULL;
    if (picture) {
        resample(image, picture);
        free(kept->picture);
        kept->picture = picture;
        memcpy(kept->path, path, strlen(path) + 1);
    }
    dpl_image_destroy(image);
    return picture;
}

void sky_environment_draw(const struct sky_kept *kept, double turn, float *texels)
{
    double shift = turn / 360 * SKY_COLUMNS, whole = floor(shift);
    float part = (float)(shift - whole);
    for (int j = 0; j < SKY_HORIZON; j++) {
        const float *row = kept->picture + j * SKY_COLUMNS * 3;
        for (int i = 0; i < SKY_COLUMNS; i++) {
            int from = (((i - (int)whole) % SKY_COLUMNS) + SKY_COLUMNS) % SKY_COLUMNS;
            int before = (from + SKY_COLUMNS - 1) % SKY_COLUMNS;
            for (int c = 0; c < 3; c++)
                texels[(j * SKY_COLUMNS + i) * 3 + c] = row[from * 3 + c] * (1 - part) + row[before * 3 + c] * part;
        }
    }
}
