/* cli/output.h: where a command's pictures go: one file, numbered files, or a video. */
#ifndef CLI_OUTPUT_H
#define CLI_OUTPUT_H

#include "cli/options.h"
#include "cli/video.h"

enum output_kind { OUTPUT_PICTURE, OUTPUT_NUMBERED, OUTPUT_VIDEO };

struct output {
    const struct options *options;
    struct program_log *log;
    enum output_kind kind;
    bool is_png;
    int frames;
    int number_start, number_end; /* NUMBERED: where "%04d" stands in options->output, bytes */
    int digits;                   /* NUMBERED: at least so many */
    const struct video_format *format;
    struct video video;
};

/* Checks everything that can be wrong with -o and the flags that go with it, before any work; writes nothing.
 * `command` is named in messages; `loop` is the scene's, in seconds, 0: none; only render makes videos. */
bool output_plan(struct output *output, const struct options *options, const char *command, double loop,
                 struct program_log *log);

bool output_begin(struct output *output);
bool output_write(struct output *output, const struct dpl_image *image, int frame);
/* Every output_begin() that succeeded ends with this. Returns false where not all is written. */
bool output_end(struct output *output, bool ok);

#endif
