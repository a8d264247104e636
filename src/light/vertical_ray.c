#include "light/vertical_ray.h"

#include "base/log.h"
#include "base/threads.h"
#include "base/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool vertical_ray_prepare(struct vertical_ray_state *state, struct dpl_gl *gl, const struct light_input *input)
{
    const struct vertical_ray *p = input->params;
    if (!state->ready || memcmp(p, &state->params, sizeof *p) != 0) {
        state->ready = state->uploaded = false;
        if (*p->sun_map == '\0')
            sun_picture_halo(&state->sun, p->sun_width, p->halo, p->falloff);
        else if (!sun_picture_read(&state->sun, p->sun_width * p->halo, p->sun_map, input->log))
            return false;
        state->params = *p;
        state->ready = true;
    }
    if (gl && !state->uploaded) {
        texture_resize(gl, &state->sun_texture, GL_R16F, SUN_PICTURE_SIDE, SUN_PICTURE_SIDE, TEXTURE_CLAMP,
                       TEXTURE_LINEAR);
        texture_upload(gl, &state->sun_texture, state->sun.texels);
        state->uploaded = true;
    }
    return true;
}

void vertical_ray_bind(const struct vertical_ray_state *state, struct dpl_gl *gl, const struct light_input *input,
                       const struct gpu_program *program, const struct vertical_points *points)
{
    surface_gpu_bind(gl, input->surface_gpu, program, 0);
    texture_bind(gl, &state->sun_texture, 1);
    program_int(gl, program, "sun_picture", 1);
    program_float(gl, program, "sun_reach", (double)state->sun.reach);
    program_float(gl, program, "ior", input->medium->ior);
    program_float(gl, program, "apart", points->apart);
    program_int(gl, program, "by_differences", points->normals == VERTICAL_DIFFERENCES);
    /* half a step before the first point, which lies in the middle of the target's first texel */
    const double first[3] = {points->x - points->step / 2, points->z - points->step / 2, points->step * points->side};
    program_vec3(gl, program, "square", first);
}

int vertical_ray_locate(double place, int cells, bool periodic, float *inside)
{
    place = periodic ? place - floor(place / cells) * cells : fmin(fmax(place, 0), cells);
    int cell = place < cells ? (int)place : cells - 1; /* the last one's end is its own */
    *inside = (float)(place - cell);
    return cell;
}

/* Makes room for `count` points. */
static bool resize_axis(struct vertical_axis *axis, int count, const struct dpl_log *log)
{
    if (axis->cells[0] && axis->inside[0] && axis->count == count)
        return true;
    free(axis->cells[0]);
    free(axis->inside[0]);
    *axis = (struct vertical_axis){.count = count,
                                   .cells = {base_allocate(log, (size_t)count * 3, sizeof(int), "rays")},
                                   .inside = {base_allocate(log, (size_t)count * 4, sizeof(float), "rays")}};
    if (!axis->cells[0] || !axis->inside[0])
        return false;
    for (int k = 1; k < 3; k++) {
        axis->cells[k] = axis->cells[0] + k * count;
        axis->inside[k] = axis->inside[0] + k * count;
    }
    axis->per_meter = axis->inside[0] + 3 * count;
    return true;
}

/* Places points on an axis of the surface's grid. */
static void fill_axis(struct vertical_axis *axis, const struct surface *surface, int vertices, double first,
                      const struct vertical_points *points)
{
    double spacing = surface_spacing(surface), end = surface->size / 2;
    int cells = surface->periodic ? vertices : vertices - 1;
    for (int i = 0; i < axis->count; i++) {
        double at = first + i * points->step, places[3];
        if (!surface->periodic)
            at = fmin(fmax(at, -end), end);
        places[0] = surface->periodic ? at - points->apart : fmax(at - points->apart, -end);
        places[1] = at;
        places[2] = surface->periodic ? at + points->apart : fmin(at + points->apart, end);
        for (int k = 0; k < 3; k++)
            axis->cells[k][i] =
                vertical_ray_locate((places[k] + end) / spacing, cells, surface->periodic, axis->inside[k] + i);
        axis->per_meter[i] = (float)(1 / (places[2] - places[0]));
    }
}

