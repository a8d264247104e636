#include "cli/commands.h"
#include "cli/sequence.h"

#include <string.h>
#include <strings.h>

/* .exr and .pfm hold radiance, where the look has it. */
static bool writes_floats(const char *path)
{
    const char *ending = strrchr(path, '.');
    return ending && (!strcasecmp(ending, ".exr") || !strcasecmp(ending, ".pfm"));
}

static struct dpl_image *make(const struct session *session, double time)
{
    const int *size = session->options->size;
    if (writes_floats(session->options->output))
        return dpl_renderer_radiance(session->renderer, session->scene, time, size[0], size[1]);
    return dpl_renderer_picture(session->renderer, session->scene, time, size[0], size[1]);
}

bool command_render(const struct options *options, struct program_log *log)
{
    struct sequence sequence = {.command = "render", .needs_gl = true, .make = make};
    return sequence_run(&sequence, options, NULL, log);
}
