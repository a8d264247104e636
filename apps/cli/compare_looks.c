/* `dapple compare --look`: the picture that the scene's own look makes, against that of another one. */
#include "cli/clock.h"
#include "cli/compare.h"
#include "cli/json.h"
#include "cli/output.h"
#include "cli/sheet.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define BOX 4             /* pixels: over less, noise and edges that are a pixel off would count */
#define RANGE_MOST 1.0    /* of the colours, in means: spikes of noise are more, and are not to decide */
#define PICTURE_LEAST 400 /* width of a picture on the sheet, pixels: room for a line of text */

struct picture {
    char look[64];
    struct dpl_image *shown, *radiance; /* as displayed; before that, means of boxes */
    double seconds;
};

struct looks {
    struct session session;
    struct picture tried, wanted;
    struct dpl_measure measure; /* of the radiance */
    double flip;                /* of what is shown */
    struct progress progress;
    double made; /* pictures */
    double ends; /* clock_seconds() when a picture has been refined enough */
};

static bool choose_looks(struct looks *looks)
{
    const struct session *session = &looks->session;
    const char *name = session->options->look;
    char accepted[256] = "";
    size_t used = 0;
    bool known = false;
    for (int i = 0; dpl_look(i).name && used < sizeof accepted; i++) {
        known = known || !strcmp(dpl_look(i).name, name);
        used += (size_t)snprintf(accepted + used, sizeof accepted - used, "%s%s", i ? ", " : "", dpl_look(i).name);
    }
    if (!known)
        return fail_input(session->log, "--look: no such look: \"%.80s\" (accepted: %s)", name, accepted);
    if (session->options->given & FLAG_BIT(FLAG_AGAINST))
        return fail_input(session->log, "--against: \"%.80s\" (accepted: none where --look compares pictures)",
                          session->options->against);
    snprintf(looks->wanted.look, sizeof looks->wanted.look, "%s", name);
    return dpl_scene_get(session->scene, "render.look", looks->tried.look, sizeof looks->tried.look);
}

static bool go_on(void *user, double done)
{
    struct looks *looks = user;
    progress_step(&looks->progress, looks->made + done);
    return clock_seconds() < looks->ends;
}

/* Of each box that lies in the image; what is left over at the right and below does not count. */
static struct dpl_image *means_of_boxes(const struct dpl_image *image, const struct dpl_log *log)
{
    int width = image->width / BOX, height = image->height / BOX;
    struct dpl_image *means = dpl_image_create(width, height, log);
    for (int y = 0; means && y < height * BOX; y++)
        for (int x = 0; x < width * BOX; x++)
            for (int c = 0; c < 3; c++)
                means->pixels[((size_t)(y / BOX) * (size_t)width + (size_t)(x / BOX)) * 3 + (size_t)c] +=
                    image->pixels[((size_t)y * (size_t)image->width + (size_t)x) * 3 + (size_t)c] / (BOX * BOX);
    return means;
}

static bool make_picture(struct looks *looks, struct picture *picture)
{
    const struct session *session = &looks->session;
    const struct options *options = session->options;
    double started = clock_seconds();
    looks->ends = options->given & FLAG_BIT(FLAG_SECONDS) ? started + options->seconds : INFINITY;
    if (!dpl_scene_set(session->scene, "render.look", picture->look))
        return false;
    struct dpl_image *radiance =
        dpl_renderer_radiance(session->renderer, session->scene, options->time, options->size[0], options->size[1]);
    picture->seconds = clock_seconds() - started;
    if (!radiance)
        return false;
    picture->radiance = means_of_boxes(radiance, &session->log->log);
    dpl_image_destroy(radiance);
    looks->ends = 0; /* what has been refined is only shown */
    picture->shown =
        dpl_renderer_picture(session->renderer, session->scene, options->time, options->size[0], options->size[1]);
    progress_step(&looks->progress, ++looks->made);
    return picture->radiance && picture->shown;
}

static bool draw_difference(const struct looks *looks, struct dpl_image *sheet, struct box box)
{
    const struct dpl_measure *measure = &looks->measure;
    const struct dpl_image *tried = looks->tried.radiance, *wanted = looks->wanted.radiance;
    size_t count = (size_t)wanted->width * (size_t)wanted->height * 3;
    double mean = 0, range = sheet_round_up(fmin(fmax(measure->p99, 1e-6), RANGE_MOST));
    for (size_t i = 0; i < count; i++)
        mean += wanted->pixels[i] / (double)count;
    struct dpl_image *colors =
        dpl_measure_colors(tried, wanted, 1, range * mean, DPL_COLORS_DIFFERENCE, &looks->session.log->log);
    if (!colors)
        return false;
    canvas_picture(sheet, box, colors);
    canvas_frame(sheet, box, sheet_ink);
    sheet_scale(sheet, box, range);
    dpl_image_destroy(colors);
    return true;
}

static void draw_picture(struct dpl_image *sheet, struct box box, const struct picture *picture)
{
    canvas_picture(sheet, box, picture->shown);
    canvas_frame(sheet, box, sheet_ink);
    sheet_text(sheet, box.x, box.y - CANVAS_LINE, "%s, made in %.3g s", picture->look, picture->seconds);
}

/* The first of three pictures side by side; small ones are enlarged. */
static struct box first_box(const struct options *options)
{
    int enlarged = (PICTURE_LEAST + options->size[0] - 1) / options->size[0];
    return (struct box){SHEET_MARGIN, SHEET_MARGIN + 2 * CANVAS_LINE, options->size[0] * enlarged,
                        options->size[1] * enlarged};
}

static int sheet_width(struct box box)
{
    return 4 * SHEET_MARGIN + 3 * box.width + SHEET_SCALE;
}

