/* light/triangles.h: triangles of light drawn into a caustic map on the CPU.
 *
 * A texel belongs to a triangle if its centre lies inside, or on an edge to the left or on a level edge at the top.
 * Triangles that share an edge thus neither leave out nor share a texel along it. */
#ifndef LIGHT_TRIANGLES_H
#define LIGHT_TRIANGLES_H

#include <stdbool.h>

struct triangle_corner {
    double x, z;    /* texels from the map's corner */
    float light[3]; /* red green blue; linear in between */
};

/* Rows of a map that one thread draws to. */
struct triangle_band {
    float *texels; /* of the whole map: side × side × 3 */
    int side;
    int first, end; /* rows, without the last */
    bool periodic;  /* what leaves the map on one side comes in on the other */
    bool overwrite; /* the later triangle wins; otherwise light is added up */
};

/* Draws the part of a triangle that lies in the band. One that reaches over more than TRIANGLE_WIDEST maps is too thin
 * to be seen, and left out. */
#define TRIANGLE_WIDEST 8
void triangle_draw(const struct triangle_band *band, const struct triangle_corner corners[3]);

/* How far a row of vertices reaches along z, texels. */
struct triangle_range {
    double least, most;
};

/* Draws the triangles between row j and row j + 1 of the vertices. */
typedef void triangle_row(const void *task, const struct triangle_band *band, int j);

/* Draws all rows of triangles, in order, to all of the map: each thread to a band of it, from the rows that may reach
 * there. `ranges`: of `vertices` rows of vertices. */
void triangle_rows_draw(const struct triangle_band *map, const struct triangle_range *ranges, int vertices,
                        triangle_row *draw, const void *task);

#endif
