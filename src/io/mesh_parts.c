#include "io/mesh_parts.h"

#include "base/log.h"

#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <math.h>
#include <string.h>

static bool positions_are_sound(const struct aiMesh *mesh, const char *path, const struct dpl_log *log)
{
    for (unsigned i = 0; i < mesh->mNumVertices; i++) {
        const struct aiVector3D *p = &mesh->mVertices[i];
        if (!(fmaxf(fabsf(p->x), fmaxf(fabsf(p->y), fabsf(p->z))) <= (float)IO_MESH_COORDINATE_MAX) ||
            isnan(p->x + p->y + p->z))
            return base_fail(log, DPL_REASON_RANGE, "%s: vertex %u: %g %g %g (accepted: -1e6 to 1e6)", path, i,
                             (double)p->x, (double)p->y, (double)p->z);
    }
    return true;
}

static bool faces_are_sound(const struct aiMesh *mesh, const char *path, const struct dpl_log *log)
{
    for (unsigned i = 0; i < mesh->mNumFaces; i++) {
        const struct aiFace *face = &mesh->mFaces[i];
        for (unsigned k = 0; k < face->mNumIndices; k++)
            if (face->mIndices[k] >= mesh->mNumVertices)
                return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: face %u: vertex %u (accepted: below %u)", path, i,
                                 face->mIndices[k], mesh->mNumVertices);
    }
    return true;
}

static bool mesh_is_sound(const struct aiScene *scene, const struct aiMesh *mesh, const char *path,
                          const struct dpl_log *log)
{
    if (mesh->mMaterialIndex >= scene->mNumMaterials || (mesh->mNumVertices > 0 && !mesh->mVertices))
        return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: a mesh without vertices, or of a material that is not there",
                         path);
    return positions_are_sound(mesh, path, log) && faces_are_sound(mesh, path, log);
}

/* What nodes place, each mesh as often as it is placed. */
struct placed {
    long long vertices, faces; /* a line or point counts as a triangle */
    bool triangles;            /* there is one that is none of those */
};

static bool count_placed(const struct aiScene *scene, const struct aiNode *node, struct placed *placed,
                         const char *path, const struct dpl_log *log)
{
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        if (node->mMeshes[i] >= scene->mNumMeshes)
            return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: a node's mesh %u (accepted: below %u)", path,
                             node->mMeshes[i], scene->mNumMeshes);
        const struct aiMesh *mesh = scene->mMeshes[node->mMeshes[i]];
        for (unsigned k = 0; k < mesh->mNumFaces; k++) {
            placed->triangles = placed->triangles || mesh->mFaces[k].mNumIndices > 2;
            placed->faces += mesh->mFaces[k].mNumIndices > 2 ? mesh->mFaces[k].mNumIndices - 2 : 1;
        }
        placed->vertices += mesh->mNumVertices;
        if (placed->faces > IO_MESH_TRIANGLES_MAX)
            return base_fail(log, DPL_REASON_LIMIT, "%s: too many triangles: %lld and more (at most %d)", path,
                             placed->faces, IO_MESH_TRIANGLES_MAX);
        if (placed->vertices > 3LL * IO_MESH_TRIANGLES_MAX)
            return base_fail(log, DPL_REASON_LIMIT, "%s: too many vertices: %lld and more (at most %d)", path,
                             placed->vertices, 3 * IO_MESH_TRIANGLES_MAX);
    }
    for (unsigned i = 0; i < node->mNumChildren; i++)
        if (!count_placed(scene, node->mChildren[i], placed, path, log))
            return false;
    return true;
}

bool mesh_parts_are_sound(const struct aiScene *scene, const char *path, const struct dpl_log *log)
{
    struct placed placed = {.triangles = false};
    for (unsigned i = 0; i < scene->mNumMeshes; i++)
        if (!mesh_is_sound(scene, scene->mMeshes[i], path, log))
            return false;
    if (scene->mRootNode && !count_placed(scene, scene->mRootNode, &placed, path, log))
        return false;
    return placed.triangles ||
           base_fail(log, DPL_REASON_FILE_FORMAT, "%s: has no triangles (accepted: 1 at least)", path);
}
