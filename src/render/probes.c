#include "render/probes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PER_PART 500.0 /* cells that the triangles of a part fill, about */
#define NEAREST 0.03   /* m, least and greatest side of a cell */
#define FARTHEST 0.5
#define ALIKE 0.75f /* cosine between normals that one probe stands for */

static float dot(const float a[3], const float b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double triangle_area(const struct world *world, const unsigned *corners)
{
    const float *a = world->vertices[corners[0]].position, *b = world->vertices[corners[1]].position,
                *c = world->vertices[corners[2]].position;
    double u[3], v[3];
    for (int i = 0; i < 3; i++) {
        u[i] = (double)(b[i] - a[i]);
        v[i] = (double)(c[i] - a[i]);
    }
    return 0.5 * sqrt(pow(u[1] * v[2] - u[2] * v[1], 2) + pow(u[2] * v[0] - u[0] * v[2], 2) +
                      pow(u[0] * v[1] - u[1] * v[0], 2));
}

static double part_spacing(const struct world *world, const struct world_part *part)
{
    double area = 0;
    for (int i = part->first; i < part->first + part->count; i += 3)
        area += triangle_area(world, world->indices + i);
    return fmin(fmax(sqrt(area / PER_PART), NEAREST), FARTHEST);
}

static void find_cell(const float position[3], double spacing, int cell[3])
{
    for (int c = 0; c < 3; c++)
        cell[c] = (int)floor((double)position[c] / spacing);
}

static int compare(const void *left, const void *right)
{
    const struct probe *a = left, *b = right;
    if (a->part != b->part)
        return a->part < b->part ? -1 : 1;
    for (int c = 0; c < 3; c++)
        if (a->cell[c] != b->cell[c])
            return a->cell[c] < b->cell[c] ? -1 : 1;
    return 0;
}

/* One for each vertex of each part, sorted. */
static bool list_vertices(struct probes *probes, const struct world *world, const struct dpl_log *log)
{
    probes->parts = base_allocate(log, (size_t)world->vertex_count + 1, sizeof *probes->parts, "light probes");
    probes->all = base_allocate(log, (size_t)world->index_count + 1, sizeof *probes->all, "light probes");
    if (!probes->parts || !probes->all)
        return false;
    for (int i = 0; i < world->vertex_count; i++)
        probes->parts[i] = -1;
    for (int p = 0; p < world->part_count; p++) {
        const struct world_part *part = world->parts + p;
        for (int i = part->first; i < part->first + part->count; i++) {
            const struct world_vertex *vertex = world->vertices + world->indices[i];
            if (probes->parts[world->indices[i]] >= 0)
                continue;
            probes->parts[world->indices[i]] = p;
            struct probe *probe = probes->all + probes->count++;
            probe->part = p;
            find_cell(vertex->position, probes->spacing[p], probe->cell);
            memcpy(probe->position, vertex->position, sizeof probe->position);
            memcpy(probe->normal, vertex->normal, sizeof probe->normal);
        }
    }
    qsort(probes->all, (size_t)probes->count, sizeof *probes->all, compare);
    return true;
}

/* Of those in one cell, keeps the first of each way that they face. */
static void thin_out(struct probes *probes)
{
    int kept = 0, cell = 0;
    for (int i = 0; i < probes->count; i++) {
        const struct probe candidate = probes->all[i];
        if (kept > 0 && compare(probes->all + cell, &candidate))
            cell = kept;
        bool new = true;
        for (int k = cell; k < kept && new; k++)
            new = dot(probes->all[k].normal, candidate.normal) < ALIKE;
        if (new)
            probes->all[kept++] = candidate;
    }
    probes->count = kept;
}

bool probes_place(struct probes *probes, const struct world *world, const struct dpl_log *log)
{
    probes->spacing = base_allocate(log, (size_t)world->part_count + 1, sizeof *probes->spacing, "light probes");
    if (!probes->spacing)
        return false;
    for (int p = 0; p < world->part_count; p++)
        probes->spacing[p] = part_spacing(world, world->parts + p);
    if (!list_vertices(probes, world, log))
        return false;
    thin_out(probes);
    return true;
}

/* The first probe that is not before `key`. */
static int find(const struct probes *probes, const struct probe *key)
{
    int low = 0, high = probes->count;
    while (low < high) {
        int middle = (low + high) / 2;
        if (compare(probes->all + middle, key) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Adds the probes of one cell to the weighted sum: irradiance and weight. */
static void add_cell(const struct probes *probes, const struct probe *key, const struct world_vertex *vertex,
                     float sum[4])
{
    float reach = (float)probes->spacing[key->part];
    for (int i = find(probes, key); i < probes->count && !compare(probes->all + i, key); i++) {
        const struct probe *probe = probes->all + i;
        float away[3], alike = fmaxf(dot(probe->normal, vertex->normal), 0);
        for (int c = 0; c < 3; c++)
            away[c] = (probe->position[c] - vertex->position[c]) / reach;
        float weight = expf(-1.5f * dot(away, away)) * alike * alike * alike * alike + 1e-9f * alike;
        for (int c = 0; c < 3; c++)
            sum[c] += weight * probe->irradiance[c];
        sum[3] += weight;
    }
}

static void spread_vertex(const struct probes *probes, int part, const struct world_vertex *vertex, float *irradiance)
{
    struct probe key = {.part = part};
    float sum[4] = {0};
    int middle[3];
    find_cell(vertex->position, probes->spacing[part], middle);
    for (int n = 0; n < 27; n++) {
        const int step[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
        for (int c = 0; c < 3; c++)
            key.cell[c] = middle[c] + step[c];
        add_cell(probes, &key, vertex, sum);
    }
    for (int c = 0; c < 3; c++)
        irradiance[c] = sum[c] / fmaxf(sum[3], 1e-20f);
}

void probes_spread(const struct probes *probes, const struct world *world, float *irradiance)
{
#pragma omp parallel for schedule(dynamic, 256)
    for (int i = 0; i < world->vertex_count; i++)
        if (probes->parts[i] >= 0)
            spread_vertex(probes, probes->parts[i], world->vertices + i, irradiance + 3 * (size_t)i);
}

void probes_finish(struct probes *probes)
{
    free(probes->all);
    free(probes->spacing);
    free(probes->parts);
    *probes = (struct probes){0};
}
