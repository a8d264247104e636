/* tests/coverage.h: the light that the cells of a surface throw on a receiver a second time, as plain as can be, in
 * double precision, for the library to be held against: every triangle is clipped by every texel that it may touch.
 * Shares no code with it. */
#ifndef TESTS_COVERAGE_H
#define TESTS_COVERAGE_H

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

struct coverage_case {
    int columns, side; /* vertices, texels */
    bool periodic;
    double size, receiver; /* m; the receiver's height */
    double sun[3], ior, absorption;
    const float *surface; /* height and slopes of each vertex */
    const float *shifts;  /* m, along x and z, of each vertex from its place at rest; NULL: none */
    bool balanced;        /* vertices' images are moved to where the triangles between them err least */
};

/* What leaves the surface at (from_x, from_z) meets the receiver at (x, z); texels. */
struct coverage_point {
    double x, z, weight, from_x, from_z;
};

/* Share of light that goes on where the normal has that angle to the sun, and its direction. */
static inline double coverage_bend(const struct coverage_case *c, const double n[3], double out[3])
{
    double cosine = c->sun[0] * n[0] + c->sun[1] * n[1] + c->sun[2] * n[2];
    if (cosine <= 0)
        return 0;
    double angle = acos(fmin(cosine, 1)), bent = asin(sin(angle) / c->ior), r;
    if (angle < 1e-6)
        r = pow((c->ior - 1) / (c->ior + 1), 2);
    else
        r = (pow(sin(angle - bent) / sin(angle + bent), 2) + pow(tan(angle - bent) / tan(angle + bent), 2)) / 2;
    for (int k = 0; k < 3; k++)
        out[k] = c->receiver > 0 ? 2 * cosine * n[k] - c->sun[k]
                                 : -c->sun[k] / c->ior + (cosine / c->ior - cos(bent)) * n[k];
    if (c->receiver > 0 ? out[1] <= 1e-3 : out[1] >= 0)
        return 0;
    return c->receiver > 0 ? r : 1 - r;
}

static inline struct coverage_point coverage_vertex(const struct coverage_case *c, int i, int j)
{
    int at = (j % c->columns) * c->columns + i % c->columns;
    const float *vertex = c->surface + 3 * at, none[2] = {0}, *shift = c->shifts ? c->shifts + 2 * at : none;
    double length = sqrt(1 + pow((double)vertex[1], 2) + pow((double)vertex[2], 2)), up[3] = {0, 1, 0}, flat[3] = {0},
           out[3] = {0};
    double n[3] = {-(double)vertex[1] / length, 1 / length, -(double)vertex[2] / length}, height = (double)vertex[0];
    double spacing = c->size / (c->periodic ? c->columns : c->columns - 1), texel = c->size / c->side;
    double flat_share = coverage_bend(c, up, flat), share = coverage_bend(c, n, out);
    struct coverage_point p = {0};
    if (share <= 0)
        memcpy(out, flat, sizeof out);
    p.x = p.from_x = (i * spacing + (double)shift[0]) / texel;
    p.z = p.from_z = (j * spacing + (double)shift[1]) / texel;
    double rise = c->receiver - height, way = rise * c->receiver > 0 ? rise : 0; /* water beyond it: straight */
    p.x += out[0] / out[1] * way / texel;
    p.z += out[2] / out[1] * way / texel;
    double facing = (c->sun[0] * n[0] + c->sun[1] * n[1] + c->sun[2] * n[2]) * length / c->sun[1];
    double path = fabs(way / out[1]) - fabs(c->receiver / flat[1]);
    p.weight = share > 0 ? facing * share / flat_share * exp(c->receiver > 0 ? 0 : -c->absorption * path) : 0;
    return p;
}

/* The part of a convex polygon where sign × (its coordinate on an axis - limit) is not positive. */
static inline int coverage_clip(double (*p)[2], int count, int axis, double sign, double limit)
{
    double out[16][2];
    int n = 0;
    for (int i = 0; i < count; i++) {
        const double *a = p[i], *b = p[(i + 1) % count];
        double da = sign * (a[axis] - limit), db = sign * (b[axis] - limit);
        if (da <= 0)
            memcpy(out[n++], a, sizeof *out);
        if ((da < 0 && db > 0) || (da > 0 && db < 0))
            for (int k = 0; k < 2; k++)
                out[n][k] = a[k] + (b[k] - a[k]) * da / (da - db);
        n += (da < 0 && db > 0) || (da > 0 && db < 0);
    }
    memcpy(p, out, sizeof(double[2]) * (size_t)n);
    return n;
}

