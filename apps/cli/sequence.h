/* cli/sequence.h: one picture after the other into an output, and what is said of it in the end. */
#ifndef CLI_SEQUENCE_H
#define CLI_SEQUENCE_H

#include "cli/output.h"
#include "cli/session.h"

struct sequence {
    const char *command;
    bool needs_gl;
    /* Makes the picture at `time` seconds; NULL after the reason was logged. */
    struct dpl_image *(*make)(const struct session *session, double time);
    /* Called once before the first picture is made; NULL: nothing to do. */
    bool (*prepare)(const struct session *session, const struct output *output, void *user);
    /* Sees each picture, and may change it, before it is written; NULL: nothing to do. */
    void (*look)(void *user, struct dpl_image *image);
    void *user;
};

/* A number that is part of the result. */
struct figure {
    const char *name; /* NULL ends a list */
    double value;
};

/* Time of the i-th frame, seconds. */
double sequence_time(const struct options *options, int frame);

/* The whole of a command: scene, checks, device, pictures, result. `figures` are read when the pictures are done; NULL:
 * none. */
bool sequence_run(const struct sequence *sequence, const struct options *options, const struct figure *figures,
                  struct program_log *log);

#endif
