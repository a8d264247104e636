#include "cli/commands.h"
#include "cli/sequence.h"

#include <math.h>

enum { MEAN, LEAST, MOST, NOISE, FIGURES };

struct statistics {
    const struct dpl_renderer *renderer;
    struct figure figures[FIGURES + 1];
    double sum, count;
};

static struct dpl_image *make(const struct session *session, double time)
{
    return dpl_renderer_slice(session->renderer, session->scene, time, session->options->slice);
}

static bool prepare(const struct session *session, const struct output *output, void *user)
{
    struct statistics *statistics = user;
    (void)output;
    statistics->renderer = session->renderer;
    statistics->figures[NOISE].name = session_technique(session).refines ? "noise" : NULL;
    return true;
}

/* Over all texels, channels and frames. */
static void look(void *user, struct dpl_image *image)
{
    struct statistics *statistics = user;
    struct figure *figures = statistics->figures;
    size_t count = (size_t)image->width * (size_t)image->height * 3;
    for (size_t i = 0; i < count; i++) {
        double value = image->pixels[i];
        statistics->sum += value;
        figures[LEAST].value = fmin(figures[LEAST].value, value);
        figures[MOST].value = fmax(figures[MOST].value, value);
    }
    statistics->count += (double)count;
    figures[NOISE].value = fmax(figures[NOISE].value, dpl_renderer_noise(statistics->renderer));
    figures[MEAN].value = statistics->sum / statistics->count;
}

bool command_map(const struct options *options, struct program_log *log)
{
    struct statistics statistics = {
        .figures = {[MEAN] = {"mean", 0}, [LEAST] = {"min", INFINITY}, [MOST] = {"max", -INFINITY}},
    };
    struct sequence sequence = {.command = "map", .make = make, .prepare = prepare, .look = look, .user = &statistics};
    return sequence_run(&sequence, options, statistics.figures, log);
}
