/* The CPU's half of wavefront.c: the mesh drawn by triangles.c, a band of rows of the map for each thread. */
#include "light/wavefront.h"

#include "base/log.h"
#include "optics/refraction.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int cells_of(const struct surface *surface)
{
    return surface->periodic ? surface->columns : surface->columns - 1;
}

/* Numbers of a surface's vertices between four of them, at a place counted in its cells. */
static void interpolate(const struct surface *surface, const float *numbers, int channels, double x, double z,
                        float *out)
{
    int i = (int)x, j = (int)z, i1 = i + 1, j1 = j + 1;
    float fx = (float)(x - i), fz = (float)(z - j);
    i1 = i1 < surface->columns ? i1 : surface->periodic ? 0 : i;
    j1 = j1 < surface->rows ? j1 : surface->periodic ? 0 : j;
    for (int c = 0; c < channels; c++) {
        float upper = numbers[(j * surface->columns + i) * channels + c] * (1 - fx) +
                      numbers[(j * surface->columns + i1) * channels + c] * fx;
        float lower = numbers[(j1 * surface->columns + i) * channels + c] * (1 - fx) +
                      numbers[(j1 * surface->columns + i1) * channels + c] * fx;
        out[c] = upper * (1 - fz) + lower * fz;
    }
}

/* The surface at the vertices of a mesh of that many cells a side. */
static bool make_mesh(struct surface *mesh, const struct surface *surface, int cells, const struct dpl_log *log)
{
    int side = surface->periodic ? cells : cells + 1;
    if (!surface_resize(mesh, side, side, surface->periodic, surface->shifts != NULL, surface->size, log))
        return false;
    double step = (double)cells_of(surface) / cells;
#pragma omp parallel for
    for (int j = 0; j < side; j++) {
        for (int i = 0; i < side; i++) {
            size_t at = (size_t)j * (size_t)side + (size_t)i;
            interpolate(surface, surface->texels, 3, i * step, j * step, mesh->texels + at * 3);
            if (surface->shifts)
                interpolate(surface, surface->shifts, 2, i * step, j * step, mesh->shifts + at * 2);
        }
    }
    return true;
}

static bool resize(struct wavefront_state *state, int cells, const struct dpl_log *log)
{
    if (state->vertices && state->ranges && state->cells == cells)
        return true;
    wavefront_cpu_finish(state);
    size_t side = (size_t)cells + 1;
    state->vertices = base_allocate(log, side * side, sizeof *state->vertices, "wavefront");
    state->ranges = base_allocate(log, side, sizeof *state->ranges, "wavefront");
    state->cells = cells;
    return state->vertices && state->ranges;
}

void wavefront_cpu_finish(struct wavefront_state *state)
{
    surface_finish(&state->mesh);
    coverage_rays_finish(&state->rays);
    free(state->vertices);
    free(state->ranges);
    state->vertices = NULL;
    state->ranges = NULL;
}

/* What the threads share. */
struct task {
    const struct wavefront *params;
    const struct surface *mesh;
    const struct coverage_rays *rays;
    struct wavefront_vertex *vertices;
    struct triangle_range *ranges;
    int cells;
    struct wavefront_receiver receiver;
};

static const float *shift_of(const struct surface *mesh, int i, int j)
{
    static const float none[2];
    size_t at = (size_t)(j % mesh->rows) * (size_t)mesh->columns + (size_t)(i % mesh->columns);
    return mesh->shifts ? mesh->shifts + at * 2 : none;
}

/* Step 2: where the light of a vertex arrives, and how much. As coverage_vertex.glsl. */
static void place_vertex(const struct task *task, int i, int j, struct wavefront_vertex *vertex)
{
    const struct surface *mesh = task->mesh;
    const struct wavefront_receiver *receiver = &task->receiver;
    size_t at = (size_t)j * (size_t)task->rays->columns + (size_t)i;
    size_t from = (size_t)(j % mesh->rows) * (size_t)mesh->columns + (size_t)(i % mesh->columns);
    double way = receiver->height - (double)mesh->texels[from * 3], weight = (double)task->rays->weight[at];
    way = way * receiver->height > 0 ? way : 0; /* water beyond the receiver lies on it */
    double x = (double)task->rays->u[at] * way - receiver->flat.u * receiver->height;
    double z = (double)task->rays->v[at] * way - receiver->flat.v * receiver->height;
    vertex->moved[0] = (float)((x + (double)shift_of(mesh, i, j)[0]) * receiver->scale);
    vertex->moved[1] = (float)((z + (double)shift_of(mesh, i, j)[1]) * receiver->scale);
    double longer = (double)task->rays->q[at] * way - receiver->flat.q * receiver->height;
    for (int c = 0; c < 3; c++)
        vertex->light[c] = !task->params->weights
                               ? weight > 0
                               : (float)(weight * optics_transmittance(receiver->absorption[c], longer));
}

