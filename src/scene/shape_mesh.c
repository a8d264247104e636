/* Triangles from a file, as large as the object's size has room for, in the file's proportions. */
#include "scene/pieces.h"
#include "scene/shape.h"

#include "base/log.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The box around the corners of all triangles. */
static void measure(const struct io_mesh *mesh, double low[3], double high[3])
{
    for (int c = 0; c < 3; c++) {
        low[c] = INFINITY;
        high[c] = -INFINITY;
        for (int i = 0; i < mesh->index_count; i++) {
            low[c] = fmin(low[c], (double)mesh->positions[mesh->indices[i]][c]);
            high[c] = fmax(high[c], (double)mesh->positions[mesh->indices[i]][c]);
        }
    }
}

/* Times what the file's unit is multiplied by; 0: the mesh is a point. */
static double scale_of(const struct scene_object *object, const double low[3], const double high[3])
{
    double scale = INFINITY;
    for (int c = 0; c < 3; c++)
        if (high[c] > low[c])
            scale = fmin(scale, object->size[c] / (high[c] - low[c]));
    return isfinite(scale) ? scale : 0;
}

static void add_mesh(struct world_builder *builder, const struct scene_object *object, const struct io_mesh *mesh)
{
    double low[3], high[3];
    unsigned first = (unsigned)builder->vertex_count;
    measure(mesh, low, high);
    double scale = scale_of(object, low, high);
    const double base[3] = {(low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2};
    for (int v = 0; v < mesh->vertex_count; v++) {
        struct world_vertex vertex = {.sway = 0};
        for (int c = 0; c < 3; c++) {
            vertex.position[c] = (float)(scale * ((double)mesh->positions[v][c] - base[c]));
            vertex.normal[c] = mesh->normals[v][c];
            vertex.color[c] = (float)(object->color[c] * (double)mesh->colors[v][c]);
        }
        vertex.place[0] = vertex.position[0] + vertex.position[2];
        vertex.place[1] = vertex.position[1];
        builder_vertex(builder, &vertex);
    }
    for (int i = 0; i + 2 < mesh->index_count; i += 3)
        builder_triangle(builder, first + mesh->indices[i], first + mesh->indices[i + 1], first + mesh->indices[i + 2]);
}

static bool build(struct world_builder *builder, const struct scene_object *object, int seed)
{
    (void)seed; /* all copies are alike */
    struct world_part material = builder_material(object);
    char key[SCENE_OBJECT_NAME_SIZE + sizeof ".file"];
    snprintf(key, sizeof key, "%s.file", builder->name);
    struct base_named_log named = {.name = key, .outer = builder->log};
    const struct dpl_log *log = base_name_log(&named);
    if (object->file[0] == '\0')
        return base_fail(log, DPL_REASON_VALUE,
                         "no file is named (accepted: the name of a mesh, .obj .gltf .glb .ply .stl)");
    if (strcmp(object->file, builder->mesh_file) != 0) {
        io_mesh_finish(&builder->mesh);
        builder->mesh_file[0] = '\0';
        if (!io_mesh_read(object->file, &builder->mesh, log))
            return false;
        snprintf(builder->mesh_file, sizeof builder->mesh_file, "%s", object->file);
    }
    material.two_sided = true; /* a file's surfaces may be open, and wound either way */
    builder_part(builder, &material);
    add_mesh(builder, object, &builder->mesh);
    return builder_ok(builder);
}

const struct scene_shape shape_mesh = {
    .name = "mesh",
    .summary = "triangles from a file, .obj .gltf .glb .ply .stl, to fit the size; its base colours times the colour",
    .color = {{1, 1, 1}, {1, 1, 1}},
    .build = build,
};
