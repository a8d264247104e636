/* cli/video.h: pictures through a pipe into ffmpeg, which makes a video of them.
 *
 * The video is written beside its place under another name, then renamed. */
#ifndef CLI_VIDEO_H
#define CLI_VIDEO_H

#include "cli/log.h"
#include "dapple/image.h"

#include <limits.h>
#include <sys/types.h>

struct video_format {
    const char *ending;    /* ".mp4" */
    const char *muxer;     /* ffmpeg's name for it */
    bool even;             /* both sides must be even, as colour is stored at half size (yuv420p) */
    double fps_max;        /* 1/s */
    const char *codec[20]; /* arguments of ffmpeg, ends with NULL */
};

/* By the ending of the path; NULL: it is none of a video. */
const struct video_format *video_find_format(const char *path);

/* Where ffmpeg is, by the environment's PATH. False: nowhere. */
bool video_find_ffmpeg(char path[PATH_MAX]);

struct video {
    struct program_log *log;
    const char *path;
    char temporary[PATH_MAX];
    pid_t ffmpeg;
    int pipe;
    unsigned char *bytes; /* one picture */
    bool broken;          /* ffmpeg does not read any more */
};
bool video_begin(struct video *video, const struct video_format *format, const char *path, int width, int height,
                 double fps, struct program_log *log);
/* The image has the size that video_begin() was given. False: stop and call video_end(), which reports why. */
bool video_write(struct video *video, const struct dpl_image *image);
/* Waits for ffmpeg and renames the video if `ok` and nothing failed; otherwise nothing stays. */
bool video_end(struct video *video, bool ok);

#endif
