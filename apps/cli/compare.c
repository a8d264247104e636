/* `dapple compare`: techniques against a reference; of looks: compare_looks.c. */
#include "cli/compare.h"

#include "cli/clock.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/output.h"
#include "cli/progress.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define RUNS 5           /* of a technique that are timed; one before them is not */
#define SECONDS_ENOUGH 3 /* after them no further run is started */

/* The technique of that name; NULL-named: there is none. */
static struct dpl_entry find_technique(const char *name)
{
    int i = 0;
    while (dpl_technique(i).name && strcmp(dpl_technique(i).name, name))
        i++;
    return dpl_technique(i);
}

static bool choose_reference(struct compare *compare)
{
    const char *name = compare->session.options->against;
    char accepted[256] = "";
    size_t used = 0;
    compare->against = find_technique(name);
    for (int i = 0; dpl_technique(i).name && used < sizeof accepted; i++)
        used += (size_t)snprintf(accepted + used, sizeof accepted - used, "%s%s", i ? ", " : "", dpl_technique(i).name);
    return compare->against.name ||
           fail_input(compare->session.log, "--against: no such technique: \"%.80s\" (accepted: %s)", name, accepted);
}

/* Those that --technique names, each checked already; else all but the reference. */
static bool choose_techniques(struct compare *compare)
{
    const struct options *options = compare->session.options;
    int known = 0;
    while (dpl_technique(known).name)
        known++;
    compare->comparisons = calloc((size_t)(known + options->setting_count), sizeof *compare->comparisons);
    if (!compare->comparisons)
        return fail_work(compare->session.log, "compare: out of memory");
    for (int i = 0; i < options->setting_count; i++)
        if (!strcmp(options->settings[i].key, "caustics.technique"))
            compare->comparisons[compare->count++].technique = find_technique(options->settings[i].value);
    for (int i = 0; i < known && !(options->given & FLAG_BIT(FLAG_TECHNIQUE)); i++)
        if (strcmp(dpl_technique(i).name, compare->against.name))
            compare->comparisons[compare->count++].technique = dpl_technique(i);
    return true;
}

static bool use_technique(const struct compare *compare, const char *name)
{
    return dpl_scene_set(compare->session.scene, "caustics.technique", name);
}

static bool go_on(void *user, double done)
{
    struct compare *compare = user;
    progress_step(&compare->progress, compare->made + done);
    return !interrupt_caught() && clock_seconds() < compare->ends;
}

/* An interrupt ends the refining of a map first, so that what it may keep in a file is kept. */
static struct dpl_image *make_map(struct compare *compare)
{
    const struct session *session = &compare->session;
    bool limited = session->options->given & FLAG_BIT(FLAG_SECONDS);
    compare->ends = limited ? clock_seconds() + session->options->seconds : INFINITY;
    dpl_renderer_progress(session->renderer, go_on, compare);
    interrupt_hold();
    struct dpl_image *map = dpl_renderer_map(session->renderer, session->scene, session->options->time);
    interrupt_release();
    return map;
}

static int compare_floats(const void *a, const void *b)
{
    float difference = *(const float *)a - *(const float *)b;
    return (difference > 0) - (difference < 0);
}

static bool find_white(struct compare *compare)
{
    const struct dpl_image *map = compare->reference;
    size_t count = (size_t)map->width * (size_t)map->height * 3;
    float *sorted = malloc(count * sizeof *sorted);
    if (!sorted)
        return fail_work(compare->session.log, "compare: out of memory");
    memcpy(sorted, map->pixels, count * sizeof *sorted);
    qsort(sorted, count, sizeof *sorted, compare_floats);
    compare->white = fmax(sorted[count - 1 - count / 100], 1e-6);
    free(sorted);
    return true;
}

void compare_expose(const struct compare *compare, double gain, struct dpl_image *map)
{
    size_t count = (size_t)map->width * (size_t)map->height * 3;
    for (size_t i = 0; i < count; i++)
        map->pixels[i] = (float)pow(fmin(fmax(map->pixels[i] * gain / compare->white, 0), 1), 1 / 2.2);
}

/* A map as it is shown; the caller destroys it. */
static struct dpl_image *make_picture(const struct compare *compare, const struct dpl_image *map, double gain)
{
    struct dpl_image *picture = dpl_image_create(map->width, map->height, &compare->session.log->log);
    if (picture) {
        memcpy(picture->pixels, map->pixels, (size_t)map->width * (size_t)map->height * 3 * sizeof *map->pixels);
        compare_expose(compare, gain, picture);
    }
    return picture;
}

/* Whatever the scene says, the reference is not blurred. */
static bool make_reference(struct compare *compare)
{
    struct dpl_scene *scene = compare->session.scene;
    char blur[32];
    if (!dpl_scene_get(scene, "caustics.blur", blur, sizeof blur) || !dpl_scene_set(scene, "caustics.blur", "0") ||
        !use_technique(compare, compare->against.name))
        return false;
    double started = clock_seconds();
    compare->reference = make_map(compare);
    compare->seconds = clock_seconds() - started;
    compare->noise = dpl_renderer_noise(compare->session.renderer);
    progress_step(&compare->progress, ++compare->made);
    return compare->reference && find_white(compare) && dpl_scene_set(scene, "caustics.blur", blur);
}

