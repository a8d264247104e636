/* water/surface.h: the moving surface at one time, as a grid of vertices. What every water model makes and every
 * technique reads.
 *
 * Vertex (i, j) rests at x = -size/2 + i · spacing, z = -size/2 + j · spacing. A periodic surface leaves out the
 * repeated edge (spacing = size / columns); a bounded one has both edges (spacing = size / (columns - 1)). A cell is
 * cut into two triangles along the diagonal from (i + 1, j) to (i, j + 1). */
#ifndef WATER_SURFACE_H
#define WATER_SURFACE_H

#include "dapple/log.h"

#include <stdbool.h>

struct surface {
    int columns, rows;
    bool periodic;
    double size;   /* m */
    float *texels; /* rows × columns × 3: height (m), slope along x, slope along z */
    /* rows × columns × 2: how far a vertex stands from its place at rest, along x and z (m); NULL: none */
    float *shifts;
};

/* Makes the grid that size, or leaves it where it already is; `choppy`: with shifts. All zero is a valid empty surface.
 */
bool surface_resize(struct surface *surface, int columns, int rows, bool periodic, bool choppy, double size,
                    const struct dpl_log *log);

/* Leaves it zeroed. */
void surface_finish(struct surface *surface);

/* Distance between neighbouring vertices, m. */
double surface_spacing(const struct surface *surface);

/* Height and slopes at a place in cells from the first vertex, by straight lines between the vertices around it. */
void surface_blend(const struct surface *surface, double column, double row, double texel[3]);

/* Makes `to` what a choppy surface is like straight above and below the vertices of its grid: heights and slopes
 * without shifts. The place at rest of what has come to x is p = x - shift(p), by iteration, which finds it where the
 * surface does not overhang. For techniques that look straight up. water/flatten.glsl is its twin. */
bool surface_flatten(const struct surface *from, struct surface *to, const struct dpl_log *log);

/* Sets the slopes of a bounded surface from its heights: a vertex's normal is the normalised sum of the unit normals of
 * the triangles around it (Collard & Mundi 2022, as their program has it). */
void surface_slopes_from_faces(struct surface *surface);

#endif
