/* Sánchez-Crespo, "Inexpensive Underwater Caustics Using Cg", in its version for pixel shaders: every texel of the map
 * sends a ray straight up. The steps are told in vertical_ray.h.
 *
 * With `normals = slopes` and `halo = 1` it is what a blog on the chapter in GPU Gems 1 describes: the water's own
 * slopes in place of differences, and a light that is hit or missed. (Slopes are exact at the surface's vertices,
 * linear between them.) */
#include "light/vertical_ray.h"

static const char *normals_name(int i)
{
    static const char *const names[] = {"differences", "slopes"};
    return i >= 0 && i < 2 ? names[i] : NULL;
}

static const struct dpl_param params[] = {
    PARAM_CHOICE(
        struct vertical_ray, normals, VERTICAL_DIFFERENCES, normals_name,
        "differences: of the heights one vertex to either side, as in the article; slopes: the water's own, as "
        "in the blog"),
    VERTICAL_RAY_SUN_PARAMS,
    PARAM_END,
};

/* The middles of the texels of a map; `vertices`: a side of the surface's grid. */
static struct vertical_points find_points(const struct light_input *input, int slice, int side, int vertices,
                                          bool periodic)
{
    const struct vertical_ray *p = input->params;
    const struct ray_window *window = input->windows + slice;
    double step = window->side / side, apart = input->setup->size / (periodic ? vertices : vertices - 1);
    return (struct vertical_points){
        side, window->x + step / 2, window->z + step / 2, step, apart, (enum vertical_normals)p->normals,
    };
}

static bool trace(void *state_, const struct light_input *input, struct light_map *map)
{
    struct vertical_ray_state *state = state_;
    if (!vertical_ray_prepare(state, NULL, input))
        return false;
    const struct surface *surface = input->surface;
    for (int slice = 0; slice < map->slices; slice++) {
        const struct vertical_points points = find_points(input, slice, map->side, surface->columns, surface->periodic);
        if (!vertical_ray_trace(state, input, &points, light_map_slice(map, slice)))
            return false;
        vertical_ray_cut(input, slice, map);
    }
    return true;
}

static bool draw(void *state_, struct dpl_gl *gl, const struct light_input *input, struct gpu_texture *map)
{
    struct vertical_ray_state *state = state_;
    if (!program_ready(gl, &state->program, "light/pixel_ray.glsl", "") || !vertical_ray_prepare(state, gl, input))
        return false;
    const struct surface_gpu *surface = input->surface_gpu;
    for (int slice = 0; slice < input->slices; slice++) {
        const struct vertical_points points =
            find_points(input, slice, map->width, surface->texels.width, surface->periodic);
        texture_draw_to_layer(gl, map, slice);
        program_use(gl, &state->program);
        vertical_ray_bind(state, gl, input, &state->program, &points);
        gpu_draw_screen(gl);
    }
    return true;
}

const struct light_technique light_pixel_ray = {
    .name = "pixel-ray",
    .summary = "one ray straight up from each texel, out of the water into a picture of the sun; no physical scale",
    .source = "Sánchez-Crespo 2003, in Cg; Guardado & Sánchez-Crespo 2004, GPU Gems 1, chapter 2",
    .params = params,
    .params_size = sizeof(struct vertical_ray),
    .state_size = sizeof(struct vertical_ray_state),
    .channels = 1,
    .vertical = true,
    .trace = trace,
    .draw = draw,
    .finish = vertical_ray_finish,
};
