/* The contact sheet of a comparison: the reference, then a row for each technique. */
#include "cli/compare.h"
#include "cli/sheet.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Pixels. */
#define MARGIN SHEET_MARGIN
#define SIDE 384  /* of a map */
#define CURVE 580 /* width of the curves */
#define DIFFERENCE_X (MARGIN + SIDE + MARGIN)
#define CURVE_X (DIFFERENCE_X + SIDE + SHEET_SCALE + MARGIN)
#define WIDTH (CURVE_X + CURVE + MARGIN)
#define HEAD (2 * MARGIN + 3 * CANVAS_LINE)
#define ROW (2 * CANVAS_LINE + SIDE + MARGIN)
#define ROW_FAILED (2 * CANVAS_LINE)

static canvas_color faint = {0.75f, 0.75f, 0.75f};
static canvas_color grey = {0.55f, 0.55f, 0.55f}, red = {0.8f, 0.15f, 0.1f};

struct sheet {
    struct dpl_image *image;
    const struct compare *compare;
    double mean;   /* of the reference: the unit of what follows */
    int line;      /* row of the maps that the curves show */
    double *curve; /* that line of the reference … */
    double *tried; /* … and of a technique */
};

static double mean_of_channels(const struct dpl_image *image, size_t pixel)
{
    const float *values = image->pixels + pixel * 3;
    return ((double)values[0] + values[1] + values[2]) / 3;
}

/* Row of the greatest sum, where what is shown as white counts as no brighter: one spot does not decide. */
static int brightest_line(const struct dpl_image *map, double white)
{
    int brightest = 0;
    double most = -1;
    for (int j = 0; j < map->height; j++) {
        double sum = 0;
        for (int i = 0; i < map->width; i++)
            sum += fmin(mean_of_channels(map, (size_t)j * (size_t)map->width + (size_t)i), white);
        if (sum > most)
            brightest = j;
        most = fmax(most, sum);
    }
    return brightest;
}

/* The line of a map times the gain. Returns its largest value. */
static double read_line(const struct sheet *sheet, const struct dpl_image *map, double gain, double *values)
{
    double most = 0;
    for (int i = 0; i < map->width; i++) {
        size_t texel = (size_t)sheet->line * (size_t)map->width + (size_t)i;
        values[i] = gain * mean_of_channels(map, texel) / sheet->mean;
        most = fmax(most, values[i]);
    }
    return most;
}

/* A map, and where the line of the curves runs. */
static bool draw_map(const struct sheet *sheet, const struct dpl_image *map, double gain, int y)
{
    struct box box = {MARGIN, y, SIDE, SIDE};
    struct dpl_image *shown = dpl_image_create(SIDE, SIDE, &sheet->compare->session.log->log);
    if (!shown)
        return false;
    canvas_picture(shown, (struct box){0, 0, SIDE, SIDE}, map);
    compare_expose(sheet->compare, gain, shown);
    canvas_picture(sheet->image, box, shown);
    canvas_frame(sheet->image, box, sheet_ink);
    int line = y + (int)((sheet->line + 0.5) * SIDE / map->height);
    canvas_fill(sheet->image, (struct box){MARGIN - 12, line, 10, 2}, red);
    canvas_fill(sheet->image, (struct box){MARGIN + SIDE + 2, line, 10, 2}, red);
    dpl_image_destroy(shown);
    return true;
}

static bool draw_difference(const struct sheet *sheet, const struct comparison *comparison, int y)
{
    const struct dpl_log *log = &sheet->compare->session.log->log;
    const struct dpl_image *reference = sheet->compare->reference;
    struct box box = {DIFFERENCE_X, y, SIDE, SIDE};
    double range = sheet_round_up(fmax(comparison->measure.p99, 1e-6));
    struct dpl_image *colors = dpl_measure_colors(comparison->map, reference, comparison->measure.gain,
                                                  range * sheet->mean, DPL_COLORS_DIFFERENCE, log);
    if (!colors)
        return false;
    canvas_picture(sheet->image, box, colors);
    canvas_frame(sheet->image, box, sheet_ink);
    sheet_scale(sheet->image, box, range);
    dpl_image_destroy(colors);
    return true;
}

