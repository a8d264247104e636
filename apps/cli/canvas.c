#include "cli/canvas.h"

#include "cli/letters.h"

#include <math.h>
#include <stdlib.h>

#define LETTER_SCALE 2 /* pixels of the image for one of a letter */

static int least(int a, int b)
{
    return a < b ? a : b;
}

static int most(int a, int b)
{
    return a > b ? a : b;
}

void canvas_fill(struct dpl_image *image, struct box box, canvas_color color)
{
    for (int y = most(box.y, 0); y < least(box.y + box.height, image->height); y++)
        for (int x = most(box.x, 0); x < least(box.x + box.width, image->width); x++)
            for (int c = 0; c < 3; c++)
                image->pixels[((size_t)y * (size_t)image->width + (size_t)x) * 3 + (size_t)c] = color[c];
}

void canvas_frame(struct dpl_image *image, struct box box, canvas_color color)
{
    int right = box.x + box.width, below = box.y + box.height;
    canvas_fill(image, (struct box){box.x - 1, box.y - 1, box.width + 2, 1}, color);
    canvas_fill(image, (struct box){box.x - 1, below, box.width + 2, 1}, color);
    canvas_fill(image, (struct box){box.x - 1, box.y, 1, box.height}, color);
    canvas_fill(image, (struct box){right, box.y, 1, box.height}, color);
}

void canvas_text(struct dpl_image *image, int x, int y, canvas_color color, const char *text)
{
    for (; *text; text++, x += CANVAS_LETTER)
        for (int j = 0; j < LETTER_HEIGHT; j++)
            for (int i = 0; i < LETTER_WIDTH; i++)
                if (letter_pixel(*text, i, j))
                    canvas_fill(image,
                                (struct box){x + i * LETTER_SCALE, y + j * LETTER_SCALE, LETTER_SCALE, LETTER_SCALE},
                                color);
}

/* The first of `from` pixels that the i-th of `to` covers. */
static int covered(int i, int from, int to)
{
    return (int)((long long)i * from / to);
}

/* The mean of the picture's pixels that pixel (i, j) of the box covers. */
static void mean_color(const struct dpl_image *picture, struct box box, int i, int j, float color[3])
{
    int left = covered(i, picture->width, box.width), top = covered(j, picture->height, box.height);
    int right = most(covered(i + 1, picture->width, box.width), left + 1);
    int below = most(covered(j + 1, picture->height, box.height), top + 1);
    double sums[3] = {0};
    for (int y = top; y < below; y++)
        for (int x = left; x < right; x++)
            for (int c = 0; c < 3; c++)
                sums[c] += picture->pixels[((size_t)y * (size_t)picture->width + (size_t)x) * 3 + (size_t)c];
    for (int c = 0; c < 3; c++)
        color[c] = (float)(sums[c] / ((double)(below - top) * (right - left)));
}

void canvas_picture(struct dpl_image *image, struct box box, const struct dpl_image *picture)
{
    for (int j = 0; j < box.height; j++)
        for (int i = 0; i < box.width; i++) {
            float color[3];
            mean_color(picture, box, i, j, color);
            canvas_fill(image, (struct box){box.x + i, box.y + j, 1, 1}, color);
        }
}

/* Pixels down from the upper edge. */
static int height_of(double value, double top, int height)
{
    return (int)fmin(fmax((1 - value / top) * (height - 1), 0), height - 1);
}

void canvas_curve(struct dpl_image *image, struct box box, canvas_color color, const double *values, int count,
                  double top)
{
    int last = height_of(values[0], top, box.height);
    for (int i = 0; i < box.width; i++) {
        double place = (double)i * (count - 1) / most(box.width - 1, 1);
        int left = (int)place, right = least(left + 1, count - 1);
        int y = height_of(values[left] + (values[right] - values[left]) * (place - left), top, box.height);
        canvas_fill(image, (struct box){box.x + i, box.y + least(y, last) - 1, 2, abs(y - last) + 2}, color);
        last = y;
    }
}
