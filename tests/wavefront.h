/* tests/wavefront.h: the technique `wavefront` a second time, as plain as can be: every triangle of the mesh is tested
 * at the centre of every texel around it. Its rays are those of tests/coverage.h. */
#ifndef TESTS_WAVEFRONT_H
#define TESTS_WAVEFRONT_H

#include "coverage.h"

struct wavefront_case {
    struct coverage_case water; /* its columns are the mesh's */
    bool lengths, overwrite, unweighted;
    double most; /* ratio of areas */
};

/* Twice the area of the triangle from corner `k` on whose last corner is (x, z). */
static inline double wavefront_side(const struct coverage_point t[3], int k, double x, double z)
{
    const struct coverage_point *a = t + k, *b = t + (k + 1) % 3;
    return (b->x - a->x) * (z - a->z) - (b->z - a->z) * (x - a->x);
}

/* How much brighter the triangle is than in flat water: the inverse of the map from places on the surface to places on
 * the receiver, measured by its determinant or by the lengths of its columns. */
static inline double wavefront_ratio(const struct coverage_point t[3], bool lengths)
{
    double after[2][2] = {{t[1].x - t[0].x, t[2].x - t[0].x}, {t[1].z - t[0].z, t[2].z - t[0].z}};
    double before[2][2] = {{t[1].from_x - t[0].from_x, t[2].from_x - t[0].from_x},
                           {t[1].from_z - t[0].from_z, t[2].from_z - t[0].from_z}};
    double determinant = after[0][0] * after[1][1] - after[0][1] * after[1][0], change[2][2];
    double inverse[2][2] = {{after[1][1] / determinant, -after[0][1] / determinant},
                            {-after[1][0] / determinant, after[0][0] / determinant}};
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            change[i][j] = before[i][0] * inverse[0][j] + before[i][1] * inverse[1][j];
    return lengths ? hypot(change[0][0], change[1][0]) * hypot(change[0][1], change[1][1])
                   : fabs(change[0][0] * change[1][1] - change[0][1] * change[1][0]);
}

static inline void wavefront_add(const struct wavefront_case *c, const struct coverage_point t[3], double *map)
{
    double ratio = fmin(wavefront_ratio(t, c->lengths), c->most);
    int first_x = (int)floor(fmin(fmin(t[0].x, t[1].x), t[2].x)), side = c->water.side;
    int last_x = (int)floor(fmax(fmax(t[0].x, t[1].x), t[2].x));
    int first_z = (int)floor(fmin(fmin(t[0].z, t[1].z), t[2].z));
    int last_z = (int)floor(fmax(fmax(t[0].z, t[1].z), t[2].z));
    for (int j = first_z; j <= last_z; j++) {
        for (int i = first_x; i <= last_x; i++) {
            double sides[3], total = 0, weight = 0;
            for (int k = 0; k < 3; k++)
                total += sides[k] = wavefront_side(t, k, i + 0.5, j + 0.5);
            for (int k = 0; k < 3; k++)
                weight += sides[(k + 1) % 3] / total * (c->unweighted ? t[k].weight > 0 : t[k].weight);
            int x = c->water.periodic ? (i % side + side) % side : i;
            int z = c->water.periodic ? (j % side + side) % side : j;
            if (sides[0] / total < 0 || sides[1] / total < 0 || sides[2] / total < 0 || x < 0 || z < 0 || x >= side ||
                z >= side)
                continue;
            map[z * side + x] = (c->overwrite ? 0 : map[z * side + x]) + ratio * weight;
        }
    }
}

/* Fills the map. */
static inline void wavefront_map(const struct wavefront_case *c, double *map)
{
    int cells = c->water.columns - (c->water.periodic ? 0 : 1);
    memset(map, 0, sizeof *map * (size_t)(c->water.side * c->water.side));
    for (int k = 0; k < cells * cells; k++) {
        struct coverage_point p[4];
        for (int corner = 0; corner < 4; corner++)
            p[corner] = coverage_vertex(&c->water, k % cells + corner % 2, k / cells + corner / 2);
        wavefront_add(c, (struct coverage_point[3]){p[0], p[1], p[2]}, map);
        wavefront_add(c, (struct coverage_point[3]){p[1], p[3], p[2]}, map);
    }
}

#endif
