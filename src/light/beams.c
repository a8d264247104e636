/* Jensen & Golias 2001, "Deep-Water Animation and Rendering": a ray from the sun through every vertex of the waves.
 *
 *   1. each vertex of the surface refracts (or throws back) the light from the middle of the sun
 *   2. the three rays of a triangle of the surface are a beam, which meets the receiver in a triangle there
 *   3. its intensity is the ratio of the triangles' areas, seen from above, times the mean of its rays' weights
 *   4. it is added to the texels whose centres it covers
 *
 * What lies between the centres is not seen: where the water focuses, triangles are thinner than a texel, and chance
 * decides which of them count, with the more light the thinner they are. `most` keeps these from shining. `coverage`
 * shares the same light out by the areas of texels. */
#include "light/beams.h"

#include "base/log.h"

#include <math.h>
#include <stdlib.h>

#define STEPS 256         /* a texel, of corners: triangles with a common edge neither overlap nor leave a gap */
#define EXTENT_MAX 0x1p20 /* texels of a triangle; wider ones, of bounded water, are too dim to be seen */

static const struct dpl_param params[] = {
    PARAM_FLOAT(struct beams, most, 64, 1, 1000000, "",
                "largest intensity of one triangle, in units of flat water's: less sparkle, less light"),
    PARAM_END,
};

/* What a vertex of the surface sends. */
struct vertex {
    double above[2]; /* where it stands, and */
    double place[2]; /* where its ray meets the receiver: texels */
    float light[3];
    bool arrives;
};

struct state {
    struct vertex *vertices; /* rows × columns, with the repeated edge of a periodic surface */
    size_t room;
    struct tracing_sums sums;
    struct beams_gpu gpu;
};

/* What is the same for all rays to one receiver. */
struct task {
    const struct light_input *input;
    struct tracing_view view;
    double receiver;   /* m */
    int columns, rows; /* of vertices */
    struct optics_disc disc;
    struct ray_medium rays;
};

static bool resize(struct state *state, const struct task *task, const struct dpl_log *log)
{
    size_t count = (size_t)task->columns * (size_t)task->rows;
    if (state->room >= count)
        return true;
    free(state->vertices);
    state->vertices = base_allocate(log, count, sizeof *state->vertices, "light");
    state->room = state->vertices ? count : 0;
    return state->vertices != NULL;
}

static struct ray_point point_at(const struct task *task, int i, int j)
{
    const struct surface *surface = task->input->surface;
    size_t at = (size_t)(j % surface->rows) * (size_t)surface->columns + (size_t)(i % surface->columns);
    const float *texel = surface->texels + at * 3, *shift = surface->shifts ? surface->shifts + at * 2 : NULL;
    double spacing = surface_spacing(surface);
    return (struct ray_point){
        .x = i * spacing - surface->size / 2 + (shift ? (double)shift[0] : 0),
        .z = j * spacing - surface->size / 2 + (shift ? (double)shift[1] : 0),
        .height = (double)texel[0],
        .slope_x = (double)texel[1],
        .slope_z = (double)texel[2],
        .area = 1,
        .to_light = {task->disc.middle[0], task->disc.middle[1], task->disc.middle[2]},
    };
}

/* Step 1, for the colours from `color` that share a refractive index. */
static struct vertex trace_vertex(const struct task *task, int i, int j, int color)
{
    const struct tracing_view *view = &task->view;
    const struct ray_point point = point_at(task, i, j);
    struct ray ray = ray_start(&task->rays, &point, ray_kind_of(task->receiver), color);
    struct ray_hit hit;
    struct vertex vertex = {.arrives = ray.weight > 0 && ray_meet(&ray, &point, task->receiver, &hit)};
    if (!vertex.arrives)
        return vertex;
    const double above[2] = {point.x, point.z}, place[2] = {hit.x, hit.z};
    for (int k = 0; k < 2; k++) {
        vertex.above[k] = (above[k] - view->corner[k]) * view->texels_a_meter;
        vertex.place[k] = (place[k] - view->corner[k]) * view->texels_a_meter;
    }
    for (int c = color; c < color + tracing_colors_together(&task->rays); c++)
        vertex.light[c] = (float)ray_weight(&task->rays, &ray, &hit, task->receiver, c);
    return vertex;
}

