#include "cli/sequence.h"

#include "cli/clock.h"
#include "cli/interrupt.h"
#include "cli/json.h"
#include "cli/progress.h"

#include <math.h>

double sequence_time(const struct options *options, int frame)
{
    return options->time + frame / options->fps;
}

struct result {
    int width, height;
    double seconds;
};

/* A frame that is being refined, or drawn in tiles. */
struct refining {
    struct progress *progress;
    int frame;
    double until; /* seconds of the clock */
};

static bool refine(void *user, double done)
{
    const struct refining *refining = user;
    progress_step(refining->progress, refining->frame + done);
    return !interrupt_caught() && clock_seconds() < refining->until;
}

static void count_tile(void *user, int done, int tiles)
{
    const struct refining *refining = user;
    progress_step(refining->progress, refining->frame + (double)done / tiles);
}

/* A technique that refines its map may have photons to save: an interrupt stops it first. */
static struct dpl_image *make_frame(const struct sequence *sequence, const struct session *session,
                                    struct progress *progress, int frame)
{
    const struct options *options = session->options;
    bool limited = options->given & FLAG_BIT(FLAG_SECONDS), refines = session_technique(session).refines;
    struct refining refining = {progress, frame, limited ? clock_seconds() + options->seconds : INFINITY};
    dpl_renderer_progress(session->renderer, refine, &refining);
    dpl_renderer_tiles(session->renderer, count_tile, &refining);
    if (refines)
        interrupt_hold();
    struct dpl_image *image = sequence->make(session, sequence_time(options, frame));
    if (refines)
        interrupt_release();
    return image;
}

static bool make_frames(const struct sequence *sequence, const struct session *session, struct output *output,
                        struct result *result)
{
    struct progress progress;
    progress_begin(&progress, sequence->command, output->frames, session->options->quiet, session->log);
    bool ok = true;
    for (int i = 0; ok && i < output->frames; i++) {
        struct dpl_image *image = make_frame(sequence, session, &progress, i);
        if (image && sequence->look)
            sequence->look(sequence->user, image);
        ok = image && output_write(output, image, i);
        if (image)
            *result = (struct result){image->width, image->height, 0};
        dpl_image_destroy(image);
        progress_step(&progress, i + 1);
    }
    progress_end(&progress);
    return ok;
}

static void report(const struct session *session, const struct output *output, const struct result *result,
                   const struct figure *figures)
{
    if (session->options->json) {
        struct json json = {.stream = stdout};
        json_open(&json, NULL, '{');
        json_text(&json, "output", session->options->output);
        json_number(&json, "frames", output->frames);
        json_number(&json, "width", result->width);
        json_number(&json, "height", result->height);
        json_number(&json, "seconds", result->seconds);
        for (const struct figure *figure = figures; figure && figure->name; figure++)
            json_number(&json, figure->name, figure->value);
        json_close(&json, '}');
        putchar('\n');
    } else if (!session->options->quiet) {
        printf("%s: %d x %d, %d %s in %.2f s", session->options->output, result->width, result->height, output->frames,
               output->frames == 1 ? "frame" : "frames", result->seconds);
        for (const struct figure *figure = figures; figure && figure->name; figure++)
            printf(", %s %.6g", figure->name, figure->value);
        putchar('\n');
    }
}

static bool run(const struct sequence *sequence, struct session *session, const struct figure *figures)
{
    double started = clock_seconds();
    struct output output;
    struct result result = {0};
    if (!output_plan(&output, session->options, sequence->command, session_value(session, "scene.loop"),
                     session->log) ||
        !session_start(session, sequence->needs_gl) ||
        (sequence->prepare && !sequence->prepare(session, &output, sequence->user)) || !output_begin(&output))
        return false;
    bool ok = make_frames(sequence, session, &output, &result);
    ok = output_end(&output, ok) && ok;
    result.seconds = clock_seconds() - started;
    if (ok)
        report(session, &output, &result, figures);
    return ok;
}

bool sequence_run(const struct sequence *sequence, const struct options *options, const struct figure *figures,
                  struct program_log *log)
{
    struct session session;
    bool ok = session_load(&session, options, log) && run(sequence, &session, figures);
    session_end(&session);
    return ok;
}
