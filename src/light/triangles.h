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

/* True where something from `least` to `most` along z, texels, may reach rows of the band. */
bool triangle_band_reaches(const struct triangle_band *band, double least, double most);

#endif