static double doubled_area(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* An edge as a function that is positive on the triangle's side of it, in steps; what lies on the edge belongs to one
 * of the two triangles beside it. */
struct edge {
    int64_t value, along_x, along_z; /* at the first texel's centre; its change from texel to texel */
};

static struct edge edge_of(const int64_t a[2], const int64_t b[2], const int first[2])
{
    int64_t run = b[0] - a[0], rise = b[1] - a[1];
    int64_t x = (int64_t)first[0] * STEPS + STEPS / 2 - a[0], z = (int64_t)first[1] * STEPS + STEPS / 2 - a[1];
    bool owned = rise > 0 || (rise == 0 && run > 0);
    return (struct edge){run * z - rise * x - (owned ? 0 : 1), -rise * STEPS, run * STEPS};
}

/* Step 4 for one copy of a triangle. Corners turn from x to z. */
static void fill(const int64_t corners[3][2], const double light[3], struct tracing_sums *sums)
{
    int first[2], last[2];
    for (int k = 0; k < 2; k++) {
        int64_t a = corners[0][k], b = corners[1][k], c = corners[2][k];
        int64_t least = a < b ? a : b, most = a > b ? a : b, end = (int64_t)sums->side * STEPS;
        least = c < least ? c : least;
        most = c > most ? c : most;
        first[k] = least < 0 ? 0 : (int)(least / STEPS);
        last[k] = most < end ? (int)(most / STEPS) : sums->side - 1;
        if (most < 0)
            return;
    }
    struct edge edges[3];
    for (int k = 0; k < 3; k++)
        edges[k] = edge_of(corners[k], corners[(k + 1) % 3], first);
    for (int z = first[1]; z <= last[1]; z++) {
        int64_t at[3] = {edges[0].value, edges[1].value, edges[2].value};
        for (int x = first[0]; x <= last[0]; x++) {
            if ((at[0] | at[1] | at[2]) >= 0) /* none is negative */
                tracing_sums_add(sums, x, z, light);
            for (int k = 0; k < 3; k++)
                at[k] += edges[k].along_x;
        }
        for (int k = 0; k < 3; k++)
            edges[k].value += edges[k].along_z;
    }
}

static void fill_copies(const struct task *task, const struct vertex *const vertices[3], bool turned,
                        const double least[2], const double most[2], const double light[3], struct tracing_sums *sums)
{
    const struct tracing_view *view = &task->view;
    double start[2];
    int columns = tracing_copies(view, least[0], most[0], start);
    int rows = tracing_copies(view, least[1], most[1], start + 1);
    for (int copy = 0; copy < rows * columns; copy++) {
        const double moved[2] = {start[0] + copy % columns * view->period, start[1] + copy / columns * view->period};
        int64_t corners[3][2];
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 2; k++)
                corners[turned ? 2 - i : i][k] = llrint((vertices[i]->place[k] + moved[k]) * STEPS);
        fill(corners, light, sums);
    }
}

/* Steps 2 and 3. */
static void add_triangle(const struct task *task, const struct vertex *a, const struct vertex *b,
                         const struct vertex *c, struct tracing_sums *sums)
{
    const struct beams *p = task->input->params;
    double least[2], most[2], light[3], period = task->view.period;
    double area = doubled_area(a->above, b->above, c->above) / 2,
           image = doubled_area(a->place, b->place, c->place) / 2;
    if (!a->arrives || !b->arrives || !c->arrives || area <= 0 || image == 0)
        return;
    for (int k = 0; k < 2; k++) {
        least[k] = fmin(fmin(a->place[k], b->place[k]), c->place[k]);
        most[k] = fmax(fmax(a->place[k], b->place[k]), c->place[k]);
    }
    double extent = fmax(most[0] - least[0], most[1] - least[1]);
    bool even = period > 0 && extent > period; /* wider than the tile: as good as even */
    double density = even ? area / (period * period) : area / fabs(image);
    for (int i = 0; i < 3; i++)
        light[i] = fmin(density * (double)(a->light[i] + b->light[i] + c->light[i]) / 3, p->most);
    if (even)
        tracing_sums_add_everywhere(sums, light);
    else if (extent < EXTENT_MAX)
        fill_copies(task, (const struct vertex *const[]){a, b, c}, image < 0, least, most, light, sums);
}

static void trace_color(struct state *state, const struct task *task, int color)
{
    const struct vertex *vertices = state->vertices;
#pragma omp parallel for schedule(static)
    for (int j = 0; j < task->rows; j++)
        for (int i = 0; i < task->columns; i++)
            state->vertices[(size_t)j * (size_t)task->columns + (size_t)i] = trace_vertex(task, i, j, color);
#pragma omp parallel for schedule(static)
    for (int j = 0; j < task->rows - 1; j++) {
        const struct vertex *upper = vertices + (size_t)j * (size_t)task->columns, *lower = upper + task->columns;
        for (int i = 0; i < task->columns - 1; i++) {
            add_triangle(task, upper + i, upper + i + 1, lower + i, &state->sums);
            add_triangle(task, upper + i + 1, lower + i + 1, lower + i, &state->sums);
        }
    }
}

static bool trace(void *state_, const struct light_input *input, struct light_map *map)
{
    static const double scale[3] = {1, 1, 1};
    struct state *state = state_;
    const struct surface *surface = input->surface;
    struct task task = {
        .input = input,
        .columns = surface->columns + (surface->periodic ? 1 : 0),
        .rows = surface->rows + (surface->periodic ? 1 : 0),
        .disc = optics_sun_disc(input->sun),
    };
    if (!resize(state, &task, input->log))
        return false;
    ray_medium_start(&task.rays, input->medium, &task.disc);
    for (int slice = 0; slice < map->slices; slice++) {
        task.view = tracing_view_of(input, input->surface->periodic, map->side, slice);
        task.receiver = input->receivers[slice];
        if (!tracing_sums_start(&state->sums, map->side, input->log))
            return false;
        for (int c = 0; c < 3; c += tracing_colors_together(&task.rays))
            trace_color(state, &task, c);
        tracing_sums_read(&state->sums, scale, light_map_slice(map, slice));
    }
    return true;
}

static bool draw(void *state_, struct dpl_gl *gl, const struct light_input *input, struct gpu_texture *map)
{
    struct state *state = state_;
    return beams_gpu_draw(&state->gpu, gl, input, map);
}

static void finish(void *state_, struct dpl_gl *gl)
{
    struct state *state = state_;
    if (gl)
        beams_gpu_finish(&state->gpu, gl);
    free(state->vertices);
    tracing_sums_finish(&state->sums);
    *state = (struct state){0};
}

const struct light_technique light_beams = {
    .name = "beams",
    .summary = "a ray through each vertex of the waves; triangles of light by their areas, sampled at texel centres",
    .source = "Jensen & Golias 2001",
    .params = params,
    .params_size = sizeof(struct beams),
    .state_size = sizeof(struct state),
    .channels = 3,
    .physical = true,
    .energy = 0.1,
    .reflects = true,
    .trace = trace,
    .draw = draw,
    .finish = finish,
};
