/* cli/session.h: what the commands that compute have in common: a scene, OpenGL or none, a renderer. */
#ifndef CLI_SESSION_H
#define CLI_SESSION_H

#include "cli/options.h"
#include "dapple/renderer.h"

struct session {
    const struct options *options;
    struct program_log *log;
    const char *scene_name;
    struct dpl_scene *scene;
    struct dpl_gl *gl; /* NULL: CPU only */
    struct dpl_renderer *renderer;
};

/* Reads the scene and changes what flags change. session_end() is due after it, on failure too. */
bool session_load(struct session *session, const struct options *options, struct program_log *log);
/* Opens the device. `needs_gl`: without OpenGL it fails. */
bool session_start(struct session *session, bool needs_gl);
void session_end(struct session *session);

/* The technique that the scene uses. */
struct dpl_entry session_technique(const struct session *session);

/* A value of the scene as a number, 0 where it is none. */
double session_value(const struct session *session, const char *key);

#endif
