#include "cli/clock.h"
#include "cli/commands.h"
#include "cli/json.h"
#include "cli/progress.h"
#include "cli/session.h"

#include <stdlib.h>

#define WARM_UP 3     /* frames that are not counted: the first compile shaders and allocate */
#define PASSES_MAX 32 /* more are not shown */
#define TEXT_SIZE 64  /* bytes of a technique's name or a number */

struct bench {
    struct session session;
    int frames;      /* of each of the two measurements */
    double *samples; /* milliseconds of one measurement: pass after pass, `frames` each */
    double frame_median, frame_least, frame_most;
    int pass_count;
    struct dpl_pass_time passes[PASSES_MAX]; /* medians */
};

static int compare_numbers(const void *a, const void *b)
{
    double difference = *(const double *)a - *(const double *)b;
    return (difference > 0) - (difference < 0);
}

static void sort(double *samples, int count)
{
    qsort(samples, (size_t)count, sizeof *samples, compare_numbers);
}

/* Of sorted samples. */
static double median(const double *samples, int count)
{
    return (samples[(count - 1) / 2] + samples[count / 2]) / 2;
}

/* Frames are 1/60 s apart. */
static bool draw(const struct bench *bench, int frame)
{
    const struct session *session = &bench->session;
    const int *size = session->options->size;
    return dpl_renderer_draw(session->renderer, session->scene, frame / 60.0, DPL_NO_FRAMEBUFFER, size[0], size[1]);
}

static bool time_frames(struct bench *bench, struct progress *progress)
{
    for (int i = -WARM_UP; i < bench->frames; i++) {
        double started = clock_seconds();
        if (!draw(bench, i + WARM_UP))
            return false;
        if (i >= 0)
            bench->samples[i] = (clock_seconds() - started) * 1e3;
        progress_step(progress, i < 0 ? 0 : i + 1);
    }
    sort(bench->samples, bench->frames);
    bench->frame_median = median(bench->samples, bench->frames);
    bench->frame_least = bench->samples[0];
    bench->frame_most = bench->samples[bench->frames - 1];
    return true;
}

static bool time_passes(struct bench *bench, struct progress *progress)
{
    const struct dpl_renderer *renderer = bench->session.renderer;
    dpl_renderer_time_passes(bench->session.renderer, DPL_TIMING_WAIT, clock_seconds);
    for (int i = 0; i < bench->frames; i++) {
        if (!draw(bench, WARM_UP + bench->frames + i))
            return false;
        for (int p = 0; p < PASSES_MAX; p++) {
            struct dpl_pass_time time = dpl_renderer_pass_time(renderer, p);
            if (!time.name)
                break;
            bench->passes[p].name = time.name;
            bench->samples[p * bench->frames + i] = time.milliseconds;
            bench->pass_count = p + 1;
        }
        progress_step(progress, bench->frames + i + 1);
    }
    for (int p = 0; p < bench->pass_count; p++) {
        double *samples = bench->samples + (size_t)p * (size_t)bench->frames;
        sort(samples, bench->frames);
        bench->passes[p].milliseconds = median(samples, bench->frames);
    }
    return true;
}

static void report_json(const struct bench *bench, const char *technique)
{
    const struct session *session = &bench->session;
    struct json json = {.stream = stdout};
    json_open(&json, NULL, '{');
    json_text(&json, "scene", session->scene_name);
    json_text(&json, "technique", technique);
    json_text(&json, "device", dpl_gl_describe(session->gl)->renderer);
    json_open(&json, "size", '[');
    json_number(&json, NULL, session->options->size[0]);
    json_number(&json, NULL, session->options->size[1]);
    json_close(&json, ']');
    json_number(&json, "map", session_value(session, "caustics.map"));
    json_number(&json, "frames", bench->frames);
    json_open(&json, "frame_ms", '{');
    json_number(&json, "median", bench->frame_median);
    json_number(&json, "min", bench->frame_least);
    json_number(&json, "max", bench->frame_most);
    json_close(&json, '}');
    json_open(&json, "passes", '[');
    for (int p = 0; p < bench->pass_count; p++) {
        json_open(&json, NULL, '{');
        json_text(&json, "name", bench->passes[p].name);
        json_number(&json, "ms", bench->passes[p].milliseconds);
        json_close(&json, '}');
    }
    json_close(&json, ']');
    json_close(&json, '}');
    putchar('\n');
}

static void report_text(const struct bench *bench, const char *technique)
{
    const struct session *session = &bench->session;
    const int *size = session->options->size;
    printf("scene %s, technique %s, map %.0f, picture %d x %d\n", session->scene_name, technique,
           session_value(session, "caustics.map"), size[0], size[1]);
    printf("device %s\n\n", dpl_gl_describe(session->gl)->renderer);
    printf("%-12s %9s\n", "", "ms");
    printf("%-12s %9.3f   %.1f frames a second; %.3f to %.3f ms; median of %d\n", "whole frame", bench->frame_median,
           1e3 / bench->frame_median, bench->frame_least, bench->frame_most, bench->frames);
    for (int p = 0; p < bench->pass_count; p++)
        printf("%-12s %9.3f\n", bench->passes[p].name, bench->passes[p].milliseconds);
}

static bool measure(struct bench *bench)
{
    const struct options *options = bench->session.options;
    char technique[TEXT_SIZE];
    struct progress progress;
    if (!session_start(&bench->session, true) ||
        !dpl_scene_get(bench->session.scene, "caustics.technique", technique, sizeof technique))
        return false;
    progress_begin(&progress, "bench", 2 * bench->frames, options->quiet, bench->session.log);
    bool ok = time_frames(bench, &progress) && time_passes(bench, &progress);
    progress_end(&progress);
    if (ok && options->json)
        report_json(bench, technique);
    else if (ok)
        report_text(bench, technique);
    return ok;
}

bool command_bench(const struct options *options, struct program_log *log)
{
    struct bench bench = {.frames = options->frames ? options->frames : 21};
    bool ok = session_load(&bench.session, options, log);
    bench.samples = calloc((size_t)bench.frames * PASSES_MAX, sizeof *bench.samples);
    if (!bench.samples)
        ok = fail_work(log, "bench: out of memory for %d frames", bench.frames);
    ok = ok && measure(&bench);
    free(bench.samples);
    session_end(&bench.session);
    return ok;
}
