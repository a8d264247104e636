/* Faces of more than three corners as triangles, by cutting off ears (Meisters 1975): corners that stick out and have
 * no other corner between their neighbours. */
#include "io/mesh_parts.h"

#include <math.h>

#define EARS_MAX 64 /* corners of faces that may be hollow: looking for ears takes the cube of that */

/* A face laid flat; corners are left out as their ears are cut off. */
struct flat {
    double place[EARS_MAX][2];
    int corner[EARS_MAX]; /* those left, in their order */
    int left;
};

/* Twice the area of the triangle of three places, positive where they go round as the face does. */
static double area(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static bool is_ear(const struct flat *flat, int middle)
{
    const int before = flat->corner[(middle + flat->left - 1) % flat->left],
              after = flat->corner[(middle + 1) % flat->left];
    const double *a = flat->place[before], *b = flat->place[flat->corner[middle]], *c = flat->place[after];
    if (!(area(a, b, c) > 0))
        return false;
    for (int i = 0; i < flat->left; i++) {
        const double *p = flat->place[flat->corner[i]];
        bool own = i == middle || flat->corner[i] == before || flat->corner[i] == after;
        if (!own && area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0)
            return false;
    }
    return true;
}

/* Lays the face along the axis that its normal, the sum of its sides' areas (Newell's), is nearest to. */
static void lay_flat(struct flat *flat, const float (*corners)[3], int count)
{
    double normal[3] = {0};
    for (int i = 0; i < count; i++)
        for (int c = 0; c < 3; c++) {
            const float *p = corners[i], *q = corners[(i + 1) % count];
            int d = (c + 1) % 3, e = (c + 2) % 3;
            normal[c] += ((double)p[d] - (double)q[d]) * ((double)p[e] + (double)q[e]);
        }
    int axis = fabs(normal[0]) > fabs(normal[1]) ? 0 : 1;
    axis = fabs(normal[2]) > fabs(normal[axis]) ? 2 : axis;
    for (int i = 0; i < count; i++) {
        double u = (double)corners[i][(axis + 1) % 3], v = (double)corners[i][(axis + 2) % 3];
        flat->place[i][0] = normal[axis] < 0 ? v : u;
        flat->place[i][1] = normal[axis] < 0 ? u : v;
        flat->corner[i] = i;
    }
    flat->left = count;
}

static void cut_fan(int count, int (*triangles)[3])
{
    for (int i = 0; i + 2 < count; i++) {
        triangles[i][0] = 0;
        triangles[i][1] = i + 1;
        triangles[i][2] = i + 2;
    }
}

void mesh_cut_polygon(const float (*corners)[3], int count, int (*triangles)[3])
{
    struct flat flat;
    if (count == 3 || count > EARS_MAX) {
        cut_fan(count, triangles);
        return;
    }
    lay_flat(&flat, corners, count);
    for (int t = 0; t < count - 2; t++) {
        int ear = 0;
        while (ear < flat.left && !is_ear(&flat, ear))
            ear++;
        ear = ear < flat.left ? ear : 0; /* none: it crosses itself, or has no area */
        triangles[t][0] = flat.corner[(ear + flat.left - 1) % flat.left];
        triangles[t][1] = flat.corner[ear];
        triangles[t][2] = flat.corner[(ear + 1) % flat.left];
        flat.left--;
        for (int i = ear; i < flat.left; i++)
            flat.corner[i] = flat.corner[i + 1];
    }
}
