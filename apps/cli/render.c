#include "cli/commands.h"
#include "cli/sequence.h"

static struct dpl_image *make(const struct session *session, double time)
{
    const int *size = session->options->size;
    return dpl_renderer_picture(session->renderer, session->scene, time, size[0], size[1]);
}

bool command_render(const struct options *options, struct program_log *log)
{
    struct sequence sequence = {.command = "render", .needs_gl = true, .make = make};
    return sequence_run(&sequence, options, NULL, log);
}
