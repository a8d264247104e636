/* panel_parts.h: what the panels are made of; within a frame of Dear ImGui. For C++ only. */
#ifndef VIEWER_PANEL_PARTS_H
#define VIEWER_PANEL_PARTS_H

extern "C" {
#include "viewer/panel.h"
}

/* Lines beside the mouse. */
void panel_tooltip(const char *text);

/* Explains the control drawn last while the mouse rests on it. */
void panel_explain(const char *text);

/* Buttons side by side that share the width of the window. */
bool panel_button(const char *label, int of, bool first);

/* The control of a value, made from its description; in a popup it can be brought back to what was loaded. */
void panel_value(document *document, const dpl_section &section, const dpl_param &param);

/* The same of the value of that name, "sun.elevation"; nothing where the scene has none. */
void panel_named_value(document *document, const char *name);

/* The parts of the left panel: built-in scenes, what is changed most often, the camera's path, a still picture, all
 * values of the scene (`all`: also of what it does not use). */
void panel_scene_menu(const document *document, commands *pressed);
void panel_sun_and_water(document *document);
void panel_path(const panel_view &view, commands *pressed);
void panel_still(const panel_view &view, commands *pressed);
void panel_values(document *document, bool all);

/* The parts of the right panel: what a frame costs, against a budget in milliseconds; what it is made from, in pictures
 * `side` wide; the keys. */
void panel_passes(const panel_view &view, double *budget);
void panel_thumbnails(const panel_view &view, float side);
void panel_keys(void);

#endif
