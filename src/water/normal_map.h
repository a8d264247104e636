/* water/normal_map.h: the surface's unit normals seen from above, a texel each, on the CPU. Shaders have the same from
 * surface_normal() in water/surface.glsl.
 *
 * A texel's normal is that of its middle: the vertices' unit normals, interpolated over the triangle there, normalised.
 */
#ifndef WATER_NORMAL_MAP_H
#define WATER_NORMAL_MAP_H

#include "water/surface.h"

/* All zero: none yet. */
struct normal_map {
    int side;    /* texels */
    int columns; /* vertices in a row of `vertices`, with the repeated edge of a periodic surface */
    int rows;
    float *vertices[3]; /* unit normals of the surface's vertices: x, y, z */
    int *cells;         /* the cell that a column of texels lies in, and how far in, 0 to 1 */
    float *inside;
};

/* Makes room for `side` texels and takes the surface's normals. */
bool normal_map_begin(struct normal_map *map, const struct surface *surface, int side, const struct dpl_log *log);

/* Writes the normals of one row of texels. May be called by several threads at once. */
void normal_map_row(const struct normal_map *map, int row, float *x, float *y, float *z);

/* Leaves it zeroed. */
void normal_map_finish(struct normal_map *map);

#endif
