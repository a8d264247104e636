/* io/mesh_parts.h: what lies between the bytes of a mesh, assimp's scene and the mesh: checks, and the copy. */
#ifndef IO_MESH_PARTS_H
#define IO_MESH_PARTS_H

#include "io/mesh.h"

#include <stddef.h>
#include <stdint.h>

struct aiScene;

/* The ending of the name in small letters, ".obj", or NULL: none that is known. */
const char *mesh_ending(const char *path, const struct dpl_log *log);

/* True where the bytes look like a file of that ending and are as many as it says of itself, so that assimp may read
 * them. A zero byte follows the last. */
bool mesh_bytes_are_sound(const char *ending, const char *bytes, size_t length, const char *path,
                          const struct dpl_log *log);

/* The same for one format. */
bool mesh_gltf_is_sound(const char *bytes, size_t length, const char *path, const struct dpl_log *log);
bool mesh_glb_is_sound(const char *bytes, size_t length, const char *path, const struct dpl_log *log);
bool mesh_ply_is_sound(const char *bytes, size_t length, const char *path, const struct dpl_log *log);

/* Four bytes as a number, the lowest first. */
static inline uint32_t mesh_little_endian(const char *bytes)
{
    const unsigned char *b = (const unsigned char *)bytes;
    return b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

/* True where numbers that point to others are in range, coordinates are finite, and there are triangles, not too many.
 */
bool mesh_parts_are_sound(const struct aiScene *scene, const char *path, const struct dpl_log *log);

/* Fills the mesh, which is empty, with all triangles of a scene that is sound. On failure it may be half filled. */
bool mesh_parts_collect(const struct aiScene *scene, const char *path, struct io_mesh *mesh, const struct dpl_log *log);

/* Cuts a face of `count` corners, 3 at least, into count - 2 triangles of corners' numbers, which go round as it does.
 * A face of more than 64 corners is taken for convex. */
void mesh_cut_polygon(const float (*corners)[3], int count, int (*triangles)[3]);

/* The triangles from first_index to the last have as corners the vertices from first_vertex to *vertices, one after the
 * other. Gives these normals where they have none (`normals` is false), smooth where faces meet at 60° or less; makes
 * those that are the same one vertex, and *vertices how many there are then. */
bool mesh_merge_corners(struct io_mesh *mesh, int first_vertex, int first_index, bool normals, int *vertices,
                        const struct dpl_log *log);

#endif
