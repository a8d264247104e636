#include "io/mesh_parts.h"

#include "base/log.h"

#include <assimp/material.h>
#include <assimp/matrix4x4.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct collector {
    const struct aiScene *scene;
    const struct dpl_log *log;
    struct io_mesh *mesh;
    int vertices, indices; /* filled; before there is room, only indices are counted */
    int textures;          /* parts that have one */
};

/* Assimp's matrices hold rows that multiply columns. */
static void multiply(const float a[4][4], const float b[4][4], float product[4][4])
{
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            product[i][j] = 0;
            for (int k = 0; k < 4; k++)
                product[i][j] += a[i][k] * b[k][j];
        }
}

static float determinant(const float m[4][4])
{
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/* A normal goes by the cofactors of the matrix, which are its inverse transposed times the determinant. */
static void turn_normal(const float m[4][4], const struct aiVector3D *from, float to[3])
{
    const float n[3] = {from->x, from->y, from->z}, mirror = determinant(m) < 0 ? -1.0f : 1.0f;
    float length = 0;
    for (int i = 0; i < 3; i++) {
        int a = (i + 1) % 3, b = (i + 2) % 3;
        to[i] = 0;
        for (int j = 0; j < 3; j++) {
            int c = (j + 1) % 3, d = (j + 2) % 3;
            to[i] += mirror * (m[a][c] * m[b][d] - m[a][d] * m[b][c]) * n[j];
        }
        length += to[i] * to[i];
    }
    length = sqrtf(length);
    for (int i = 0; i < 3; i++)
        to[i] = length > 0 && isfinite(length) ? to[i] / length : i == 1;
}

static float share(float value)
{
    return value > 0 ? fminf(value, 1) : 0;
}

/* What assimp calls so is a grey of its own, for meshes that have no material. */
static bool is_made_up(const struct aiMaterial *material)
{
    struct aiString name;
    return aiGetMaterialString(material, AI_MATKEY_NAME, &name) == aiReturn_SUCCESS &&
           !strcmp(name.data, AI_DEFAULT_MATERIAL_NAME);
}

static void base_color(const struct aiMaterial *material, float color[3])
{
    struct aiColor4D found = {1, 1, 1, 1};
    if (!is_made_up(material) && aiGetMaterialColor(material, AI_MATKEY_BASE_COLOR, &found) != aiReturn_SUCCESS)
        aiGetMaterialColor(material, AI_MATKEY_COLOR_DIFFUSE, &found);
    color[0] = share(found.r);
    color[1] = share(found.g);
    color[2] = share(found.b);
}

static bool has_texture(const struct aiMaterial *material)
{
    return aiGetMaterialTextureCount(material, aiTextureType_DIFFUSE) > 0 ||
           aiGetMaterialTextureCount(material, aiTextureType_BASE_COLOR) > 0;
}

/* True where all are there: some programs write zeros. */
static bool has_normals(const struct aiMesh *part)
{
    for (unsigned i = 0; i < part->mNumVertices && part->mNormals; i++) {
        const struct aiVector3D *n = &part->mNormals[i];
        float squared = n->x * n->x + n->y * n->y + n->z * n->z;
        if (!(squared > 0) || !isfinite(squared))
            return false;
    }
    return part->mNormals;
}

/* A part in the place that its node says. */
struct placing {
    const struct aiMesh *part;
    float matrix[4][4], color[3];
    bool mirrored, normals;
};

static void place_corner(struct collector *to, const struct placing *placing, unsigned i)
{
    const struct aiVector3D *p = &placing->part->mVertices[i];
    const struct aiColor4D *c = placing->part->mColors[0] ? &placing->part->mColors[0][i] : NULL;
    const float(*m)[4] = placing->matrix;
    int k = to->vertices++;
    for (int a = 0; a < 3; a++)
        to->mesh->positions[k][a] = m[a][0] * p->x + m[a][1] * p->y + m[a][2] * p->z + m[a][3];
    if (placing->normals)
        turn_normal(m, &placing->part->mNormals[i], to->mesh->normals[k]);
    to->mesh->colors[k][0] = placing->color[0] * (c ? share(c->r) : 1);
    to->mesh->colors[k][1] = placing->color[1] * (c ? share(c->g) : 1);
    to->mesh->colors[k][2] = placing->color[2] * (c ? share(c->b) : 1);
}

/* `corners` and `triangles` are room for all corners of the face. */
static void place_face(struct collector *to, const struct placing *placing, const struct aiFace *face,
                       float (*corners)[3], int (*triangles)[3])
{
    for (unsigned k = 0; k < face->mNumIndices; k++) {
        const struct aiVector3D *p = &placing->part->mVertices[face->mIndices[k]];
        corners[k][0] = p->x;
        corners[k][1] = p->y;
        corners[k][2] = p->z;
    }
    mesh_cut_polygon((const float(*)[3])corners, (int)face->mNumIndices, triangles);
    for (unsigned t = 0; t + 2 < face->mNumIndices; t++)
        for (int k = 0; k < 3; k++)
            place_corner(to, placing, face->mIndices[triangles[t][placing->mirrored ? 2 - k : k]]);
}

static unsigned most_corners(const struct aiMesh *part)
{
    unsigned most = 0;
    for (unsigned i = 0; i < part->mNumFaces; i++)
        most = part->mFaces[i].mNumIndices > most ? part->mFaces[i].mNumIndices : most;
    return most;
}

static bool place_part(struct collector *to, const struct placing *placing)
{
    const struct aiMesh *part = placing->part;
    const unsigned most = most_corners(part);
    int first = to->vertices, first_index = to->indices;
    float(*corners)[3] = base_allocate(to->log, (size_t)most + 1, sizeof *corners, "a face");
    int(*triangles)[3] = corners ? base_allocate(to->log, (size_t)most + 1, sizeof *triangles, "a face") : NULL;
    for (unsigned i = 0; i < part->mNumFaces && triangles; i++)
        if (part->mFaces[i].mNumIndices > 2)
            place_face(to, placing, &part->mFaces[i], corners, triangles);
    bool ok = triangles;
    free(triangles);
    free(corners);
    to->indices += to->vertices - first;
    return ok && mesh_merge_corners(to->mesh, first, first_index, placing->normals, &to->vertices, to->log);
}

static void count_part(struct collector *to, const struct aiMesh *part)
{
    for (unsigned i = 0; i < part->mNumFaces; i++)
        to->indices += part->mFaces[i].mNumIndices > 2 ? 3 * ((int)part->mFaces[i].mNumIndices - 2) : 0;
}

/* Counts what the node and those below it place, or places it where there is room. */
static bool collect(struct collector *to, const struct aiNode *node, const float parent[4][4])
{
    float local[4][4];
    struct placing placing;
    memcpy(local, &node->mTransformation, sizeof local);
    multiply(parent, local, placing.matrix);
    placing.mirrored = determinant(placing.matrix) < 0;
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        placing.part = to->scene->mMeshes[node->mMeshes[i]];
        const struct aiMaterial *material = to->scene->mMaterials[placing.part->mMaterialIndex];
        if (!to->mesh->indices) {
            count_part(to, placing.part);
            continue;
        }
        base_color(material, placing.color);
        placing.normals = has_normals(placing.part);
        to->textures += has_texture(material);
        if (!place_part(to, &placing))
            return false;
    }
    for (unsigned i = 0; i < node->mNumChildren; i++)
        if (!collect(to, node->mChildren[i], placing.matrix))
            return false;
    return true;
}

