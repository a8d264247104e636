#include "io/mesh_parts.h"

#include "base/log.h"

#include <assimp/material.h>
#include <assimp/matrix4x4.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <math.h>
#include <string.h>

/* Vertices before those that are the same are made one. */
#define VERTICES_ROOM (3 * IO_MESH_TRIANGLES_MAX)

struct collector {
    const struct aiScene *scene;
    const struct dpl_log *log;
    struct io_mesh *mesh;
    int vertices, triangles; /* counted, then filled */
    int textures;            /* parts that have one */
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

/* One vertex of a part, in the place that the matrix says. */
static void place_vertex(struct collector *to, const struct aiMesh *part, unsigned i, const float m[4][4],
                         const float color[3], bool normals)
{
    const struct aiVector3D *p = &part->mVertices[i];
    const struct aiColor4D *c = part->mColors[0] ? &part->mColors[0][i] : NULL;
    int k = to->vertices++;
    for (int a = 0; a < 3; a++)
        to->mesh->positions[k][a] = m[a][0] * p->x + m[a][1] * p->y + m[a][2] * p->z + m[a][3];
    if (normals)
        turn_normal(m, &part->mNormals[i], to->mesh->normals[k]);
    to->mesh->colors[k][0] = color[0] * (c ? share(c->r) : 1);
    to->mesh->colors[k][1] = color[1] * (c ? share(c->g) : 1);
    to->mesh->colors[k][2] = color[2] * (c ? share(c->b) : 1);
}

/* Places a part: its vertices where it has normals, otherwise the corners of its triangles, one after the other. */
static bool place_part(struct collector *to, const struct aiMesh *part, const float m[4][4])
{
    const struct aiMaterial *material = to->scene->mMaterials[part->mMaterialIndex];
    const bool mirrored = determinant(m) < 0, normals = has_normals(part);
    int first = to->vertices, first_index = 3 * to->triangles;
    float color[3];
    base_color(material, color);
    to->textures += has_texture(material);
    for (unsigned i = 0; i < part->mNumVertices && normals; i++)
        place_vertex(to, part, i, m, color, normals);
    for (unsigned i = 0; i < part->mNumFaces; i++) {
        const struct aiFace *face = &part->mFaces[i];
        for (int k = 0; k < 3 && face->mNumIndices == 3; k++) {
            unsigned from = face->mIndices[mirrored ? 2 - k : k];
            to->mesh->indices[3 * (size_t)to->triangles + (size_t)k] =
                normals ? (unsigned)first + from : (unsigned)to->vertices;
            if (!normals)
                place_vertex(to, part, from, m, color, normals);
        }
        to->triangles += face->mNumIndices == 3;
    }
    return normals || mesh_make_normals(to->mesh, first, first_index, &to->vertices, to->log);
}

static void count_part(struct collector *to, const struct aiMesh *part)
{
    int before = to->triangles;
    for (unsigned i = 0; i < part->mNumFaces; i++)
        to->triangles += part->mFaces[i].mNumIndices == 3;
    double more = has_normals(part) ? (double)part->mNumVertices : 3.0 * (to->triangles - before);
    to->vertices = (int)fmin(to->vertices + more, VERTICES_ROOM + 1);
}

/* Counts what the node and those below it place, or places it where there is room. */
static bool collect(struct collector *to, const struct aiNode *node, const float parent[4][4])
{
    float local[4][4], m[4][4];
    memcpy(local, &node->mTransformation, sizeof local);
    multiply(parent, local, m);
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        const struct aiMesh *part = to->scene->mMeshes[node->mMeshes[i]];
        if (!to->mesh->indices)
            count_part(to, part);
        else if (!place_part(to, part, m))
            return false;
    }
    for (unsigned i = 0; i < node->mNumChildren; i++)
        if (!collect(to, node->mChildren[i], m))
            return false;
    return true;
}

static bool make_room(struct io_mesh *mesh, int vertices, int triangles, const struct dpl_log *log)
{
    mesh->vertex_count = vertices;
    mesh->index_count = 3 * triangles;
    mesh->positions = base_allocate(log, (size_t)vertices, sizeof *mesh->positions, "a mesh");
    mesh->normals = mesh->positions ? base_allocate(log, (size_t)vertices, sizeof *mesh->normals, "a mesh") : NULL;
    mesh->colors = mesh->normals ? base_allocate(log, (size_t)vertices, sizeof *mesh->colors, "a mesh") : NULL;
    mesh->indices = mesh->colors ? base_allocate(log, 3 * (size_t)triangles, sizeof(unsigned), "a mesh") : NULL;
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
    if (count.triangles == 0)
        return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: has no triangles (accepted: 1 at least)", path);
    if (count.vertices <= VERTICES_ROOM &&
        (!make_room(mesh, count.vertices, count.triangles, log) || !collect(&fill, scene->mRootNode, still)))
        return false;
    if (count.vertices > VERTICES_ROOM || fill.vertices > IO_MESH_VERTICES_MAX)
        return base_fail(log, DPL_REASON_LIMIT, "%s: too many vertices (at most %d)", path, IO_MESH_VERTICES_MAX);
    mesh->vertex_count = fill.vertices;
    if (fill.textures > 0)
        base_inform(log, "%s: textures are not read; base colours stand for them", path);
    return placed_in_range(mesh, path, log);
}
