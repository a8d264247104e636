#include "cli/sheet.h"

#include "cli/log.h"
#include "dapple/measure.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

canvas_color sheet_paper = {1, 1, 1}, sheet_ink = {0.1f, 0.1f, 0.1f};

double sheet_round_up(double value)
{
    double power = value > 0 ? pow(10, floor(log10(value))) : 1;
    return value <= power ? power : value <= 2 * power ? 2 * power : value <= 5 * power ? 5 * power : 10 * power;
}

void sheet_text(struct dpl_image *sheet, int x, int y, const char *format, ...)
{
    char text[LOG_TEXT_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    canvas_text(sheet, x, y, sheet_ink, text);
}

void sheet_scale(struct dpl_image *sheet, struct box picture, double range)
{
    struct box bar = {picture.x + picture.width + 8, picture.y, SHEET_BAR, picture.height};
    int text = bar.x + SHEET_BAR + 8;
    for (int j = 0; j < bar.height; j++) {
        float color[3];
        dpl_false_color(DPL_COLORS_DIFFERENCE, 1 - 2 * (j + 0.5) / bar.height, color);
        canvas_fill(sheet, (struct box){bar.x, bar.y + j, SHEET_BAR, 1}, color);
    }
    canvas_frame(sheet, bar, sheet_ink);
    sheet_text(sheet, text, bar.y, "+%g", range);
    sheet_text(sheet, text, bar.y + bar.height / 2 - 7, "0");
    sheet_text(sheet, text, bar.y + bar.height - 16, "-%g", range);
}
