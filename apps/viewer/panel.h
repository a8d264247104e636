/* panel.h: the window's controls: a C interface to Dear ImGui. */
#ifndef VIEWER_PANEL_H
#define VIEWER_PANEL_H

#include "dapple/renderer.h"
#include "viewer/clock.h"
#include "viewer/commands.h"
#include "viewer/compare.h"
#include "viewer/document.h"
#include "viewer/path.h"
#include "viewer/still.h"

struct GLFWwindow;
struct panel;

/* In the window's context, after other listeners to its events. Returns NULL where that fails. */
struct panel *panel_create(struct GLFWwindow *window);
void panel_destroy(struct panel *panel); /* NULL is allowed */

/* What the panels show. */
struct panel_view {
    struct document *document; /* values are changed through dpl_scene_set() only */
    struct viewer_clock *clock;
    struct viewer_compare *compare;
    struct viewer_path *path;
    struct viewer_still *still;
    struct dpl_renderer *renderer; /* of which a frame has been drawn */
    const char *device;
    int width, height;    /* of the picture, pixels */
    double frame_seconds; /* real time between frames */
    const char *message;  /* one line at the bottom, or NULL */
    bool message_is_error;
    bool hidden; /* only the message */
    bool blank;  /* there is no picture: cover what is in the window */
};

/* Draws the panels over the picture; returns which of their buttons were pressed. */
struct commands panel_draw(struct panel *panel, const struct panel_view *view);

/* True where the last panel_draw() left the mouse over a panel, or a control in use. */
bool panel_wants_mouse(void);
bool panel_wants_keyboard(void);

#endif
