/* Corners of triangles become vertices, and get normals where they have none: the mean of those of the triangles that
 * meet there at not too sharp an angle, each weighted by its angle at the corner (Thürmer & Wüthrich 1998). */
#include "io/mesh_parts.h"

#include "base/hash.h"
#include "base/log.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SMOOTH 0.5f     /* cosine of the largest angle between faces that look like one surface: 60° */
#define SAME 0.9999f    /* cosine between normals that are one */
#define MEETING_MAX 256 /* corners that are looked at in one place: more are a fan without end */

/* Corners by their place: those of one number of `heads` follow each other in `next`. */
struct corners {
    const struct io_mesh *mesh;
    int first, count;  /* vertices, three a triangle */
    unsigned mask;     /* numbers of heads, less 1 */
    int *heads, *next; /* -1: none */
    float (*faces)[3]; /* unit normals of triangles, or 0 */
    int *target;       /* the vertex that the corner becomes, from `first` on */
};

static float dot_of(const float a[3], const float b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void normalize(float v[3])
{
    float length = sqrtf(dot_of(v, v));
    for (int c = 0; c < 3; c++)
        v[c] = length > 0 ? v[c] / length : 0;
}

static unsigned head_of(const struct corners *corners, const float position[3])
{
    const float plain[3] = {position[0] + 0.0f, position[1] + 0.0f, position[2] + 0.0f}; /* -0 is 0 */
    return (unsigned)(hash_bytes(hash_start, plain, sizeof plain) >> 20) & corners->mask;
}

static bool same_place(const float a[3], const float b[3])
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

static void measure_face(const struct corners *corners, int triangle)
{
    const float(*p)[3] = (const float(*)[3])corners->mesh->positions + corners->first + 3 * triangle;
    float a[3], b[3], *normal = corners->faces[triangle];
    for (int c = 0; c < 3; c++) {
        a[c] = p[1][c] - p[0][c];
        b[c] = p[2][c] - p[0][c];
    }
    normalize(a); /* so that the product of tiny sides is not 0 */
    normalize(b);
    for (int c = 0; c < 3; c++)
        normal[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
    normalize(normal);
}

static float angle_at(const struct corners *corners, int corner)
{
    const float(*p)[3] = (const float(*)[3])corners->mesh->positions + corners->first + corner / 3 * 3;
    float a[3], b[3];
    for (int c = 0; c < 3; c++) {
        a[c] = p[(corner + 1) % 3][c] - p[corner % 3][c];
        b[c] = p[(corner + 2) % 3][c] - p[corner % 3][c];
    }
    normalize(a);
    normalize(b);
    return acosf(fminf(fmaxf(dot_of(a, b), -1), 1));
}

static void make_normal(const struct corners *corners, int corner, float normal[3])
{
    const float *place = corners->mesh->positions[corners->first + corner], *face = corners->faces[corner / 3];
    int looked = 0;
    memset(normal, 0, 3 * sizeof *normal);
    for (int i = corners->heads[head_of(corners, place)]; i >= 0 && looked < MEETING_MAX;
         i = corners->next[i], looked++)
        if (same_place(corners->mesh->positions[corners->first + i], place) &&
            dot_of(face, corners->faces[i / 3]) >= SMOOTH)
            for (int c = 0; c < 3; c++)
                normal[c] += angle_at(corners, i) * corners->faces[i / 3][c];
    normalize(normal);
    if (!(dot_of(normal, normal) > 0))
        memcpy(normal, dot_of(face, face) > 0 ? face : (const float[3]){0, 1, 0}, 3 * sizeof *normal);
}

/* The vertex, of those kept from corners before this one, that is the same; -1: none. */
static int find_same(const struct corners *corners, int corner)
{
    const struct io_mesh *mesh = corners->mesh;
    int vertex = corners->first + corner, looked = 0;
    int i = corners->heads[head_of(corners, mesh->positions[vertex])];
    for (; i >= 0 && i < corner && looked < MEETING_MAX; i = corners->next[i], looked++) {
        int kept = corners->target[i];
        if (same_place(mesh->positions[kept], mesh->positions[vertex]) &&
            same_place(mesh->colors[kept], mesh->colors[vertex]) &&
            dot_of(mesh->normals[kept], mesh->normals[vertex]) > SAME)
            return kept;
    }
    return -1;
}

/* Corners that are the same become one vertex; returns how many vertices there are then. */
static int merge(struct corners *corners, struct io_mesh *mesh, int first_index)
{
    int kept = corners->first;
    for (int i = 0; i < corners->count; i++) {
        int vertex = corners->first + i, same = find_same(corners, i);
        if (same < 0) {
            same = kept++;
            memmove(mesh->positions[same], mesh->positions[vertex], sizeof *mesh->positions);
            memmove(mesh->normals[same], mesh->normals[vertex], sizeof *mesh->normals);
            memmove(mesh->colors[same], mesh->colors[vertex], sizeof *mesh->colors);
        }
        corners->target[i] = same;
        mesh->indices[first_index + i] = (unsigned)same;
    }
    return kept;
}

static void link_corners(struct corners *corners)
{
    for (unsigned i = 0; i <= corners->mask; i++)
        corners->heads[i] = -1;
    for (int i = corners->count - 1; i >= 0; i--) { /* each list ascends */
        unsigned head = head_of(corners, corners->mesh->positions[corners->first + i]);
        corners->next[i] = corners->heads[head];
        corners->heads[head] = i;
    }
}

static bool make_room(struct corners *corners, const struct dpl_log *log)
{
    size_t count = (size_t)corners->count;
    while (corners->mask < (unsigned)corners->count)
        corners->mask = 2 * corners->mask + 1;
    corners->heads = base_allocate(log, (size_t)corners->mask + 1, sizeof *corners->heads, "corners");
    corners->next = corners->heads ? base_allocate(log, count, sizeof *corners->next, "corners") : NULL;
    corners->faces = corners->next ? base_allocate(log, count / 3, sizeof *corners->faces, "corners") : NULL;
    corners->target = corners->faces ? base_allocate(log, count, sizeof *corners->target, "corners") : NULL;
    return corners->target;
}

bool mesh_merge_corners(struct io_mesh *mesh, int first_vertex, int first_index, bool normals, int *vertices,
                        const struct dpl_log *log)
{
    struct corners corners = {.mesh = mesh, .first = first_vertex, .count = *vertices - first_vertex};
    bool ok = make_room(&corners, log);
    if (ok) {
        link_corners(&corners);
        for (int t = 0; t < corners.count / 3 && !normals; t++)
            measure_face(&corners, t);
        for (int i = 0; i < corners.count && !normals; i++)
            make_normal(&corners, i, mesh->normals[first_vertex + i]);
        *vertices = merge(&corners, mesh, first_index);
    }
    free(corners.heads);
    free(corners.next);
    free(corners.faces);
    free(corners.target);
    return ok;
}