static inline double coverage_area(double (*p)[2], int count)
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += p[i][0] * p[(i + 1) % count][1] - p[(i + 1) % count][0] * p[i][1];
    return fabs(sum) / 2;
}

static inline void coverage_add(const struct coverage_case *c, const struct coverage_point t[3], double flux,
                                double *map)
{
    double corners[3][2] = {{t[0].x, t[0].z}, {t[1].x, t[1].z}, {t[2].x, t[2].z}}, area = coverage_area(corners, 3);
    int first[2], last[2];
    for (int k = 0; k < 2; k++) {
        first[k] = (int)floor(fmin(fmin(corners[0][k], corners[1][k]), corners[2][k]));
        last[k] = (int)floor(fmax(fmax(corners[0][k], corners[1][k]), corners[2][k]));
    }
    for (int z = first[1]; z <= last[1]; z++) {
        for (int x = first[0]; x <= last[0]; x++) {
            double p[16][2], share = 1;
            int to[2] = {x, z}, n = 3;
            memcpy(p, corners, sizeof corners);
            for (int k = 0; k < 2; k++) {
                n = coverage_clip(p, n, k, 1, to[k] + 1);
                n = coverage_clip(p, n, k, -1, to[k]);
                if (c->periodic)
                    to[k] = (to[k] % c->side + c->side) % c->side;
            }
            if (area > 1e-12)
                share = coverage_area(p, n) / area;
            else if (x > first[0] || z > first[1])
                share = 0; /* a point */
            if (to[0] >= 0 && to[1] >= 0 && to[0] < c->side && to[1] < c->side)
                map[to[1] * c->side + to[0]] += flux * share;
        }
    }
}

/* The image of a vertex moved by the mean error of the triangles around it: as long as images are parabolas, these cut
 * off 1/24 of the second differences along the mesh's three directions. Not at the edges, where there are none. */
static inline struct coverage_point coverage_balance(const struct coverage_case *c, const struct coverage_point *exact,
                                                     int cells, int i, int j)
{
    static const int around[6][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {1, -1}, {-1, 1}};
    struct coverage_point p = exact[j * (cells + 1) + i];
    double x = 0, z = 0;
    if (!c->balanced || (!c->periodic && (i == 0 || j == 0 || i == cells || j == cells)))
        return p;
    for (int k = 0; k < 6; k++) {
        int to_i = i + around[k][0], to_j = j + around[k][1];
        int wrapped_i = (to_i + cells) % cells, wrapped_j = (to_j + cells) % cells;
        if (!c->periodic) {
            wrapped_i = to_i;
            wrapped_j = to_j;
        }
        x += exact[wrapped_j * (cells + 1) + wrapped_i].x + (double)(to_i - wrapped_i) * c->side / cells - p.x;
        z += exact[wrapped_j * (cells + 1) + wrapped_i].z + (double)(to_j - wrapped_j) * c->side / cells - p.z;
    }
    p.x -= x / 24;
    p.z -= z / 24;
    return p;
}

/* Adds the light of a triangle: its area seen from above, none where it is turned over there, and the mean weight. */
static inline void coverage_triangle(const struct coverage_case *c, const struct coverage_point t[3], double share,
                                     double *map)
{
    double area = ((t[1].from_x - t[0].from_x) * (t[2].from_z - t[0].from_z) -
                   (t[1].from_z - t[0].from_z) * (t[2].from_x - t[0].from_x)) /
                  2;
    if (area > 0)
        coverage_add(c, t, share * area * (t[0].weight + t[1].weight + t[2].weight) / 3, map);
}

/* Adds `share` of the light of one sun. */
static inline void coverage_map(const struct coverage_case *c, double share, double *map)
{
    int cells = c->columns - (c->periodic ? 0 : 1), vertices = cells + 1;
    struct coverage_point *exact = malloc(sizeof *exact * (size_t)(vertices * vertices));
    for (int k = 0; k < vertices * vertices; k++)
        exact[k] = coverage_vertex(c, k % vertices, k / vertices);
    for (int k = 0; k < cells * cells; k++) {
        struct coverage_point p[4];
        for (int corner = 0; corner < 4; corner++)
            p[corner] = coverage_balance(c, exact, cells, k % cells + corner % 2, k / cells + corner / 2);
        coverage_triangle(c, (struct coverage_point[3]){p[0], p[1], p[2]}, share, map);
        coverage_triangle(c, (struct coverage_point[3]){p[3], p[2], p[1]}, share, map);
    }
    free(exact);
}

#endif
