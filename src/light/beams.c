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
#include "light/triangles.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define STEPS 256 /* a texel, of corners: as GPUs draw, so that both see the same triangles */

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
    struct vertex *vertices;       /* rows × columns, with the repeated edge of a periodic surface */
    struct triangle_range *ranges; /* rows */
    int columns, rows;             /* that there is room for */
    struct beams_gpu gpu;
};

/* What is the same for all rays to one receiver. */
struct task {
    const struct light_input *input;
    const struct state *state;
    struct tracing_view view;
    double receiver;   /* m */
    int columns, rows; /* of vertices */
    struct optics_disc disc;
    struct ray_medium rays;
};

static void free_vertices(struct state *state)
{
    free(state->vertices);
    free(state->ranges);
    state->vertices = NULL;
    state->ranges = NULL;
    state->columns = state->rows = 0;
}

static bool resize(struct state *state, const struct task *task, const struct dpl_log *log)
{
    if (state->columns == task->columns && state->rows == task->rows)
        return true;
    free_vertices(state);
    size_t columns = (size_t)task->columns, rows = (size_t)task->rows;
    state->vertices = base_allocate(log, columns * rows, sizeof *state->vertices, "light");
    state->ranges = base_allocate(log, rows, sizeof *state->ranges, "light");
    if (!state->vertices || !state->ranges)
        return false;
    state->columns = task->columns;
    state->rows = task->rows;
    return true;
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

/* Steps 2 and 3. */
static void draw_triangle(const struct task *task, const struct triangle_band *band, const struct vertex *a,
                          const struct vertex *b, const struct vertex *c)
{
    const struct beams *p = task->input->params;
    const struct vertex *const vertices[3] = {a, b, c};
    struct triangle_corner corners[3];
    double area = doubled_area(a->above, b->above, c->above), image = doubled_area(a->place, b->place, c->place);
    if (!a->arrives || !b->arrives || !c->arrives || area <= 0 || image == 0)
        return;
    for (int i = 0; i < 3; i++) {
        corners[i].x = rint(vertices[i]->place[0] * STEPS) / STEPS;
        corners[i].z = rint(vertices[i]->place[1] * STEPS) / STEPS;
        for (int k = 0; k < 3; k++) {
            double mean = (double)(a->light[k] + b->light[k] + c->light[k]) / 3;
            corners[i].light[k] = (float)fmin(area / fabs(image) * mean, p->most);
        }
    }
    triangle_draw(band, corners);
}

/* Step 4, a triangle_row. */
static void draw_row(const void *task_, const struct triangle_band *band, int j)
{
    const struct task *task = task_;
    const struct vertex *upper = task->state->vertices + (size_t)j * (size_t)task->columns;
    const struct vertex *lower = upper + task->columns;
    for (int i = 0; i < task->columns - 1; i++) {
        draw_triangle(task, band, upper + i, upper + i + 1, lower + i);
        draw_triangle(task, band, upper + i + 1, lower + i + 1, lower + i);
    }
}

static void trace_row(const struct task *task, int j, int color)
{
    struct vertex *row = task->state->vertices + (size_t)j * (size_t)task->columns;
    struct triangle_range range = {INFINITY, -INFINITY};
    for (int i = 0; i < task->columns; i++) {
        row[i] = trace_vertex(task, i, j, color);
        range.least = row[i].arrives ? fmin(range.least, row[i].place[1]) : range.least;
        range.most = row[i].arrives ? fmax(range.most, row[i].place[1]) : range.most;
    }
    task->state->ranges[j] = range;
}

static void trace_color(const struct task *task, int color, float *texels)
{
    const struct triangle_band map = {.texels = texels, .side = task->view.side, .periodic = task->view.period > 0};
#pragma omp parallel for schedule(static)
    for (int j = 0; j < task->rows; j++)
        trace_row(task, j, color);
    triangle_rows_draw(&map, task->state->ranges, task->rows, draw_row, task);
}

static bool trace(void *state_, const struct light_input *input, struct light_map *map)
{
    struct state *state = state_;
    const struct surface *surface = input->surface;
    struct task task = {
        .input = input,
        .state = state,
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
        float *texels = light_map_slice(map, slice);
        memset(texels, 0, sizeof *texels * 3 * (size_t)map->side * (size_t)map->side);
        for (int c = 0; c < 3; c += tracing_colors_together(&task.rays))
            trace_color(&task, c, texels);
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
    free_vertices(state);
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
    .energy = 0.15, /* of steep water, much of whose light goes to thin triangles */
    .reflects = true,
    .trace = trace,
    .draw = draw,
    .finish = finish,
};
