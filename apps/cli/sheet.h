/* cli/sheet.h: what contact sheets are made of. */
#ifndef CLI_SHEET_H
#define CLI_SHEET_H

#include "cli/canvas.h"

#define SHEET_MARGIN 24                                     /* pixels */
#define SHEET_BAR 16                                        /* width of the scale beside a difference, pixels */
#define SHEET_SCALE (8 + SHEET_BAR + 8 + 9 * CANVAS_LETTER) /* width of all that is beside it */

extern canvas_color sheet_paper, sheet_ink;

/* The next of 1, 2, 5, 10, … that is not less. */
double sheet_round_up(double value);

/* One line of text from its upper left pixel on. */
void sheet_text(struct dpl_image *sheet, int x, int y, const char *format, ...) DPL_PRINTF(4, 5);

/* The colours of differences from +range above to -range below, to the right of a box that holds such a picture. */
void sheet_scale(struct dpl_image *sheet, struct box picture, double range);

#endif