static bool resize_room(struct vertical_ray_state *state, const struct surface *surface, int side,
                        const struct dpl_log *log)
{
    bool fits = state->room && state->columns.count == side && state->grid_columns == surface->columns &&
                state->threads == threads_most();
    if (fits)
        return true;
    free(state->room);
    state->room = NULL;
    if (!resize_axis(&state->columns, side, log) || !resize_axis(&state->rows, side, log))
        return false;
    state->grid_columns = surface->columns;
    state->threads = threads_most();
    size_t row = 3 * ((size_t)surface->columns + 1) + 2 * (size_t)side;
    state->room = base_allocate(log, row * (size_t)state->threads, sizeof(float), "rays");
    return state->room != NULL;
}

/* One channel of the surface along a line between two rows of vertices. */
VECTOR_CLONES static void blend_vertices(const float *restrict first, const float *restrict second, float part,
                                         int count, float *restrict out)
{
    for (int i = 0; i < count; i++)
        out[i] = first[3 * i] + part * (second[3 * i] - first[3 * i]);
}

/* The same for the line on which a row of points has its k-th height; the repeated edge follows the last vertex. */
static void blend_line(const struct surface *surface, const struct vertical_axis *rows, int row, int k, int channel,
                       float *out)
{
    int cell = rows->cells[k][row];
    size_t columns = (size_t)surface->columns, next = (size_t)((cell + 1) % surface->rows);
    const float *texels = surface->texels + channel;
    blend_vertices(texels + (size_t)cell * columns * 3, texels + next * columns * 3, rows->inside[k][row],
                   surface->columns, out);
    out[columns] = out[0];
}

/* A blended line at the points of a row. */
VECTOR_CLONES static void interpolate(const float *restrict line, const int *restrict cells,
                                      const float *restrict inside, int count, float *restrict out)
{
    for (int i = 0; i < count; i++)
        out[i] = line[cells[i]] + inside[i] * (line[cells[i] + 1] - line[cells[i]]);
}

/* Heights along x: before and after each point, on the row's own line. */
VECTOR_CLONES static void differences_along(const float *restrict line, const struct vertical_axis *columns,
                                            float *restrict slopes)
{
    const int *restrict before = columns->cells[0], *restrict after = columns->cells[2];
    const float *restrict before_part = columns->inside[0], *restrict after_part = columns->inside[2];
    const float *restrict per_meter = columns->per_meter;
    for (int i = 0; i < columns->count; i++) {
        float first = line[before[i]] + before_part[i] * (line[before[i] + 1] - line[before[i]]);
        float last = line[after[i]] + after_part[i] * (line[after[i] + 1] - line[after[i]]);
        slopes[i] = (last - first) * per_meter[i];
    }
}

/* Heights along z: on the lines before and after the row. */
VECTOR_CLONES static void differences_across(const float *restrict first, const float *restrict last, float per_meter,
                                             const struct vertical_axis *columns, float *restrict slopes)
{
    const int *restrict cells = columns->cells[1];
    const float *restrict inside = columns->inside[1];
    for (int i = 0; i < columns->count; i++) {
        float at = last[cells[i]] - first[cells[i]], next = last[cells[i] + 1] - first[cells[i] + 1];
        slopes[i] = (at + inside[i] * (next - at)) * per_meter;
    }
}