/* `comparison`: NULL draws the reference alone. */
static void draw_curves(const struct sheet *sheet, const struct comparison *comparison, int y)
{
    const struct dpl_image *reference = sheet->compare->reference;
    struct box box = {CURVE_X, y, CURVE, SIDE};
    char text[32];
    double top = read_line(sheet, reference, 1, sheet->curve);
    if (comparison)
        top = fmax(top, read_line(sheet, comparison->map, comparison->measure.gain, sheet->tried));
    top = sheet_round_up(top);
    for (int quarter = 1; quarter < 4; quarter++)
        canvas_fill(sheet->image, (struct box){CURVE_X, y + quarter * SIDE / 4, CURVE, 1}, faint);
    canvas_curve(sheet->image, box, grey, sheet->curve, reference->width, top);
    if (comparison)
        canvas_curve(sheet->image, box, red, sheet->tried, reference->width, top);
    canvas_frame(sheet->image, box, sheet_ink);
    snprintf(text, sizeof text, "%g", top);
    sheet_text(sheet->image, CURVE_X - 6 - CANVAS_LETTER * (int)strlen(text), y, "%s", text);
    sheet_text(sheet->image, CURVE_X - 6 - CANVAS_LETTER, y + SIDE - 16, "0");
}

static bool draw_reference(const struct sheet *sheet, int y)
{
    const struct compare *compare = sheet->compare;
    sheet_text(sheet->image, MARGIN, y, "%s: noise %.3g %%, made in %.3g s", compare->against.name,
               compare->noise * 100, compare->seconds);
    draw_curves(sheet, NULL, y + CANVAS_LINE);
    return draw_map(sheet, compare->reference, 1, y + CANVAS_LINE);
}

static bool draw_row(const struct sheet *sheet, const struct comparison *comparison, int y)
{
    const struct dpl_measure *measure = &comparison->measure;
    char gain[32] = "";
    if (!comparison->map) {
        sheet_text(sheet->image, MARGIN, y, "%s: not shown: %s", comparison->technique.name, comparison->failure);
        return true;
    }
    if (comparison->fitted)
        snprintf(gain, sizeof gain, ", after a gain of %.3g", measure->gain);
    sheet_text(sheet->image, MARGIN, y, "%s: error %.3g %%, p99 %.3g %%, energy %.4f%s, FLIP %.4f, %.3g ms",
               comparison->technique.name, measure->error * 100, measure->p99 * 100, measure->energy, gain,
               comparison->flip, comparison->milliseconds);
    y += CANVAS_LINE;
    draw_curves(sheet, comparison, y);
    return draw_map(sheet, comparison->map, measure->gain, y) && draw_difference(sheet, comparison, y);
}

static void draw_head(const struct sheet *sheet)
{
    const struct session *session = &sheet->compare->session;
    sheet_text(sheet->image, MARGIN, MARGIN, "dapple compare: scene %s at %g s, map %d x %d", session->scene_name,
               session->options->time, sheet->compare->reference->width, sheet->compare->reference->height);
    sheet_text(sheet->image, MARGIN, MARGIN + CANVAS_LINE,
               "maps: 0 is black, %.3g is white; all values in units of the reference's mean",
               sheet->compare->white / sheet->mean);
    sheet_text(sheet->image, MARGIN, MARGIN + 2 * CANVAS_LINE,
               "differences: technique - reference; curves along the marked line: reference grey, technique red");
}

static bool draw_sheet(struct sheet *sheet)
{
    const struct compare *compare = sheet->compare;
    canvas_fill(sheet->image, (struct box){0, 0, sheet->image->width, sheet->image->height}, sheet_paper);
    draw_head(sheet);
    int y = HEAD;
    bool ok = draw_reference(sheet, y);
    y += ROW;
    for (int i = 0; ok && i < compare->count; i++) {
        ok = draw_row(sheet, compare->comparisons + i, y);
        y += compare->comparisons[i].map ? ROW : ROW_FAILED;
    }
    return ok;
}

struct dpl_image *compare_sheet(const struct compare *compare)
{
    const struct dpl_image *reference = compare->reference;
    size_t texels = (size_t)reference->width * (size_t)reference->height, width = (size_t)reference->width;
    int height = HEAD + ROW;
    for (int i = 0; i < compare->count; i++)
        height += compare->comparisons[i].map ? ROW : ROW_FAILED;
    struct sheet sheet = {.compare = compare, .line = brightest_line(reference, compare->white)};
    for (size_t i = 0; i < texels; i++)
        sheet.mean += mean_of_channels(reference, i) / (double)texels;
    sheet.image = dpl_image_create(WIDTH, height, &compare->session.log->log);
    sheet.curve = calloc(width, sizeof *sheet.curve);
    sheet.tried = calloc(width, sizeof *sheet.tried);
    bool ok = sheet.image && sheet.curve && sheet.tried && draw_sheet(&sheet);
    free(sheet.curve);
    free(sheet.tried);
    if (ok)
        return sheet.image;
    dpl_image_destroy(sheet.image);
    return NULL;
}
