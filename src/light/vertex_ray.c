/* Sánchez-Crespo, "Inexpensive Underwater Caustics Using Cg", in its first version, for OpenGL without shaders: a fine
 * mesh over the floor, "with the same granularity as the wave mesh", that is lit at its vertices and drawn over the
 * floor.
 *
 *   1. every vertex of the mesh sends a ray straight up: vertical_ray.h. The water's normal comes from the heights
 *      above its neighbours
 *   2. brightness is interpolated over the mesh's triangles, cut as those of the surface are
 *
 * Step 2 is done texel by texel, which is what a rasteriser does. The article adds the mesh to the floor; here that is
 * up to who shows the map. */
#include "light/vertical_ray.h"

#include "base/vector.h"

#include <math.h>

static const struct dpl_param params[] = {
    PARAM_INT(struct vertical_ray, mesh, 0, 0, LIGHT_MESH_MAX, "vertices",
              "side of the mesh over the floor, at least 2; 0 = as the surface's grid, as in the article"),
    VERTICAL_RAY_SUN_PARAMS,
    PARAM_END,
};

/* Cells a side of the mesh. */
static int count_cells(const struct vertical_ray *p, int grid, bool periodic)
{
    int vertices = p->mesh == 0 ? grid : p->mesh > 2 ? p->mesh : 2;
    return periodic ? vertices : vertices - 1;
}

/* The vertices, both edges included. */
static struct vertical_points find_vertices(const struct light_input *input, int cells)
{
    double size = input->setup->size, step = size / cells;
    return (struct vertical_points){cells + 1, -size / 2, -size / 2, step, step, VERTICAL_DIFFERENCES};
}

/* Where a map lies on the mesh, in cells: x and z of its corner, and its side. */
static void find_square(const struct light_input *input, int slice, int cells, double square[3])
{
    const struct ray_window *window = input->windows + slice;
    double size = input->setup->size;
    square[0] = (window->x / size + 0.5) * cells;
    square[1] = (window->z / size + 0.5) * cells;
    square[2] = window->side / size * cells;
}

/* Step 2 for a row of texels between a row of vertices and the next, `part` of the way down. `first` and `step`: of the
 * texels' middles, in cells. */
VECTOR_CLONES static void interpolate(const float *restrict vertices, float part, float first, float step, int cells,
                                      bool periodic, int count, float *restrict out)
{
    const int below = cells + 1;
    const float end = (float)cells, turns = periodic ? 1.0f / end : 0.0f;
    for (int i = 0; i < count; i++) {
        float place = first + (float)i * step;
        place = vector_clamp(place - floorf(place * turns) * end, 0.0f, end);
        int cell = (int)place;
        cell = cell < cells ? cell : cells - 1;
        float u = place - (float)cell;
        int second = u + part > 1.0f;
        float at_right = second ? 1.0f - part : u, at_below = second ? 1.0f - u : part;
        int corner = second ? cell + below + 1 : cell;
        float at_corner = vector_positive(1.0f - at_right - at_below);
        out[i] = at_corner * vertices[corner] + at_right * vertices[cell + 1] + at_below * vertices[cell + below];
    }
}

static void trace_slice(const struct light_map *mesh, const double square[3], bool periodic, int side, float *texels)
{
    int cells = mesh->side - 1;
    double step = square[2] / side;
#pragma omp parallel for
    for (int row = 0; row < side; row++) {
        float part;
        int cell = vertical_ray_locate(square[1] + (row + 0.5) * step, cells, periodic, &part);
        interpolate(mesh->texels + (size_t)cell * (size_t)mesh->side, part, (float)(square[0] + step / 2), (float)step,
                    cells, periodic, side, texels + (size_t)row * (size_t)side);
    }
}

static bool trace(void *state_, const struct light_input *input, struct light_map *map)
{
    struct vertical_ray_state *state = state_;
    int cells = count_cells(input->params, input->surface->columns, input->surface->periodic);
    const struct vertical_points points = find_vertices(input, cells);
    if (!vertical_ray_prepare(state, NULL, input) || !light_map_resize(&state->mesh, points.side, 1, 1, input->log) ||
        !vertical_ray_trace(state, input, &points, state->mesh.texels))
        return false;
    for (int slice = 0; slice < map->slices; slice++) {
        double square[3];
        find_square(input, slice, cells, square);
        trace_slice(&state->mesh, square, input->surface->periodic, map->side, light_map_slice(map, slice));
        vertical_ray_cut(input, slice, map);
    }
    return true;
}

static void draw_vertices(struct vertical_ray_state *state, struct dpl_gl *gl, const struct light_input *input,
                          int cells)
{
    const struct vertical_points points = find_vertices(input, cells);
    texture_resize(gl, &state->vertices, GL_R32F, points.side, points.side, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_draw_to(gl, &state->vertices);
    program_use(gl, &state->program);
    vertical_ray_bind(state, gl, input, &state->program, &points);
    gpu_draw_screen(gl);
}

static bool draw(void *state_, struct dpl_gl *gl, const struct light_input *input, struct gpu_texture *map)
{
    struct vertical_ray_state *state = state_;
    const struct gpu_program *program = &state->mesh_program;
    bool periodic = input->surface_gpu->periodic;
    int cells = count_cells(input->params, input->surface_gpu->texels.width, periodic);
    if (!program_ready(gl, &state->program, "light/vertex_ray.glsl", "") ||
        !program_ready(gl, &state->mesh_program, "light/vertex_ray_mesh.glsl", "") ||
        !vertical_ray_prepare(state, gl, input))
        return false;
    draw_vertices(state, gl, input, cells);
    for (int slice = 0; slice < input->slices; slice++) {
        double square[3];
        find_square(input, slice, cells, square);
        texture_draw_to_layer(gl, map, slice);
        program_use(gl, program);
        texture_bind(gl, &state->vertices, 0);
        program_int(gl, program, "vertices", 0);
        program_int(gl, program, "periodic", periodic);
        program_vec3(gl, program, "square", square);
        gpu_draw_screen(gl);
    }
    return true;
}

const struct light_technique light_vertex_ray = {
    .name = "vertex-ray",
    .summary =
        "one ray straight up from each vertex of a mesh, out of the water into a picture of the sun; no physical "
        "scale",
    .source = "Sánchez-Crespo 2003, in OpenGL",
    .params = params,
    .params_size = sizeof(struct vertical_ray),
    .state_size = sizeof(struct vertical_ray_state),
    .channels = 1,
    .vertical = true,
    .trace = trace,
    .draw = draw,
    .finish = vertical_ray_finish,
};
