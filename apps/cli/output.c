#include "cli/output.h"

#include "cli/interrupt.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

/* Finds the "%d" or "%04d" in the last part of the path. */
static bool find_pattern(struct output *output, const char *path)
{
    const char *slash = strrchr(path, '/');
    const char *start = strchr(slash ? slash : path, '%');
    if (!start)
        return true;
    const char *end = start + 1;
    if (end[0] == '0' && end[1] >= '1' && end[1] <= '9') {
        output->digits = end[1] - '0';
        end += 2;
    }
    if (*end != 'd' || strchr(end, '%'))
        return fail_input(output->log,
                          "-o: not a name for numbered files: \"%s\" (accepted: one %%d or %%0Nd, N from 1 to 9, "
                          "as in water-%%04d.png)",
                          path);
    output->kind = OUTPUT_NUMBERED;
    output->number_start = (int)(start - path);
    output->number_end = (int)(end + 1 - path);
    return true;
}

/* Name of a frame's file. */
static bool frame_path(const struct output *output, int frame, char path[PATH_MAX])
{
    const char *pattern = output->options->output;
    if (output->kind == OUTPUT_NUMBERED)
        return snprintf(path, PATH_MAX, "%.*s%0*d%s", output->number_start, pattern, output->digits, frame,
                        pattern + output->number_end) < PATH_MAX;
    return snprintf(path, PATH_MAX, "%s", pattern) < PATH_MAX;
}

static bool check_ending(struct output *output, const char *path, bool videos)
{
    const char *ending = strrchr(path, '.');
    output->is_png = ending && !strcasecmp(ending, ".png");
    output->format = videos ? video_find_format(path) : NULL;
    return output->format || dpl_image_format_known(path, NULL) ||
           fail_input(output->log, "-o: no format has this ending: \"%s\" (accepted: .png, .exr, .pfm%s)", path,
                      videos ? ", .mp4, .webm, .gif" : "");
}

static bool check_video(struct output *output)
{
    const struct options *options = output->options;
    const struct video_format *format = output->format;
    char ffmpeg[PATH_MAX];
    if (output->kind == OUTPUT_NUMBERED)
        return fail_input(output->log, "-o: a video is one file: \"%s\" (accepted: a name without %%)",
                          options->output);
    output->kind = OUTPUT_VIDEO;
    if (format->even && (options->size[0] % 2 || options->size[1] % 2))
        return fail_input(output->log, "--size: odd: \"%dx%d\" (accepted for %s: an even width and height)",
                          options->size[0], options->size[1], format->ending);
    if (options->fps > format->fps_max)
        return fail_input(output->log, "--fps: too many: \"%g\" (accepted for %s: at most %g 1/s)", options->fps,
                          format->ending, format->fps_max);
    return video_find_ffmpeg(ffmpeg) ||
           fail_work(output->log, "%s: a video needs ffmpeg, and there is none in PATH (Debian: apt install ffmpeg)",
                     options->output);
}

static bool count_frames(struct output *output, double loop)
{
    const struct options *options = output->options;
    double frames = options->frames;
    if (frames == 0)
        frames = output->kind != OUTPUT_VIDEO ? 1 : loop > 0 ? fmax(1, round(loop * options->fps)) : 120;
    if (frames > FRAMES_MAX)
        return fail_input(output->log, "scene.loop: %.0f frames are too many (accepted: at most %d; give --frames)",
                          frames, FRAMES_MAX);
    if (frames > 1 && output->kind == OUTPUT_PICTURE)
        return fail_input(output->log,
                          "-o: one name for %.0f pictures: \"%s\" (accepted: a name with %%04d, as in water-%%04d.png)",
                          frames, options->output);
    output->frames = (int)frames;
    return true;
}

/* Whether a file can be made there: the only test that also holds for root is to make one. */
static bool check_place(struct output *output)
{
    char path[PATH_MAX], temporary[PATH_MAX];
    struct stat status;
    if (!frame_path(output, output->frames - 1, path) ||
        snprintf(temporary, sizeof temporary, "%s.%ld.part", path, (long)getpid()) >= (int)sizeof temporary)
        return fail_input(output->log, "-o: name too long: \"%.80s…\"", output->options->output);
    if (stat(path, &status) == 0 && S_ISDIR(status.st_mode))
        return fail_input(output->log, "-o: is a folder: \"%s\"", path);
    interrupt_hold();
    int file = open(temporary, O_WRONLY | O_CREAT | O_EXCL, 0666);
    int error = errno;
    if (file >= 0) {
        close(file);
        unlink(temporary);
    }
    interrupt_release();
    return file >= 0 || error == EEXIST ||
           fail_input(output->log, "-o: cannot be written: \"%s\": %s", path, strerror(error));
}

bool output_plan(struct output *output, const struct options *options, const char *command, double loop,
                 struct program_log *log)
{
    bool videos = !strcmp(command, "render");
    *output = (struct output){.options = options, .log = log};
    if (!options->output)
        return fail_input(log, "%s: nowhere to write to: -o is missing (as in: dapple %s -o %s)", command, command,
                          videos ? "water.png" : "water.exr");
    if (!check_ending(output, options->output, videos) || !find_pattern(output, options->output) ||
        (output->format && !check_video(output)))
        return false;
    if (options->given & FLAG_BIT(FLAG_BITS) && !output->is_png)
        return fail_input(log, "--bits: only a .png has them: \"%s\"", options->output);
    if (options->given & FLAG_BIT(FLAG_WHITE) && !output->is_png)
        return fail_input(log, "--white: only a .png has it: \"%s\"", options->output);
    return count_frames(output, loop) && check_place(output);
}

bool output_begin(struct output *output)
{
    const struct options *options = output->options;
    if (output->kind != OUTPUT_VIDEO)
        return true;
    interrupt_hold();
    if (video_begin(&output->video, output->format, options->output, options->size[0], options->size[1], options->fps,
                    output->log))
        return true;
    interrupt_release();
    return false;
}

bool output_write(struct output *output, const struct dpl_image *image, int frame)
{
    char path[PATH_MAX];
    if (output->kind == OUTPUT_VIDEO)
        return video_write(&output->video, image);
    struct dpl_image_format format = {.bits = output->options->bits ? 16 : 8, .white = (float)output->options->white};
    frame_path(output, frame, path);
    interrupt_hold();
    bool ok = dpl_image_save(image, path, &format, &output->log->log);
    interrupt_release();
    return ok;
}

bool output_end(struct output *output, bool ok)
{
    if (output->kind != OUTPUT_VIDEO)
        return ok;
    ok = video_end(&output->video, ok);
    interrupt_release();
    return ok;
}
