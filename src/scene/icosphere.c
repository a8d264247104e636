#include "scene/icosphere.h"

#include <math.h>

enum { CORNERS = 12, EDGES = 30, FACES = 20 };

/* Counter-clockwise as seen from outside. */
static const int faces[FACES][3] = {
    {0, 1, 4},   {0, 6, 1},   {0, 4, 8}, {0, 9, 6},  {0, 8, 9}, {1, 10, 4}, {1, 6, 11},
    {1, 11, 10}, {2, 5, 3},   {2, 3, 7}, {2, 8, 5},  {2, 7, 9}, {2, 9, 8},  {3, 5, 10},
    {3, 11, 7},  {3, 10, 11}, {4, 5, 8}, {4, 10, 5}, {6, 9, 7}, {6, 7, 11},
};
static const int edges[EDGES][2] = {
    {0, 1},  {0, 4}, {0, 6},  {0, 8}, {0, 9}, {1, 4},  {1, 6},  {1, 10}, {1, 11}, {2, 3},
    {2, 5},  {2, 7}, {2, 8},  {2, 9}, {3, 5}, {3, 7},  {3, 10}, {3, 11}, {4, 5},  {4, 8},
    {4, 10}, {5, 8}, {5, 10}, {6, 7}, {6, 9}, {6, 11}, {7, 9},  {7, 11}, {8, 9},  {10, 11},
};

/* The corners of an icosahedron: three rectangles of the golden ratio, across each other. */
static void corner_at(int corner, double out[3])
{
    const double golden = (1 + sqrt(5)) / 2;
    int axis = corner / 4;
    out[axis] = 0;
    out[(axis + 1) % 3] = corner & 1 ? -1 : 1;
    out[(axis + 2) % 3] = corner & 2 ? -golden : golden;
}

/* Adds the vertex in the direction of a mean of corners. */
static void add_direction(struct world_builder *builder, const int corners[3], const double weights[3])
{
    double sum[3] = {0};
    for (int k = 0; k < 3; k++) {
        double corner[3];
        corner_at(corners[k], corner);
        for (int c = 0; c < 3; c++)
            sum[c] += weights[k] * corner[c];
    }
    double length = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    struct world_vertex vertex = {0};
    for (int c = 0; c < 3; c++)
        vertex.position[c] = vertex.normal[c] = (float)(sum[c] / length);
    builder_vertex(builder, &vertex);
}

/* Vertices in this order: corners; those inside each edge; those inside each face, row by row. */
static void add_vertices(struct world_builder *builder, int n)
{
    for (int k = 0; k < CORNERS; k++)
        add_direction(builder, (const int[3]){k, k, k}, (const double[3]){1, 0, 0});
    for (int e = 0; e < EDGES; e++)
        for (int step = 1; step < n; step++)
            add_direction(builder, (const int[3]){edges[e][0], edges[e][1], 0}, (const double[3]){n - step, step, 0});
    for (int f = 0; f < FACES; f++)
        for (int c = 1; c < n; c++)
            for (int b = 1; b + c < n; b++)
                add_direction(builder, faces[f], (const double[3]){n - b - c, b, c});
}

/* The place in add_vertices()'s order of the vertex `step` of n along an edge from one corner to another. */
static int on_edge(int n, int from, int to, int step)
{
    int e = 0, low = from < to ? from : to, high = from < to ? to : from;
    if (step == 0 || step == n)
        return step == 0 ? from : to;
    while (edges[e][0] != low || edges[e][1] != high)
        e++;
    return CORNERS + e * (n - 1) + (from < to ? step : n - step) - 1;
}

/* The same of a face's vertex, b steps towards its second corner and c towards its third. */
static int on_face(int n, int f, int b, int c)
{
    const int *corners = faces[f];
    if (c == 0)
        return on_edge(n, corners[0], corners[1], b);
    if (b == 0)
        return on_edge(n, corners[0], corners[2], c);
    if (b + c == n)
        return on_edge(n, corners[1], corners[2], c);
    int before = (c - 1) * (2 * n - 2 - c) / 2; /* vertices of the rows below: n - 2, n - 3, … */
    return CORNERS + EDGES * (n - 1) + f * (n - 1) * (n - 2) / 2 + before + b - 1;
}

int icosphere_add(struct world_builder *builder, int divisions)
{
    const int first = builder->vertex_count, n = divisions;
    add_vertices(builder, n);
    for (int f = 0; f < FACES; f++) {
        for (int c = 0; c < n; c++) {
            for (int b = 0; b + c < n; b++) {
                unsigned here = (unsigned)(first + on_face(n, f, b, c));
                unsigned right = (unsigned)(first + on_face(n, f, b + 1, c));
                unsigned up = (unsigned)(first + on_face(n, f, b, c + 1));
                builder_triangle(builder, here, right, up);
                if (b + c + 1 < n)
                    builder_triangle(builder, right, (unsigned)(first + on_face(n, f, b + 1, c + 1)), up);
            }
        }
    }
    return first;
}
