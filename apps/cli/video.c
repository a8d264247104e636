#include "cli/video.h"

#include "cli/interrupt.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

#define BT709                                                                                                          \
    "-vf", "scale=out_color_matrix=bt709", "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709"

static const struct video_format formats[] = {
    {".mp4",
     "mp4",
     true,
     1000,
     {"-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart", BT709, NULL}},
    {".webm",
     "webm",
     true,
     1000,
     {"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-pix_fmt", "yuv420p", BT709, NULL}},
    /* One palette for the whole film, so that colours do not jump; GIF counts time in 1/100 s and players slow down
     * what is faster than 50 1/s. */
    {".gif", "gif", false, 50, {"-lavfi", "split[a][b];[a]palettegen[p];[b][p]paletteuse", NULL}},
};

const struct video_format *video_find_format(const char *path)
{
    const char *ending = strrchr(path, '.');
    for (size_t i = 0; ending && i < sizeof formats / sizeof *formats; i++)
        if (!strcasecmp(ending, formats[i].ending))
            return formats + i;
    return NULL;
}

bool video_find_ffmpeg(char path[PATH_MAX])
{
    const char *folder = getenv("PATH");
    while (folder && *folder) {
        int length = (int)strcspn(folder, ":");
        int used = snprintf(path, PATH_MAX, "%.*s/ffmpeg", length, folder);
        if (length && used < PATH_MAX && access(path, X_OK) == 0)
            return true;
        folder += length;
        folder += *folder == ':';
    }
    return false;
}

/* Starts ffmpeg with `input` as its standard input. A process group of its own keeps the terminal's Ctrl-C from it:
 * this program ends it. */
static bool start(struct video *video, char *const arguments[], int input)
{
    char program[PATH_MAX];
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    sigset_t usual;
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE);
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, STDERR_FILENO, STDOUT_FILENO);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    int error = video_find_ffmpeg(program)
                    ? posix_spawn(&video->ffmpeg, program, &files, &attributes, arguments, environ)
                    : ENOENT;
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
    return error == 0 || fail_work(video->log, "%s: ffmpeg cannot be started: %s", video->path, strerror(error));
}

/* A pipe whose ends no other program inherits. */
static bool open_pipe(int ends[2])
{
    if (pipe(ends) != 0)
        return false;
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    return true;
}

bool video_begin(struct video *video, const struct video_format *format, const char *path, int width, int height,
                 double fps, struct program_log *log)
{
    *video = (struct video){.log = log, .path = path};
    char size[32], rate[32], target[PATH_MAX + 8];
    snprintf(size, sizeof size, "%dx%d", width, height);
    snprintf(rate, sizeof rate, "%.9g", fps);
    if (snprintf(video->temporary, sizeof video->temporary, "%s.%ld.part", path, (long)getpid()) >= PATH_MAX)
        return fail_input(log, "%.80s…: name too long", path);
    snprintf(target, sizeof target, "file:%s", video->temporary);
    /* -xerror: a full disk is an error, not a shorter film */
    const char *arguments[40] = {"ffmpeg",     "-hide_banner", "-loglevel", "error", "-xerror",     "-y",
                                 "-f",         "rawvideo",     "-pix_fmt",  "rgb24", "-video_size", size,
                                 "-framerate", rate,           "-i",        "pipe:0"};
    int count = 0;
    while (arguments[count])
        count++;
    for (int i = 0; format->codec[i]; i++)
        arguments[count++] = format->codec[i];
    arguments[count++] = "-f";
    arguments[count++] = format->muxer;
    arguments[count++] = target;
    int ends[2];
    if (!open_pipe(ends))
        return fail_work(log, "%s: no pipe to ffmpeg: %s", path, strerror(errno));
    video->bytes = malloc((size_t)width * (size_t)height * 3);
    bool ok = video->bytes ? start(video, (char *const *)arguments, ends[0])
                           : fail_work(log, "%s: out of memory for a picture", path);
    close(ends[0]);
    video->pipe = ends[1];
    if (ok)
        return true;
    close(ends[1]);
    free(video->bytes);
    return false;
}

static bool write_all(int file, const unsigned char *bytes, size_t size)
{
    while (size) {
        ssize_t written = write(file, bytes, size);
        if (written < 0 && errno == EINTR && !interrupt_caught())
            continue;
        if (written < 0)
            return false;
        bytes += written;
        size -= (size_t)written;
    }
    return true;
}

bool video_write(struct video *video, const struct dpl_image *image)
{
    size_t count = (size_t)image->width * (size_t)image->height * 3;
    for (size_t i = 0; i < count; i++) {
        float value = image->pixels[i];
        value = value > 0 ? (value < 1 ? value : 1) : 0;
        video->bytes[i] = (unsigned char)(value * 255.0f + 0.5f);
    }
    video->broken = !write_all(video->pipe, video->bytes, count) && !interrupt_caught();
    return !video->broken && !interrupt_caught();
}

/* Waits for ffmpeg; ends it where it is not to finish. */
static int wait_for_end(const struct video *video, bool finish)
{
    int status = 0;
    if (!finish)
        kill(video->ffmpeg, SIGKILL);
    while (waitpid(video->ffmpeg, &status, 0) < 0 && errno == EINTR)
        if (interrupt_caught())
            kill(video->ffmpeg, SIGKILL);
    return status;
}

bool video_end(struct video *video, bool ok)
{
    close(video->pipe);
    free(video->bytes);
    int status = wait_for_end(video, ok || video->broken);
    bool complete = ok && WIFEXITED(status) && WEXITSTATUS(status) == 0;
    if (complete && rename(video->temporary, video->path) == 0)
        return true;
    if (complete)
        fail_work(video->log, "%s: cannot be written: %s", video->path, strerror(errno));
    else if (WIFEXITED(status))
        fail_work(video->log, "%s: ffmpeg failed with exit code %d; its own message is above", video->path,
                  WEXITSTATUS(status));
    else if ((ok || video->broken) && !interrupt_caught())
        fail_work(video->log, "%s: ffmpeg was ended by signal %d", video->path, WTERMSIG(status));
    unlink(video->temporary);
    return false;
}