static void place_row(const struct task *task, int j)
{
    float least = INFINITY, most = -INFINITY;
    for (int i = 0; i <= task->cells; i++) {
        struct wavefront_vertex *vertex = task->vertices + (size_t)j * ((size_t)task->cells + 1) + (size_t)i;
        place_vertex(task, i, j, vertex);
        least = fminf(least, vertex->moved[1]);
        most = fmaxf(most, vertex->moved[1]);
    }
    double rest = j * task->receiver.cell + task->receiver.offset[1];
    task->ranges[j] = (struct triangle_range){rest + (double)least, rest + (double)most};
}

/* A triangle of the mesh before and after: edges from its first corner, texels. */
struct edges {
    double a[2], b[2];
};

static double cross(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

/* Step 3. The lengths are those of the derivatives of the place before along the map's axes. */
static float ratio_of(const struct edges *before, const struct edges *after, const struct wavefront *params)
{
    double doubled = cross(after->a, after->b), ratio = fabs(cross(before->a, before->b) / doubled);
    if (params->area == WAVEFRONT_LENGTHS) {
        double per_x = hypot(before->a[0] * after->b[1] - before->b[0] * after->a[1],
                             before->a[1] * after->b[1] - before->b[1] * after->a[1]);
        double per_z = hypot(before->b[0] * after->a[0] - before->a[0] * after->b[0],
                             before->b[1] * after->a[0] - before->a[1] * after->b[0]);
        ratio = per_x * per_z / (doubled * doubled);
    }
    return ratio < params->most ? (float)ratio : (float)params->most;
}

static void draw_triangle(const struct task *task, const struct triangle_band *band, const int places[3][2])
{
    struct triangle_corner corners[3];
    const struct wavefront_receiver *receiver = &task->receiver;
    double rest[3][2];
    for (int k = 0; k < 3; k++) {
        int i = places[k][0], j = places[k][1];
        const float *shift = shift_of(task->mesh, i, j);
        const struct wavefront_vertex *vertex = task->vertices + (size_t)j * ((size_t)task->cells + 1) + (size_t)i;
        corners[k].x = i * receiver->cell + receiver->offset[0] + (double)vertex->moved[0];
        corners[k].z = j * receiver->cell + receiver->offset[1] + (double)vertex->moved[1];
        rest[k][0] = i * receiver->cell + (double)shift[0] * receiver->scale;
        rest[k][1] = j * receiver->cell + (double)shift[1] * receiver->scale;
        memcpy(corners[k].light, vertex->light, sizeof vertex->light);
    }
    const struct edges before = {{rest[1][0] - rest[0][0], rest[1][1] - rest[0][1]},
                                 {rest[2][0] - rest[0][0], rest[2][1] - rest[0][1]}};
    const struct edges after = {{corners[1].x - corners[0].x, corners[1].z - corners[0].z},
                                {corners[2].x - corners[0].x, corners[2].z - corners[0].z}};
    float ratio = ratio_of(&before, &after, task->params);
    for (int k = 0; k < 3; k++)
        for (int c = 0; c < 3; c++)
            corners[k].light[c] *= ratio;
    triangle_draw(band, corners);
}

/* A triangle_row. */
static void draw_row(const void *task_, const struct triangle_band *band, int j)
{
    const struct task *task = task_;
    for (int i = 0; i < task->cells; i++) {
        draw_triangle(task, band, (const int[3][2]){{i, j}, {i + 1, j}, {i, j + 1}});
        draw_triangle(task, band, (const int[3][2]){{i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
    }
}

static void trace_slice(const struct task *task, struct light_map *map, int slice)
{
    const struct triangle_band whole = {
        .texels = light_map_slice(map, slice),
        .side = map->side,
        .periodic = task->mesh->periodic,
        .overwrite = task->params->folds == WAVEFRONT_OVERWRITE,
    };
    memset(whole.texels, 0, (size_t)map->side * (size_t)map->side * 3 * sizeof *whole.texels);
#pragma omp parallel for
    for (int j = 0; j <= task->cells; j++)
        place_row(task, j);
    triangle_rows_draw(&whole, task->ranges, task->cells + 1, draw_row, task);
}

bool wavefront_trace(void *state_, const struct light_input *input, struct light_map *map)
{
    struct wavefront_state *state = state_;
    const struct wavefront *params = input->params;
    const struct surface *mesh = input->surface;
    int cells = params->mesh ? params->mesh : cells_of(mesh);
    if (!resize(state, cells, input->log))
        return false;
    if (cells != cells_of(mesh)) {
        if (!make_mesh(&state->mesh, input->surface, cells, input->log))
            return false;
        mesh = &state->mesh;
    }
    struct task task = {
        .params = params,
        .mesh = mesh,
        .rays = &state->rays,
        .vertices = state->vertices,
        .ranges = state->ranges,
        .cells = cells,
    };
    for (int slice = 0; slice < map->slices; slice++) {
        task.receiver = wavefront_receiver_find(input, slice, map->side, cells, mesh->periodic);
        if (slice == 0 && !coverage_rays_trace(&state->rays, mesh, &task.receiver.flat, input->log))
            return false;
        trace_slice(&task, map, slice);
    }
    return true;
}
