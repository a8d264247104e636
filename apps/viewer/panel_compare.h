/* panel_compare.h: the part of the panels that compares techniques; within a frame of Dear ImGui. */
#ifndef VIEWER_PANEL_COMPARE_H
#define VIEWER_PANEL_COMPARE_H

#include "viewer/panel.h"

/* What is compared, and how far apart the maps are, in the current window. */
void panel_compare_controls(const struct panel_view *view);

/* The line between the two parts of a split picture, to be dragged. Before all windows that shall lie above it. */
void panel_compare_divider(const struct panel_view *view, float scale);

#endif