static int sheet_height(struct box box)
{
    return box.y + box.height + SHEET_MARGIN;
}

/* The look's picture, the one that it is held against, and how much brighter (red) it is than that. */
static struct dpl_image *draw_sheet(const struct looks *looks)
{
    const struct options *options = looks->session.options;
    const struct dpl_measure *measure = &looks->measure;
    struct box box = first_box(options);
    struct dpl_image *sheet = dpl_image_create(sheet_width(box), sheet_height(box), &looks->session.log->log);
    if (!sheet)
        return NULL;
    canvas_fill(sheet, (struct box){0, 0, sheet->width, sheet->height}, sheet_paper);
    sheet_text(sheet, box.x, SHEET_MARGIN,
               "dapple compare: scene %s at %g s: error %.3g %%, p99 %.3g %%, energy %.4f, "
               "FLIP %.4f",
               looks->session.scene_name, options->time, measure->error * 100, measure->p99 * 100, measure->energy,
               looks->flip);
    draw_picture(sheet, box, &looks->tried);
    box.x += box.width + SHEET_MARGIN;
    draw_picture(sheet, box, &looks->wanted);
    box.x += box.width + SHEET_MARGIN;
    sheet_text(sheet, box.x, box.y - CANVAS_LINE, "difference, in means");
    if (draw_difference(looks, sheet, box))
        return sheet;
    dpl_image_destroy(sheet);
    return NULL;
}

static bool write_sheet(const struct looks *looks, struct output *output)
{
    struct dpl_image *sheet = draw_sheet(looks);
    bool ok = sheet && output_write(output, sheet, 0);
    dpl_image_destroy(sheet);
    return ok;
}

static void print(const struct looks *looks)
{
    const struct session *session = &looks->session;
    const struct dpl_measure *measure = &looks->measure;
    printf("scene %s at %g s, %d x %d, device %s\n", session->scene_name, session->options->time,
           session->options->size[0], session->options->size[1], dpl_gl_describe(session->gl)->renderer);
    printf("against %s, made in %.2f s\n\n", looks->wanted.look, looks->wanted.seconds);
    printf("%-14s %8s %8s %8s %8s %9s\n", "look", "error %", "p99 %", "energy", "FLIP", "s");
    printf("%-14s %8.3f %8.2f %8.4f %8.4f %9.2f\n", looks->tried.look, measure->error * 100, measure->p99 * 100,
           measure->energy, looks->flip, looks->tried.seconds);
}

static void print_json(const struct looks *looks)
{
    const struct session *session = &looks->session;
    struct json json = {.stream = stdout};
    json_open(&json, NULL, '{');
    json_text(&json, "scene", session->scene_name);
    json_number(&json, "time", session->options->time);
    json_number(&json, "width", session->options->size[0]);
    json_number(&json, "height", session->options->size[1]);
    json_text(&json, "device", dpl_gl_describe(session->gl)->renderer);
    json_text(&json, "look", looks->tried.look);
    json_text(&json, "against", looks->wanted.look);
    json_number(&json, "error", looks->measure.error);
    json_number(&json, "p99", looks->measure.p99);
    json_number(&json, "energy", looks->measure.energy);
    json_number(&json, "flip", looks->flip);
    json_number(&json, "seconds", looks->tried.seconds);
    json_number(&json, "against_seconds", looks->wanted.seconds);
    json_text(&json, "output", session->options->output);
    json_close(&json, '}');
    putchar('\n');
}

static bool make_and_measure(struct looks *looks)
{
    const struct session *session = &looks->session;
    const struct dpl_log *log = &session->log->log;
    dpl_renderer_progress(session->renderer, go_on, looks);
    progress_begin(&looks->progress, "compare", 2, session->options->quiet, session->log);
    bool made = make_picture(looks, &looks->tried) && make_picture(looks, &looks->wanted);
    progress_end(&looks->progress);
    return made && dpl_measure_map(looks->tried.radiance, looks->wanted.radiance, false, 0, &looks->measure, log) &&
           dpl_measure_flip(looks->tried.shown, looks->wanted.shown, DPL_FLIP_PIXELS_PER_DEGREE, &looks->flip, log);
}

static bool run(struct looks *looks)
{
    const struct options *options = looks->session.options;
    struct program_log *log = looks->session.log;
    struct output output;
    if (options->size[0] < BOX || options->size[1] < BOX)
        return fail_input(log, "--size: too small to compare: \"%dx%d\" (accepted: from %dx%d)", options->size[0],
                          options->size[1], BOX, BOX);
    if (options->output &&
        (sheet_width(first_box(options)) > DPL_IMAGE_SIDE_MAX || sheet_height(first_box(options)) > DPL_IMAGE_SIDE_MAX))
        return fail_input(log,
                          "--size: too large for three pictures side by side: \"%dx%d\" (accepted: a sheet of at "
                          "most %d pixels a side)",
                          options->size[0], options->size[1], DPL_IMAGE_SIDE_MAX);
    if (!choose_looks(looks) || (options->output && !output_plan(&output, options, "compare", 0, log)) ||
        !session_start(&looks->session, true) || !make_and_measure(looks) ||
        (options->output && !write_sheet(looks, &output)))
        return false;
    (options->json ? print_json : print)(looks);
    return true;
}

static void destroy(struct picture *picture)
{
    dpl_image_destroy(picture->shown);
    dpl_image_destroy(picture->radiance);
}

bool compare_looks(const struct options *options, struct program_log *log)
{
    struct looks looks = {0};
    bool ok = session_load(&looks.session, options, log) && run(&looks);
    destroy(&looks.tried);
    destroy(&looks.wanted);
    session_end(&looks.session);
    return ok;
}
