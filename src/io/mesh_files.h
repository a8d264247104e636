/* io/mesh_files.h: the files that assimp is shown while it reads a mesh: from memory, and only some. */
#ifndef IO_MESH_FILES_H
#define IO_MESH_FILES_H

#include "dapple/log.h"

#include <assimp/cfileio.h>

#include <stdbool.h>
#include <stddef.h>

#define MESH_FILES_SIZE_MAX ((size_t)256 << 20) /* bytes, of a mesh with all files that it names */

struct mesh_files {
    struct aiFileIO io;       /* for assimp, set by mesh_files_open() */
    const char *path, *bytes; /* of the mesh; both outlive this */
    size_t length;
    const char *name; /* by which assimp asks for the mesh: in a folder, as "mesh/main.obj" */
    const struct dpl_log *log;
    size_t left;       /* bytes that the files beside it may have */
    bool failed;       /* one of these could not be read, and that was logged */
    char missing[128]; /* the first of these that is not there, or not inside; empty: all are */
};

/* Fills `io` and what follows `log`; the other members are the caller's. */
void mesh_files_open(struct mesh_files *files);

#endif
