/* cli/canvas.h: text, curves and other pictures drawn into an image. What lies outside of it is left out. */
#ifndef CLI_CANVAS_H
#define CLI_CANVAS_H

#include "dapple/image.h"

#define CANVAS_LETTER 12 /* pixels from one letter to the next */
#define CANVAS_LINE 26   /* pixels from one line of text to the next */

/* Pixels; x, y is the upper left one. */
struct box {
    int x, y, width, height;
};

typedef const float canvas_color[3]; /* displayable, 0 to 1 */

void canvas_fill(struct dpl_image *image, struct box box, canvas_color color);

/* The outline just outside of the box. */
void canvas_frame(struct dpl_image *image, struct box box, canvas_color color);

/* One line of text from its upper left pixel on; letters beyond ASCII look like question marks. */
void canvas_text(struct dpl_image *image, int x, int y, canvas_color color, const char *text);

/* Another image, enlarged or made smaller (each pixel the mean of those that it covers) to fill the box. */
void canvas_picture(struct dpl_image *image, struct box box, const struct dpl_image *picture);

/* The values from left to right of the box, 0 at its lower edge and `top` at its upper. */
void canvas_curve(struct dpl_image *image, struct box box, canvas_color color, const double *values, int count,
                  double top);

#endif