static int compare_numbers(const void *a, const void *b)
{
    double difference = *(const double *)a - *(const double *)b;
    return (difference > 0) - (difference < 0);
}

/* Sum of the passes that made the last map. */
static double map_milliseconds(const struct dpl_renderer *renderer)
{
    double sum = 0;
    for (int i = 0; dpl_renderer_pass_time(renderer, i).name; i++)
        sum += dpl_renderer_pass_time(renderer, i).milliseconds;
    return sum;
}

/* Makes the map, several times over to time it; what refines its map does so once. */
static bool make_and_time_map(struct compare *compare, struct comparison *comparison)
{
    double samples[RUNS + 1], started = clock_seconds();
    int runs = 0, left_out = comparison->technique.refines ? 0 : 1;
    do {
        dpl_image_destroy(comparison->map);
        comparison->map = make_map(compare);
        samples[runs++] = map_milliseconds(compare->session.renderer);
    } while (comparison->map && runs < left_out * (RUNS + 1) &&
             (runs < 2 || clock_seconds() - started < SECONDS_ENOUGH));
    if (!comparison->map)
        return false;
    runs -= left_out;
    qsort(samples + left_out, (size_t)runs, sizeof *samples, compare_numbers);
    comparison->milliseconds = (samples[left_out + (runs - 1) / 2] + samples[left_out + runs / 2]) / 2;
    return true;
}

static bool measure_technique(struct compare *compare, struct comparison *comparison)
{
    const struct dpl_log *log = &compare->session.log->log;
    comparison->fitted = !comparison->technique.physical || !compare->against.physical;
    if (!use_technique(compare, comparison->technique.name) || !make_and_time_map(compare, comparison) ||
        !dpl_measure_map(comparison->map, compare->reference, comparison->fitted, compare->noise, &comparison->measure,
                         log))
        return false;
    struct dpl_image *picture = make_picture(compare, comparison->map, comparison->measure.gain);
    struct dpl_image *wanted = make_picture(compare, compare->reference, 1);
    bool ok =
        picture && wanted && dpl_measure_flip(picture, wanted, DPL_FLIP_PIXELS_PER_DEGREE, &comparison->flip, log);
    dpl_image_destroy(picture);
    dpl_image_destroy(wanted);
    return ok;
}

/* A technique that fails is left out, with the reason. */
static void measure_techniques(struct compare *compare)
{
    struct program_log *log = compare->session.log;
    for (int i = 0; i < compare->count; i++) {
        struct comparison *comparison = compare->comparisons + i;
        log->caught = comparison->failure;
        if (!measure_technique(compare, comparison)) {
            dpl_image_destroy(comparison->map);
            comparison->map = NULL;
        }
        log->caught = NULL;
        progress_step(&compare->progress, ++compare->made);
    }
}

static bool write_sheet(const struct compare *compare, struct output *output)
{
    struct dpl_image *sheet = compare_sheet(compare);
    bool ok = sheet && output_write(output, sheet, 0);
    dpl_image_destroy(sheet);
    return ok;
}

/* The noise is taken out of errors, as far as it is known: see dpl_measure_map(). */
static void warn_of_noise(const struct compare *compare)
{
    const struct dpl_log *log = &compare->session.log->log;
    double least = INFINITY;
    char text[256];
    for (int i = 0; i < compare->count; i++)
        if (compare->comparisons[i].map && strcmp(compare->comparisons[i].technique.name, compare->against.name))
            least = fmin(least, compare->comparisons[i].measure.error);
    if (!(compare->noise > 5 * least))
        return;
    snprintf(text, sizeof text,
             "%s: its noise of %.3g %% is more than five times the least error, %.3g %%, which is therefore known "
             "roughly (more --seconds, or more reference.photons)",
             compare->against.name, compare->noise * 100, least * 100);
    log->write(log->user, DPL_LOG_WARNING, DPL_REASON_NONE, text);
}

static bool run(struct compare *compare)
{
    const struct options *options = compare->session.options;
    struct program_log *log = compare->session.log;
    struct output output;
    if (!choose_reference(compare) || !choose_techniques(compare) ||
        (options->output && !output_plan(&output, options, "compare", 0, log)) ||
        !session_start(&compare->session, false))
        return false;
    dpl_renderer_time_passes(compare->session.renderer, DPL_TIMING_WAIT, clock_seconds);
    progress_begin(&compare->progress, "compare", 1 + compare->count, options->quiet, log);
    bool ok = make_reference(compare);
    if (ok)
        measure_techniques(compare);
    progress_end(&compare->progress);
    if (!ok || (options->output && !write_sheet(compare, &output)))
        return false;
    warn_of_noise(compare);
    (options->json ? compare_print_json : compare_print)(compare);
    return true;
}

bool command_compare(const struct options *options, struct program_log *log)
{
    if (options->look)
        return compare_looks(options, log);
    struct compare compare = {0};
    bool ok = session_load(&compare.session, options, log) && run(&compare);
    for (int i = 0; i < compare.count; i++)
        dpl_image_destroy(compare.comparisons[i].map);
    free(compare.comparisons);
    dpl_image_destroy(compare.reference);
    session_end(&compare.session);
    return ok;
}
