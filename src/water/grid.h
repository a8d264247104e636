/* water/grid.h: water that is known as heights on a square grid, made a smooth surface: bicubic Catmull-Rom (Catmull &
 * Rom 1974), which goes through the heights and whose slopes are continuous; at a vertex they are the central
 * differences.
 *
 * Vertices stand as in water/surface.h. A periodic grid goes on beyond its edges as it begins. Beyond those of a
 * bounded one the heights at the edge go on, so that its slope fades out within a cell. */
#ifndef WATER_GRID_H
#define WATER_GRID_H

#include "water/water.h"

struct height_grid {
    int side; /* vertices, at least 1; a bounded grid has 2 */
    bool periodic;
    double size;          /* m */
    const float *heights; /* side × side, m */
};

/* Heights and slopes at any points; may be called by several threads at once. Leaves shifts and areas alone. */
void grid_sample(const struct height_grid *grid, struct water_points *points);

/* The same at the vertices of a surface; faster where it has this grid. */
void grid_fill(const struct height_grid *grid, struct surface *surface);

#endif