/* Every corner has room of its own before those that are the same are made one. */
static bool make_room(struct io_mesh *mesh, int indices, const struct dpl_log *log)
{
    const size_t count = (size_t)indices;
    mesh->index_count = indices;
    mesh->positions = base_allocate(log, count, sizeof *mesh->positions, "a mesh");
    mesh->normals = mesh->positions ? base_allocate(log, count, sizeof *mesh->normals, "a mesh") : NULL;
    mesh->colors = mesh->normals ? base_allocate(log, count, sizeof *mesh->colors, "a mesh") : NULL;
    mesh->indices = mesh->colors ? base_allocate(log, count, sizeof *mesh->indices, "a mesh") : NULL;
    return mesh->indices;
}

static bool placed_in_range(const struct io_mesh *mesh, const char *path, const struct dpl_log *log)
{
    for (int i = 0; i < mesh->vertex_count; i++)
        for (int a = 0; a < 3; a++)
            if (!(fabsf(mesh->positions[i][a]) <= (float)IO_MESH_COORDINATE_MAX))
                return base_fail(log, DPL_REASON_RANGE, "%s: a vertex placed by its node: %g (accepted: -1e6 to 1e6)",
                                 path, (double)mesh->positions[i][a]);
    return true;
}

bool mesh_parts_collect(const struct aiScene *scene, const char *path, struct io_mesh *mesh, const struct dpl_log *log)
{
    const float still[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    struct collector count = {.scene = scene, .log = log, .mesh = mesh}, fill = count;
    collect(&count, scene->mRootNode, still);
    if (!make_room(mesh, count.indices, log) || !collect(&fill, scene->mRootNode, still))
        return false;
    mesh->vertex_count = fill.vertices;
    if (fill.vertices > IO_MESH_VERTICES_MAX)
        return base_fail(log, DPL_REASON_LIMIT, "%s: too many vertices: %d (at most %d)", path, fill.vertices,
                         IO_MESH_VERTICES_MAX);
    if (fill.textures > 0)
        base_inform(log, "%s: textures are not read; base colours stand for them", path);
    return placed_in_range(mesh, path, log);
}
