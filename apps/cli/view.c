#include "cli/commands.h"

#ifdef HAVE_VIEWER

#include "cli/session.h"
#include "viewer/viewer.h"

bool command_view(const struct options *options, struct program_log *log)
{
    struct session session;
    bool ok = session_load(&session, options, log);
    if (ok) {
        struct viewer_options viewer = {
            .scene = session.scene,
            .scene_path = session.scene_name,
            .shader_folder = options->shaders,
            .device = (enum dpl_device)options->device,
            .width = options->size[0],
            .height = options->size[1],
            .time = options->time,
            .log = &log->log,
        };
        ok = viewer_run(&viewer) == 0;
    }
    session_end(&session);
    return ok;
}

#else

bool command_view(const struct options *options, struct program_log *log)
{
    (void)options;
    return fail_work(log, "view: this build has no viewer (Debian: apt install libglfw3-dev libimgui-dev, then build "
                          "again; `dapple render` needs neither)");
}

#endif
