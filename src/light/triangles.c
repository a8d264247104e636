/* Triangles by rows: two edges bound a triangle in each row of texels. Positions are counted in whole rows and columns
 * of a plane that the map repeats over, where the surface is periodic. */
#include "light/triangles.h"

#include "base/threads.h"

#include <math.h>
#include <stdint.h>

#define FARTHEST 0x1p40 /* texels: whatever lies beyond is not seen; whole numbers hold it */

/* A triangle's light over the plane: at its first corner, and how it grows along x and z. */
struct plane {
    const struct triangle_corner *at;
    double per_x[3], per_z[3];
};

/* A triangle so thin that its light has no sure slope has that of its first corner. */
static struct plane plane_of(const struct triangle_corner corners[3])
{
    double bx = corners[1].x - corners[0].x, bz = corners[1].z - corners[0].z;
    double cx = corners[2].x - corners[0].x, cz = corners[2].z - corners[0].z;
    double doubled = bx * cz - bz * cx, extent = fmax(fmax(fabs(bx), fabs(bz)), fmax(fabs(cx), fabs(cz)));
    double per_doubled = fabs(doubled) > 1e-9 * extent * extent ? 1 / doubled : 0;
    struct plane plane = {.at = corners};
    for (int k = 0; k < 3; k++) {
        double b = (double)corners[1].light[k] - (double)corners[0].light[k];
        double c = (double)corners[2].light[k] - (double)corners[0].light[k];
        plane.per_x[k] = (b * cz - c * bz) * per_doubled;
        plane.per_z[k] = (c * bx - b * cx) * per_doubled;
    }
    return plane;
}

/* Where an edge crosses a level; `upper` has the smaller z, so that both triangles at the edge find the same place. */
static double cross(const struct triangle_corner *upper, const struct triangle_corner *lower, double z)
{
    return upper->x + (z - upper->z) * ((lower->x - upper->x) / (lower->z - upper->z));
}

/* The first texel whose centre is not before a place. */
static int64_t first_from(double place)
{
    return (int64_t)ceil(place - 0.5);
}

static int64_t floor_divide(int64_t number, int64_t by)
{
    return number / by - (number % by < 0);
}

/* Columns from `start` to `end` of a row of the plane, which is row `row` of the map. */
static void draw_span(const struct triangle_band *band, const struct plane *plane, int64_t start, int64_t end,
                      int64_t row, double z)
{
    int64_t side = band->side, turns = floor_divide(start, side);
    if (!band->periodic) {
        turns = 0;
        start = start < 0 ? 0 : start;
        end = end < side ? end : side;
    }
    float *texels = band->texels + row * side * 3, keep = band->overwrite ? 0.0f : 1.0f;
    for (int64_t i = start, column = start - turns * side; i < end; i++, column = column + 1 == side ? 0 : column + 1) {
        double x = (double)i + 0.5 - plane->at->x;
        for (int k = 0; k < 3; k++) {
            double light = (double)plane->at->light[k] + plane->per_x[k] * x + plane->per_z[k] * (z - plane->at->z);
            texels[column * 3 + k] = keep * texels[column * 3 + k] + (float)fmax(light, 0);
        }
    }
}

static void sort_by_z(const struct triangle_corner *sorted[3])
{
    static const int pairs[3][2] = {{0, 1}, {1, 2}, {0, 1}};
    for (int p = 0; p < 3; p++) {
        const struct triangle_corner **a = sorted + pairs[p][0], **b = sorted + pairs[p][1], *other = *a;
        if ((*a)->z > (*b)->z) {
            *a = *b;
            *b = other;
        }
    }
}

/* False for what is too large or too far away, and for what is no number. */
static bool is_drawn(const struct triangle_band *band, const struct triangle_corner corners[3])
{
    double widest = (double)band->side * TRIANGLE_WIDEST;
    for (int k = 0; k < 3; k++) {
        const struct triangle_corner *a = corners + k, *b = corners + (k + 1) % 3;
        if (!(fabs(a->x - b->x) <= widest && fabs(a->z - b->z) <= widest && fabs(a->x) + fabs(a->z) < FARTHEST))
            return false;
    }
    return true;
}

void triangle_draw(const struct triangle_band *band, const struct triangle_corner corners[3])
{
    const struct triangle_corner *by_z[3] = {corners, corners + 1, corners + 2};
    sort_by_z(by_z);
    if (!is_drawn(band, corners))
        return;
    int64_t first = first_from(by_z[0]->z), end = first_from(by_z[2]->z), side = band->side;
    int64_t turn = band->periodic ? floor_divide(first, side) : 0, last = band->periodic ? floor_divide(end, side) : 0;
    struct plane plane = plane_of(corners);
    for (; turn <= last; turn++) {
        int64_t from = band->first + turn * side, to = band->end + turn * side;
        from = first > from ? first : from;
        to = end < to ? end : to;
        for (int64_t j = from; j < to; j++) {
            double z = (double)j + 0.5;
            bool below = z >= by_z[1]->z;
            double a = cross(by_z[0], by_z[2], z), b = cross(by_z[below ? 1 : 0], by_z[below ? 2 : 1], z);
            draw_span(band, &plane, first_from(fmin(a, b)), first_from(fmax(a, b)), j - turn * side, z);
        }
    }
}

/* True where something from `least` to `most` along z may reach rows of the band. */
static bool reaches(const struct triangle_band *band, double least, double most)
{
    double side = band->side, turns = band->periodic ? floor((least - band->first) / side) : 0;
    least -= turns * side;
    most -= turns * side;
    return (least < band->end && most > band->first) || (band->periodic && most > band->first + side);
}

void triangle_rows_draw(const struct triangle_band *map, const struct triangle_range *ranges, int vertices,
                        triangle_row *draw, const void *task)
{
    int bands = threads_most();
#pragma omp parallel for
    for (int b = 0; b < bands; b++) {
        struct triangle_band band = *map;
        band.first = (int)((int64_t)map->side * b / bands);
        band.end = (int)((int64_t)map->side * (b + 1) / bands);
        for (int j = 0; j < vertices - 1; j++)
            if (reaches(&band, fmin(ranges[j].least, ranges[j + 1].least), fmax(ranges[j].most, ranges[j + 1].most)))
                draw(task, &band, j);
    }
}
