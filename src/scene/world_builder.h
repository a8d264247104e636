/* scene/world_builder.h: what shapes build the world's triangles with.
 *
 * A builder that has failed (no memory, too many vertices: logged once) takes everything and keeps nothing, so that a
 * shape adds all it has and returns builder_ok() at its end. */
#ifndef SCENE_WORLD_BUILDER_H
#define SCENE_WORLD_BUILDER_H

#include "io/mesh.h"
#include "scene/object.h"
#include "scene/world.h"

#define WORLD_VERTICES_MAX 4000000
#define WORLD_INDICES_MAX 24000000

/* All zero but for `log` and `name`: an empty world. */
struct world_builder {
    const struct dpl_log *log;
    const char *name; /* of the object being built, "object.rock": for messages */
    bool failed;
    struct world_vertex *vertices;
    unsigned *indices;
    struct world_part *parts;
    int vertex_count, index_count, part_count;
    int vertex_room, index_room, part_room;
    struct io_mesh mesh; /* read last, from the file of that name: copies of an object have it in common */
    char mesh_file[DPL_PARAM_TEXT_SIZE];
};

bool builder_ok(const struct world_builder *builder);

/* Frees what it holds. */
void builder_finish(struct world_builder *builder);

/* The triangles added from here on are of this material; `first` and `count` are the builder's. The object's own
 * material is set before its shape is asked to build. */
void builder_part(struct world_builder *builder, const struct world_part *material);

/* The material that an object's values say. */
struct world_part builder_material(const struct scene_object *object);

/* Adds a vertex; returns its index. */
unsigned builder_vertex(struct world_builder *builder, const struct world_vertex *vertex);

/* Adds a triangle, counter-clockwise as seen from outside. */
void builder_triangle(struct world_builder *builder, unsigned a, unsigned b, unsigned c);

/* Adds the triangles between columns × rows vertices that stand row by row from `first` on. Seen from outside, columns
 * go to the right and rows up. */
void builder_grid(struct world_builder *builder, unsigned first, int columns, int rows);

/* Adds a flat parallelogram: its corner, and its sides to the right and up as seen from outside; m. Its cells are at
 * most `cell` wide, 64 a side at most. Its pattern starts at the corner. */
void builder_face(struct world_builder *builder, const double corner[3], const double right[3], const double up[3],
                  double cell, const double color[3]);

/* Adds a surface of revolution about y: radius and height of each point of its profile, upwards as seen on the right.
 * A point given twice is an edge: the normals on its sides differ. */
void builder_revolve(struct world_builder *builder, const double (*profile)[2], int points, int segments,
                     const double color[3]);

/* Gives the vertices from first_vertex on the normals of the triangles from first_index on, each weighted by its angle
 * at the vertex (Thürmer & Wüthrich 1998). */
void builder_smooth(struct world_builder *builder, int first_vertex, int first_index);

/* Turns what was built from first_vertex on about the origin, top towards +x by `tilt`, then from +x towards +z by
 * `turn` (degrees), and moves it. */
void builder_place(struct world_builder *builder, int first_vertex, double turn, double tilt, const double position[3]);

/* How wide the cells of a surface are, m, on a thing of that largest size: light is known at vertices only. */
double builder_cell(double size);

#endif
