#include "cli/commands.h"
#include "cli/sequence.h"

#include <math.h>

struct ranges {
    struct figure figures[4]; /* the largest |v| of each channel over all frames */
    bool is_png;
};

static struct dpl_image *make(const struct session *session, double time)
{
    return dpl_renderer_surface(session->renderer, session->scene, time);
}

static void widen(struct ranges *ranges, const struct dpl_image *image)
{
    size_t count = (size_t)image->width * (size_t)image->height * 3;
    for (size_t i = 0; i < count; i++) {
        double *range = &ranges->figures[i % 3].value;
        *range = fmax(*range, fabs((double)image->pixels[i]));
    }
}

/* All frames of a .png sequence share their ranges, so that it does not pulse: they are found first. */
static bool prepare(const struct session *session, const struct output *output, void *user)
{
    struct ranges *ranges = user;
    ranges->is_png = output->is_png;
    for (int i = 0; output->is_png && i < output->frames; i++) {
        struct dpl_image *image = make(session, sequence_time(session->options, i));
        if (!image)
            return false;
        widen(ranges, image);
        dpl_image_destroy(image);
    }
    return true;
}

/* Brings -r … r to 0 … 1 for a .png; other formats hold the values as they are. */
static void look(void *user, struct dpl_image *image)
{
    struct ranges *ranges = user;
    size_t count = (size_t)image->width * (size_t)image->height * 3;
    if (!ranges->is_png)
        widen(ranges, image);
    for (size_t i = 0; ranges->is_png && i < count; i++) {
        double range = ranges->figures[i % 3].value;
        image->pixels[i] = range > 0 ? (float)(0.5 + 0.5 * (double)image->pixels[i] / range) : 0.5f;
    }
}

bool command_surface(const struct options *options, struct program_log *log)
{
    struct ranges ranges = {.figures = {{"height_range", 0}, {"slope_x_range", 0}, {"slope_z_range", 0}}};
    struct sequence sequence = {.command = "surface", .make = make, .prepare = prepare, .look = look, .user = &ranges};
    return sequence_run(&sequence, options, ranges.figures, log);
}
