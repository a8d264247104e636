#include "scene/pieces.h"

#include "base/vector3.h"

#include <math.h>
#include <string.h>

#define PANEL_CELLS 64 /* a side of one face of builder_face() */
#define PANELS_MAX 8   /* a side */

struct world_part piece_material(const struct scene_object *object, int pattern)
{
    struct world_part part = builder_material(object);
    if (part.pattern == WORLD_PLAIN)
        part.pattern = pattern;
    return part;
}

static int panels_along(const double side[3], double cell)
{
    double length = sqrt(side[0] * side[0] + side[1] * side[1] + side[2] * side[2]);
    return (int)fmin(ceil(length / (cell * PANEL_CELLS)), PANELS_MAX);
}

void piece_move_pattern(struct world_builder *builder, int first, double across, double up)
{
    for (int v = first; v < builder->vertex_count; v++) {
        builder->vertices[v].place[0] += (float)across;
        builder->vertices[v].place[1] += (float)up;
    }
}

void piece_panel(struct world_builder *builder, const double corner[3], const double right[3], const double up[3],
                 double cell, const double color[3])
{
    int columns = panels_along(right, cell), rows = panels_along(up, cell);
    for (int j = 0; j < rows; j++) {
        for (int i = 0; i < columns; i++) {
            double part_corner[3], part_right[3], part_up[3];
            int first = builder->vertex_count;
            for (int c = 0; c < 3; c++) {
                part_right[c] = right[c] / columns;
                part_up[c] = up[c] / rows;
                part_corner[c] = corner[c] + i * part_right[c] + j * part_up[c];
            }
            builder_face(builder, part_corner, part_right, part_up, cell, color);
            piece_move_pattern(builder, first, i * vector3_length(part_right), j * vector3_length(part_up));
        }
    }
}

void piece_panel_over(struct world_builder *builder, const double corner[3], const double right[3], const double up[3],
                      double over, double cell, const double color[3])
{
    double across = over / vector3_length(right), along = over / vector3_length(up), low[3], wide[3], high[3];
    int first = builder->vertex_count;
    for (int c = 0; c < 3; c++) {
        low[c] = corner[c] - across * right[c] - along * up[c];
        wide[c] = (1 + 2 * across) * right[c];
        high[c] = (1 + 2 * along) * up[c];
    }
    piece_panel(builder, low, wide, high, cell, color);
    piece_move_pattern(builder, first, -over, -over);
}

void piece_block(struct world_builder *builder, const double low[3], const double high[3], double cell,
                 const double color[3])
{
    for (int axis = 0; axis < 3; axis++) {
        int across = (axis + 1) % 3, up = (axis + 2) % 3;
        for (int side = 0; side < 2; side++) {
            double corner[3] = {low[0], low[1], low[2]}, a[3] = {0}, b[3] = {0};
            corner[axis] = side ? high[axis] : low[axis];
            a[across] = high[across] - low[across];
            b[up] = high[up] - low[up];
            if (side == 0) { /* seen from the other side, right is left */
                for (int c = 0; c < 3; c++)
                    corner[c] += a[c];
                a[across] = -a[across];
            }
            piece_panel(builder, corner, a, b, cell, color);
        }
    }
}

static void normalize(double v[3])
{
    double length = vector3_length(v);
    for (int c = 0; c < 3; c++)
        v[c] = length > 0 ? v[c] / length : 0;
}

/* A ring across the line; `side` is across the line and is carried on along it, so that the tube does not twist. */
static void add_ring(struct world_builder *builder, const double point[3], const double along[3], double side[3],
                     double radius, int sides, double length, const double color[3])
{
    double dot = side[0] * along[0] + side[1] * along[1] + side[2] * along[2], other[3];
    for (int c = 0; c < 3; c++)
        side[c] -= dot * along[c];
    normalize(side);
    vector3_cross(along, side, other);
    for (int s = 0; s <= sides; s++) {
        double angle = 2 * M_PI * (s % sides) / sides;
        struct world_vertex vertex = {.place = {(float)(2 * M_PI * radius * s / sides), (float)length}};
        for (int c = 0; c < 3; c++) {
            double out = cos(angle) * side[c] + sin(angle) * other[c];
            vertex.normal[c] = (float)out;
            vertex.position[c] = (float)(point[c] + radius * out);
            vertex.color[c] = (float)color[c];
        }
        builder_vertex(builder, &vertex);
    }
}

/* Closes a tube: a flat end behind the ring that starts at vertex `ring`. */
static void add_end(struct world_builder *builder, unsigned ring, int sides, const double middle[3],
                    const double along[3], bool first)
{
    if (builder->failed)
        return;
    struct world_vertex vertex = builder->vertices[ring];
    unsigned rim = (unsigned)builder->vertex_count;
    for (int s = 0; s <= sides + 1; s++) {
        vertex = builder->failed ? vertex : builder->vertices[ring + (unsigned)(s <= sides ? s : 0)];
        for (int c = 0; c < 3; c++) {
            vertex.position[c] = s <= sides ? vertex.position[c] : (float)middle[c];
            vertex.normal[c] = (float)(first ? -along[c] : along[c]);
        }
        builder_vertex(builder, &vertex);
    }
    for (unsigned s = 0; s < (unsigned)sides; s++)
        builder_triangle(builder, rim + (unsigned)sides + 1, rim + s + first, rim + s + !first);
}

void piece_tube(struct world_builder *builder, const double (*line)[3], int points, double radius, int sides,
                const double color[3])
{
    unsigned first = (unsigned)builder->vertex_count;
    double side[3] = {0.31, 0.17, 0.93} /* along no axis */, ends[2][3] = {{0}}, length = 0;
    for (int p = 0; p < points; p++) {
        const double *before = line[p > 0 ? p - 1 : p], *after = line[p + 1 < points ? p + 1 : p];
        double along[3], step[3];
        for (int c = 0; c < 3; c++) {
            along[c] = after[c] - before[c];
            step[c] = line[p][c] - before[c];
        }
        length += vector3_length(step);
        normalize(along);
        add_ring(builder, line[p], along, side, radius, sides, length, color);
        memcpy(ends[p > 0], along, sizeof along);
    }
    builder_grid(builder, first, sides + 1, points);
    add_end(builder, first, sides, line[0], ends[0], true);
    add_end(builder, first + (unsigned)((points - 1) * (sides + 1)), sides, line[points - 1], ends[1], false);
}
