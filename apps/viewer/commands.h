/* commands.h: what a user can ask for by a key or a button. */
#ifndef VIEWER_COMMANDS_H
#define VIEWER_COMMANDS_H

#include <stdbool.h>

struct commands {
    bool pause, step;      /* pause: or play */
    bool screenshot, save; /* save: the scene */
    bool reset, reload;    /* reload: the scene and the shaders, from their files */
    bool hide, quit;       /* hide: the panels, or show them */
    bool gravity, light;   /* gravity: of the sphere, on or off; light: from the eye */
    bool path;             /* play the camera's path, or stop it */
    bool add_key, clear_path;
    bool still;       /* write the still picture */
    const char *load; /* a built-in scene; NULL: none */
};

#endif
