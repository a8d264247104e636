#include "cli/session.h"

#include "cli/commands.h"

#include <stdlib.h>
#include <string.h>

bool session_load(struct session *session, const struct options *options, struct program_log *log)
{
    *session = (struct session){
        .options = options,
        .log = log,
        .scene_name = options->operand ? options->operand : DEFAULT_SCENE,
        .scene = dpl_scene_create(&log->log),
    };
    bool ok = session->scene && dpl_scene_load(session->scene, session->scene_name);
    for (int i = 0; ok && i < options->setting_count; i++)
        ok = dpl_scene_set(session->scene, options->settings[i].key, options->settings[i].value);
    return ok;
}

bool session_start(struct session *session, bool needs_gl)
{
    enum dpl_device device = (enum dpl_device)session->options->device;
    struct program_log *log = session->log;
    needs_gl = needs_gl || device == DPL_DEVICE_GL;
    if (needs_gl || device == DPL_DEVICE_AUTO) {
        log->instead = needs_gl ? NULL : "computing on the CPU";
        session->gl = dpl_gl_create_headless(false, session->options->shaders, &log->log);
        log->instead = NULL;
    }
    if (needs_gl && !session->gl)
        return false;
    session->renderer = dpl_renderer_create(session->gl, device, &log->log);
    return session->renderer != NULL;
}

void session_end(struct session *session)
{
    dpl_renderer_destroy(session->renderer);
    dpl_gl_destroy(session->gl);
    dpl_scene_destroy(session->scene);
}

struct dpl_entry session_technique(const struct session *session)
{
    char name[64];
    bool known = dpl_scene_get(session->scene, "caustics.technique", name, sizeof name);
    int i = 0;
    while (known && dpl_technique(i).name && strcmp(dpl_technique(i).name, name) != 0)
        i++;
    return dpl_technique(i);
}

double session_value(const struct session *session, const char *key)
{
    char text[64];
    return dpl_scene_get(session->scene, key, text, sizeof text) ? strtod(text, NULL) : 0;
}
