/* Surfaces for shapes: flat faces, surfaces of revolution, smooth normals. */
#include "scene/world_builder.h"

#include "base/vector3.h"

#include <math.h>
#include <string.h>

#define CELLS_MAX 64      /* a side of a face */
#define CELL_LARGEST 0.25 /* m */

void builder_grid(struct world_builder *builder, unsigned first, int columns, int rows)
{
    for (int j = 0; j + 1 < rows; j++) {
        for (int i = 0; i + 1 < columns; i++) {
            unsigned a = first + (unsigned)(j * columns + i), above = a + (unsigned)columns;
            builder_triangle(builder, a, a + 1, above + 1);
            builder_triangle(builder, a, above + 1, above);
        }
    }
}

double builder_cell(double size)
{
    return fmin(CELL_LARGEST, size / 16);
}

void builder_face(struct world_builder *builder, const double corner[3], const double right[3], const double up[3],
                  double cell, const double color[3])
{
    double width = vector3_length(right), height = vector3_length(up), normal[3];
    int columns = (int)fmin(fmax(ceil(width / cell), 1), CELLS_MAX) + 1;
    int rows = (int)fmin(fmax(ceil(height / cell), 1), CELLS_MAX) + 1;
    unsigned first = (unsigned)builder->vertex_count;
    vector3_cross(right, up, normal);
    double area = vector3_length(normal);
    for (int j = 0; j < rows; j++) {
        for (int i = 0; i < columns; i++) {
            double u = (double)i / (columns - 1), v = (double)j / (rows - 1);
            struct world_vertex vertex = {.place = {(float)(u * width), (float)(v * height)}};
            for (int c = 0; c < 3; c++) {
                vertex.position[c] = (float)(corner[c] + u * right[c] + v * up[c]);
                vertex.normal[c] = (float)(normal[c] / area);
                vertex.color[c] = (float)color[c];
            }
            builder_vertex(builder, &vertex);
        }
    }
    builder_grid(builder, first, columns, rows);
}

/* The ring of vertices at one point of a profile, whose tangent is along (radius, height). */
static void add_ring(struct world_builder *builder, const double point[2], const double tangent[2], double along,
                     double around, int segments, const double color[3])
{
    double length = hypot(tangent[0], tangent[1]);
    for (int s = 0; s <= segments; s++) {
        double angle = 2 * M_PI * (s % segments) / segments, cosine = cos(angle), sine = -sin(angle);
        double outwards = tangent[1] / length;
        struct world_vertex vertex = {
            .position = {(float)(point[0] * cosine), (float)point[1], (float)(point[0] * sine)},
            .normal = {(float)(outwards * cosine), (float)(-tangent[0] / length), (float)(outwards * sine)},
            .color = {(float)color[0], (float)color[1], (float)color[2]},
            .place = {(float)(around * s / segments), (float)along}};
        builder_vertex(builder, &vertex);
    }
}

static bool is_edge(const double (*profile)[2], int points, int a, int b)
{
    return a < 0 || b >= points || (profile[a][0] == profile[b][0] && profile[a][1] == profile[b][1]);
}

void builder_revolve(struct world_builder *builder, const double (*profile)[2], int points, int segments,
                     const double color[3])
{
    unsigned first = (unsigned)builder->vertex_count, ring = (unsigned)segments + 1;
    double along = 0, widest = 0;
    for (int p = 0; p < points; p++)
        widest = fmax(widest, profile[p][0]);
    for (int p = 0; p < points; p++) {
        int before = is_edge(profile, points, p - 1, p) ? p : p - 1,
            after = is_edge(profile, points, p, p + 1) ? p : p + 1;
        const double tangent[2] = {profile[after][0] - profile[before][0], profile[after][1] - profile[before][1]};
        if (p > 0)
            along += hypot(profile[p][0] - profile[p - 1][0], profile[p][1] - profile[p - 1][1]);
        add_ring(builder, profile[p], tangent, along, 2 * M_PI * widest, segments, color);
    }
    for (int p = 0; p + 1 < points; p++) {
        for (unsigned s = 0; s < (unsigned)segments && !is_edge(profile, points, p, p + 1); s++) {
            unsigned a = first + (unsigned)p * ring + s, above = a + ring;
            if (profile[p][0] > 0)
                builder_triangle(builder, a, a + 1, above + 1);
            if (profile[p + 1][0] > 0)
                builder_triangle(builder, a, above + 1, above);
        }
    }
}

/* The triangle's normal, times the angle at each of its corners, is added to them. */
static void add_normal(struct world_vertex *vertices, const unsigned corners[3])
{
    double sides[3][3], normal[3];
    for (int k = 0; k < 3; k++)
        for (int c = 0; c < 3; c++)
            sides[k][c] = (double)vertices[corners[(k + 1) % 3]].position[c] - (double)vertices[corners[k]].position[c];
    vector3_cross(sides[0], sides[1], normal);
    double length = vector3_length(normal);
    for (int k = 0; k < 3 && length > 0; k++) {
        const double *to = sides[k], *from = sides[(k + 2) % 3];
        double dot = -(to[0] * from[0] + to[1] * from[1] + to[2] * from[2]);
        double angle = atan2(length, dot);
        for (int c = 0; c < 3; c++)
            vertices[corners[k]].normal[c] += (float)(angle * normal[c] / length);
    }
}

void builder_smooth(struct world_builder *builder, int first_vertex, int first_index)
{
    if (builder->failed)
        return;
    for (int v = first_vertex; v < builder->vertex_count; v++)
        memset(builder->vertices[v].normal, 0, sizeof builder->vertices[v].normal);
    for (int i = first_index; i + 2 < builder->index_count; i += 3)
        add_normal(builder->vertices, builder->indices + i);
    for (int v = first_vertex; v < builder->vertex_count; v++) {
        float *normal = builder->vertices[v].normal;
        double length = vector3_length((const double[3]){normal[0], normal[1], normal[2]});
        for (int c = 0; c < 3; c++)
            normal[c] = length > 0 ? (float)((double)normal[c] / length) : c == 1;
    }
}
