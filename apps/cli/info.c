#include "cli/commands.h"
#include "cli/json.h"
#include "cli/video.h"
#include "dapple/gl.h"

#include <stdio.h>
#include <unistd.h>

#ifdef HAVE_VIEWER
enum { has_viewer = true };
#else
enum { has_viewer = false };
#endif

struct report {
    char no_gl[512];         /* why there is no OpenGL */
    const struct dpl_gl *gl; /* NULL: none */
    const char *ffmpeg;      /* NULL: none */
    long threads;
};

/* No OpenGL is an answer here, not an error. */
static void keep_reason(void *user, enum dpl_log_level level, enum dpl_reason reason, const char *text)
{
    struct report *report = user;
    (void)level;
    (void)reason;
    snprintf(report->no_gl, sizeof report->no_gl, "%s", text);
}

static void report_gl_json(const struct report *report, struct json *json)
{
    if (!report->gl) {
        json_text(json, "opengl", NULL);
        json_text(json, "no_opengl", report->no_gl);
        return;
    }
    const struct dpl_gl_info *info = dpl_gl_describe(report->gl);
    json_open(json, "opengl", '{');
    json_text(json, "renderer", info->renderer);
    json_text(json, "vendor", info->vendor);
    json_text(json, "version", info->version);
    json_bool(json, "software", info->software);
    json_bool(json, "float_render", info->float_render);
    json_bool(json, "timer_queries", info->timer_queries);
    json_bool(json, "polygon_mode", info->polygon_mode);
    json_bool(json, "compute", info->compute);
    json_bool(json, "geometry", info->geometry);
    json_bool(json, "float_blend", info->float_blend);
    json_number(json, "texture_max", info->texture_max);
    json_number(json, "samples_max", info->samples_max);
    json_number(json, "point_max", info->point_max);
    json_number(json, "storage_max", info->storage_max);
    json_open(json, "fallbacks", '[');
    for (int i = 0; dpl_gl_fallback(report->gl, i); i++)
        json_text(json, NULL, dpl_gl_fallback(report->gl, i));
    json_close(json, ']');
    json_close(json, '}');
}

static void report_json(const struct report *report)
{
    struct json json = {.stream = stdout};
    json_open(&json, NULL, '{');
    json_text(&json, "version", DPL_VERSION);
    json_number(&json, "threads", (double)report->threads);
    json_text(&json, "ffmpeg", report->ffmpeg);
    json_bool(&json, "viewer", has_viewer);
    report_gl_json(report, &json);
    json_close(&json, '}');
    putchar('\n');
}

static const char *yes(bool value)
{
    return value ? "yes" : "no";
}

static void report_gl_text(const struct report *report)
{
    if (!report->gl) {
        printf("OpenGL         none (%s)\n\n"
               "what falls back to what:\n"
               "  no OpenGL: map and surface are computed on the CPU; render, bench and view do not work\n",
               report->no_gl);
        return;
    }
    const struct dpl_gl_info *info = dpl_gl_describe(report->gl);
    printf("device         %s (%s)\n", info->renderer, info->vendor);
    printf("OpenGL         %s%s\n", info->version, info->software ? ", on the CPU" : "");
    printf("texture side   at most %d\n", info->texture_max);
    printf("samples        at most %d a pixel\n", info->samples_max);
    printf("points         at most %d pixels wide\n", info->point_max);
    printf("float targets  %s\n", yes(info->float_render));
    printf("timer queries  %s\n", yes(info->timer_queries));
    printf("wireframe      %s\n", yes(info->polygon_mode));
    printf("compute        %s\n", yes(info->compute));
    printf("geometry       %s\n", yes(info->geometry));
    printf("float blending %s\n", yes(info->float_blend));
    puts("\nwhat falls back to what:");
    for (int i = 0; dpl_gl_fallback(report->gl, i); i++)
        printf("  %s\n", dpl_gl_fallback(report->gl, i));
    if (!dpl_gl_fallback(report->gl, 0))
        puts("  nothing: the device has all that is used");
}

static void report_text(const struct report *report)
{
    printf("dapple         %s\n", DPL_VERSION);
    printf("CPU threads    %ld\n", report->threads);
    printf("ffmpeg         %s\n", report->ffmpeg ? report->ffmpeg : "none: no videos (Debian: apt install ffmpeg)");
    printf("viewer         %s\n",
           has_viewer ? "yes" : "not in this build (Debian: apt install libglfw3-dev libimgui-dev)");
    report_gl_text(report);
}

bool command_info(const struct options *options, struct program_log *log)
{
    (void)log;
    char ffmpeg[PATH_MAX];
    struct report report = {.threads = sysconf(_SC_NPROCESSORS_ONLN)};
    struct dpl_log gl_log = {keep_reason, &report};
    struct dpl_gl *gl = dpl_gl_create_headless(false, NULL, &gl_log);
    report.gl = gl;
    report.ffmpeg = video_find_ffmpeg(ffmpeg) ? ffmpeg : NULL;
    if (options->json)
        report_json(&report);
    else
        report_text(&report);
    dpl_gl_destroy(gl);
    return true;
}
