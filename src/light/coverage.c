/* Every cell of the surface, seen from the sun, throws its light on an exactly known part of every texel. */
#include "light/coverage_gpu.h"

static bool draw(void *state, struct dpl_gl *gl, const struct light_input *input, struct gpu_texture *map)
{
    return coverage_gpu_draw(state, gl, input, map);
}

static void finish(void *state, struct dpl_gl *gl)
{
    if (gl)
        coverage_gpu_finish(state, gl);
}

const struct light_technique light_coverage = {
    .name = "coverage",
    .summary = "every cell's refracted light, by the exact area of each texel that it covers",
    .source = "this project",
    .state_size = sizeof(struct coverage_gpu),
    .channels = 3,
    .physical = true,
    .reflects = true,
    .draw = draw,
    .finish = finish,
};
