#include "cli/compare.h"
#include "cli/json.h"

const char *compare_device(const struct compare *compare)
{
    const struct dpl_gl *gl = compare->session.gl;
    return gl ? dpl_gl_describe(gl)->renderer : "CPU";
}

/* Below a tenth of the reference's noise an error is not known. */
#define KNOWN 0.1

static void print_comparison(const struct comparison *comparison, double noise)
{
    char error[32];
    const struct dpl_measure *measure = &comparison->measure;
    if (!comparison->map) {
        printf("%-14s not shown: %s\n", comparison->technique.name, comparison->failure);
        return;
    }
    bool known = measure->error >= KNOWN * noise;
    snprintf(error, sizeof error, known ? "%.3f" : "<%.3f", (known ? measure->error : KNOWN * noise) * 100);
    printf("%-14s %8s %8.2f %8.4f ", comparison->technique.name, error, measure->p99 * 100, measure->energy);
    if (!comparison->fitted)
        printf("%8s ", "-");
    else
        printf("%8.3f ", measure->gain);
    printf("%8.4f %9.3f\n", comparison->flip, comparison->milliseconds);
}

void compare_print(const struct compare *compare)
{
    const struct session *session = &compare->session;
    bool fitted = false;
    printf("scene %s at %g s, map %.0f, device %s\n", session->scene_name, session->options->time,
           session_value(session, "caustics.map"), compare_device(compare));
    printf("against %s, noise %.3g %%, made in %.2f s\n\n", compare->against.name, compare->noise * 100,
           compare->seconds);
    printf("%-14s %8s %8s %8s %8s %8s %9s\n", "technique", "error %", "p99 %", "energy", "gain", "FLIP", "ms");
    for (int i = 0; i < compare->count; i++) {
        const struct comparison *comparison = compare->comparisons + i;
        print_comparison(comparison, compare->noise);
        fitted = fitted || (comparison->map && comparison->fitted);
    }
    if (fitted)
        puts("\ngain: this technique, or the one that stands for the truth, has no physical scale; its map is "
             "multiplied by "
             "the gain of least error first");
}

static void print_comparison_json(const struct comparison *comparison, struct json *json)
{
    const struct dpl_measure *measure = &comparison->measure;
    json_open(json, NULL, '{');
    json_text(json, "technique", comparison->technique.name);
    json_bool(json, "physical", comparison->technique.physical);
    json_text(json, "failure", comparison->map ? NULL : comparison->failure);
    if (comparison->map) {
        json_number(json, "error", measure->error);
        json_number(json, "p99", measure->p99);
        json_number(json, "energy", measure->energy);
        json_number(json, "gain", measure->gain);
        json_number(json, "flip", comparison->flip);
        json_number(json, "ms", comparison->milliseconds);
    }
    json_close(json, '}');
}

void compare_print_json(const struct compare *compare)
{
    const struct session *session = &compare->session;
    struct json json = {.stream = stdout};
    json_open(&json, NULL, '{');
    json_text(&json, "scene", session->scene_name);
    json_number(&json, "time", session->options->time);
    json_number(&json, "map", session_value(session, "caustics.map"));
    json_text(&json, "device", compare_device(compare));
    json_text(&json, "against", compare->against.name);
    json_number(&json, "noise", compare->noise);
    json_number(&json, "seconds", compare->seconds);
    json_open(&json, "techniques", '[');
    for (int i = 0; i < compare->count; i++)
        print_comparison_json(compare->comparisons + i, &json);
    json_close(&json, ']');
    json_text(&json, "output", session->options->output);
    json_close(&json, '}');
    putchar('\n');
}
