/* render/water_mesh.h: the surface's triangles. A shader's vertex stage is render/water_mesh.glsl. */
#ifndef RENDER_WATER_MESH_H
#define RENDER_WATER_MESH_H

#include "render/frame.h"

/* All zero: none yet. */
struct water_mesh {
    GLuint array, buffer; /* vertex numbers */
    int cells, stride;    /* a side, that they are for; and vertices of the surface from one of theirs to the next */
};

/* Makes the triangles of the frame's surface, or leaves them where they are as many. Where it has more than `cells_max`
 * cells a side (0: however many), vertices are left out. */
bool water_mesh_ready(struct water_mesh *mesh, const struct frame *frame, int cells_max);

/* Draws them with the program in use, rows of cells from the eye outwards, so that a crest is drawn before what it
 * hides and is not blended over it. Sets the uniforms of render/water_mesh.glsl; the surface is bound to `unit`.
 * `tile`: where the middle of the tile is drawn. */
void water_mesh_draw(const struct water_mesh *mesh, const struct frame *frame, const struct gpu_program *program,
                     int unit, const double tile[3]);

void water_mesh_finish(struct water_mesh *mesh, struct dpl_gl *gl);

#endif
