/* io/mesh.h: triangles from files, through assimp: OBJ, glTF, GLB, PLY and STL. */
#ifndef IO_MESH_H
#define IO_MESH_H

#include "dapple/log.h"

#include <stdbool.h>

#define IO_MESH_VERTICES_MAX 4000000
#define IO_MESH_TRIANGLES_MAX 4000000
#define IO_MESH_COORDINATE_MAX 1e6

/* All zero: empty. */
struct io_mesh {
    float (*positions)[3]; /* in the file's unit, y up in glTF; at most IO_MESH_COORDINATE_MAX off the origin an axis */
    float (*normals)[3];   /* unit */
    float (*colors)[3];    /* 0 to 1, linear: base colour of the material × colour of the vertex */
    unsigned *indices;     /* three a triangle, counter-clockwise seen from outside */
    int vertex_count, index_count;
};

/* Reads all triangles of a file as one mesh, moved to where the file's nodes place them; lines and points are dropped.
 * The format is the one that the name's ending says. Normals that the file has not are made, smooth where faces meet at
 * 60° or less. A material is its base colour (OBJ: Kd, glTF: baseColorFactor), without textures; where there is none,
 * white. Other files that the mesh names (.mtl, .bin) are read from its folder and those below it, nowhere else.
 * False, with the reason logged: nothing is held then. */
bool io_mesh_read(const char *path, struct io_mesh *mesh, const struct dpl_log *log);

/* Frees what it holds and empties it. */
void io_mesh_finish(struct io_mesh *mesh);

#endif
