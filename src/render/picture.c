#include "render/picture.h"

#include "base/log.h"

#include <stdlib.h>

#define SAMPLES_MAX (1 << 24) /* that are drawn at once; the look that needs the most keeps some 64 bytes of each */
#define STEP 16               /* pixels; tiles start at multiples, for looks that work on blocks of pixels */

/* A square of pixels, from the picture's lower left corner. */
struct area {
    int left, bottom, right, top;
};

static int at_most(int value, int most)
{
    return value < most ? value : most;
}

static int at_least(int value, int least)
{
    return value > least ? value : least;
}

struct picture_tiles picture_cut(const struct picture *picture, const struct dpl_gl *gl, int width, int height,
                                 int samples, int margin)
{
    int most = at_most(gl->info.texture_max, DPL_IMAGE_SIDE_MAX);
    struct picture_tiles tiles = {width, height, DPL_IMAGE_SIDE_MAX, 0, 1, 1};
    if (picture->side_max)
        most = at_most(most, picture->side_max);
    if (width <= most && height <= most && (long)width * height * at_least(samples, 1) <= SAMPLES_MAX)
        return tiles;
    int side = STEP;
    while (2 * side <= most && 4L * side * side * at_least(samples, 1) <= SAMPLES_MAX)
        side *= 2;
    tiles.margin = at_most((margin + STEP - 1) / STEP * STEP, side / 4 / STEP * STEP);
    tiles.side = at_least(side - 2 * tiles.margin, STEP);
    tiles.columns = (width + tiles.side - 1) / tiles.side;
    tiles.rows = (height + tiles.side - 1) / tiles.side;
    return tiles;
}

static struct area tile_area(const struct picture_tiles *tiles, int index, int margin)
{
    int left = index % tiles->columns * tiles->side, bottom = index / tiles->columns * tiles->side;
    return (struct area){at_least(left - margin, 0), at_least(bottom - margin, 0),
                         at_most(left + tiles->side + margin, tiles->width),
                         at_most(bottom + tiles->side + margin, tiles->height)};
}

struct camera_view picture_view(const struct picture_tiles *tiles, int index)
{
    struct area drawn = tile_area(tiles, index, tiles->margin);
    return (struct camera_view){.width = tiles->width,
                                .height = tiles->height,
                                .left = drawn.left,
                                .bottom = drawn.bottom,
                                .columns = drawn.right - drawn.left,
                                .rows = drawn.top - drawn.bottom};
}

/* Pixels of the drawn area, bottom row first, to the image's floats, top row first. */
static void join(const void *pixels, bool floats, const struct area *drawn, const struct area *kept,
                 struct dpl_image *image)
{
    int stride = drawn->right - drawn->left;
    for (int y = kept->bottom; y < kept->top; y++) {
        size_t row = (size_t)(y - drawn->bottom) * (size_t)stride * 4;
        float *out = image->pixels + (size_t)(image->height - 1 - y) * (size_t)image->width * 3;
        for (int x = kept->left; x < kept->right; x++)
            for (int c = 0; c < 3; c++) {
                size_t at = row + (size_t)((x - drawn->left) * 4 + c);
                out[x * 3 + c] =
                    floats ? ((const float *)pixels)[at] : (float)((const unsigned char *)pixels)[at] / 255.0f;
            }
    }
}

bool picture_read(struct picture *picture, struct gpu_texture *texture, struct dpl_gl *gl,
                  const struct picture_tiles *tiles, int index, struct dpl_image *image)
{
    bool floats = texture->format != GL_RGBA8;
    size_t size = (size_t)texture->width * (size_t)texture->height * 4 * (floats ? sizeof(float) : 1);
    if (picture->pixels_size < size) {
        free(picture->pixels);
        picture->pixels = base_allocate(gl->log, size, 1, "picture");
        picture->pixels_size = picture->pixels ? size : 0;
    }
    if (!picture->pixels)
        return false;
    struct area drawn = tile_area(tiles, index, tiles->margin), kept = tile_area(tiles, index, 0);
    texture_draw_to(gl, texture);
    gl->ReadPixels(0, 0, texture->width, texture->height, GL_RGBA, floats ? GL_FLOAT : GL_UNSIGNED_BYTE,
                   picture->pixels);
    join(picture->pixels, floats, &drawn, &kept, image);
    return true;
}

void picture_finish(struct picture *picture)
{
    free(picture->pixels);
}