/* Steps 3 and 4: optics_refract_out() for a ray (0, 1, 0), in single precision. */
VECTOR_CLONES static void see_sun(const struct sun_picture *sun, float ior, const float *restrict slopes_x,
                                  const float *restrict slopes_z, int count, float *restrict brightness)
{
    const float *restrict texels = sun->texels;
    const float middle = 0.5f * SUN_PICTURE_SIDE - 0.5f, scale = 0.5f * SUN_PICTURE_SIDE / sun->reach;
    const float last = SUN_PICTURE_SIDE - 1.001f; /* its cell has a next texel */
    for (int i = 0; i < count; i++) {
        float up = 1.0f / sqrtf(1.0f + slopes_x[i] * slopes_x[i] + slopes_z[i] * slopes_z[i]);
        float outside = 1.0f - ior * ior * (1.0f - up * up);
        float leaves = outside < 0.0f ? 0.0f : 1.0f;
        float turn = (ior * up - sqrtf(vector_positive(outside))) * up; /* of the normal, towards the slope */
        float x = vector_clamp(middle + turn * slopes_x[i] * scale, 0.0f, last);
        float z = vector_clamp(middle + turn * slopes_z[i] * scale, 0.0f, last);
        int column = (int)x, row = (int)z, corner = row * SUN_PICTURE_SIDE + column;
        float part_x = x - (float)column, part_z = z - (float)row;
        float above = texels[corner] + part_x * (texels[corner + 1] - texels[corner]);
        int under = corner + SUN_PICTURE_SIDE;
        float below = texels[under] + part_x * (texels[under + 1] - texels[under]);
        brightness[i] = leaves * (above + part_z * (below - above));
    }
}

static void trace_row(const struct vertical_ray_state *state, const struct light_input *input,
                      enum vertical_normals normals, int row, float *brightness)
{
    const struct surface *surface = input->surface;
    const struct vertical_axis *columns = &state->columns, *rows = &state->rows;
    int side = columns->count;
    size_t length = (size_t)surface->columns + 1;
    float *lines = state->room + (size_t)threads_index() * (3 * length + 2 * (size_t)side);
    float *slopes_x = lines + 3 * length, *slopes_z = slopes_x + side;
    if (normals == VERTICAL_DIFFERENCES) {
        for (int k = 0; k < 3; k++)
            blend_line(surface, rows, row, k, 0, lines + (size_t)k * length);
        differences_along(lines + length, columns, slopes_x);
        differences_across(lines, lines + 2 * length, rows->per_meter[row], columns, slopes_z);
    } else {
        for (int channel = 1; channel < 3; channel++) {
            blend_line(surface, rows, row, 1, channel, lines);
            interpolate(lines, columns->cells[1], columns->inside[1], side, channel == 1 ? slopes_x : slopes_z);
        }
    }
    see_sun(&state->sun, (float)input->medium->ior, slopes_x, slopes_z, side, brightness);
}

bool vertical_ray_trace(struct vertical_ray_state *state, const struct light_input *input,
                        const struct vertical_points *points, float *brightness)
{
    const struct surface *surface = input->surface;
    if (!resize_room(state, surface, points->side, input->log))
        return false;
    fill_axis(&state->columns, surface, surface->columns, points->x, points);
    fill_axis(&state->rows, surface, surface->rows, points->z, points);
#pragma omp parallel for
    for (int row = 0; row < points->side; row++)
        trace_row(state, input, points->normals, row, brightness + (size_t)row * (size_t)points->side);
    return true;
}

void vertical_ray_cut(const struct light_input *input, int slice, const struct light_map *map)
{
    const struct ray_window *window = input->windows + slice;
    double step = window->side / map->side, end = input->setup->size / 2;
    float *texels = light_map_slice(map, slice);
    for (int t = 0; !input->surface->periodic && t < map->side * map->side; t++) {
        double x = window->x + (t % map->side + 0.5) * step, z = window->z + (t / map->side + 0.5) * step;
        if (fabs(x) > end || fabs(z) > end)
            texels[t] = 0;
    }
}

void vertical_ray_finish(void *state_, struct dpl_gl *gl)
{
    struct vertical_ray_state *state = state_;
    struct vertical_axis *axes[] = {&state->columns, &state->rows};
    if (gl) {
        program_finish(gl, &state->program);
        program_finish(gl, &state->mesh_program);
        texture_finish(gl, &state->sun_texture);
        texture_finish(gl, &state->vertices);
    }
    for (int i = 0; i < 2; i++) {
        free(axes[i]->cells[0]);
        free(axes[i]->inside[0]);
    }
    free(state->room);
    light_map_finish(&state->mesh);
    *state = (struct vertical_ray_state){0};
}
