/* Wallace 2016, "Rendering Realtime Caustics in WebGL": the wavefront mesh.
 *
 *   1. a mesh lies on the water; each of its vertices is a ray of light
 *   2. each vertex moves to where its ray, refracted or thrown back by the water, meets the receiver
 *   3. a triangle between them is drawn there, brighter by as much as it became smaller: its area before to its area
 *      after
 *
 * The ratio of areas is that of the triangle's texels in the map, by the derivatives of both places along the map's
 * axes; or that of its three vertices, which a geometry shader sees, or which every vertex brings along. Texels are
 * tested at their centres: triangles smaller than texels hit some and miss others, right in the mean. The light comes
 * from the middle of the sun, with the refractive index of green light for all colours. */
#include "light/wavefront.h"

#include <math.h>
#include <stdlib.h>

static const char *variant_name(int i)
{
    static const char *const names[] = {"derivatives", "geometry", "neighbours", NULL};
    return names[i];
}

static const char *area_name(int i)
{
    static const char *const names[] = {"determinant", "lengths", NULL};
    return names[i];
}

static const char *folds_name(int i)
{
    static const char *const names[] = {"add", "overwrite", NULL};
    return names[i];
}

static const struct dpl_param params[] = {
    PARAM_CHOICE(struct wavefront, variant, WAVEFRONT_DERIVATIVES, variant_name,
                 "who measures a triangle: its texels' derivatives, a geometry shader, or vertices that bring their "
                 "neighbours along (the CPU has one way for all)"),
    PARAM_CHOICE(struct wavefront, area, WAVEFRONT_DETERMINANT, area_name,
                 "how: exactly, or by the product of the derivatives' lengths, as Wallace's demo, which is never less"),
    PARAM_CHOICE(struct wavefront, folds, WAVEFRONT_ADD, folds_name,
                 "where sheets of light overlap: their sum, or the one drawn last, as Wallace's demo"),
    PARAM_INT(struct wavefront, mesh, 0, 0, LIGHT_MESH_MAX, "cells",
              "side of the mesh; 0 = as the surface's grid; Wallace's demo has 200"),
    PARAM_BOOL(struct wavefront, weights, true,
               "true: light by projected area, Fresnel's share and absorption; false: the ratio of areas alone, as "
               "Wallace's demo"),
    PARAM_FLOAT(struct wavefront, most, 64, 1, 16384, "",
                "largest ratio of areas of one triangle: less sparkle at folds, less light"),
    PARAM_END,
};

struct wavefront_receiver wavefront_receiver_find(const struct light_input *input, int slice, int side, int cells,
                                                  bool periodic)
{
    const struct ray_window *window = input->windows + slice;
    double sun[3], height = input->receivers[slice], size = input->setup->size;
    optics_sun_direction(input->sun, sun);
    struct wavefront_receiver receiver = {
        .height = height,
        .flat = coverage_flat_water(sun, input->medium->ior, height > 0),
        .scale = side / window->side,
        .cell = size / cells * side / window->side,
        .period = periodic ? side : 0,
    };
    const double farthest = 1e7; /* texels: whatever lies there is not seen */
    const double first[2] = {-size / 2 - window->x + receiver.flat.u * height,
                             -size / 2 - window->z + receiver.flat.v * height}; /* m */
    for (int axis = 0; axis < 2; axis++) {
        double offset = first[axis] * receiver.scale;
        if (periodic)
            offset -= floor(offset / receiver.period) * receiver.period;
        receiver.offset[axis] = fmin(fmax(offset, -farthest), farthest);
    }
    struct optics_water water = water_optics(input->medium);
    for (int c = 0; c < 3 && height < 0; c++)
        receiver.absorption[c] = water.absorption[c];
    return receiver;
}

static void finish(void *state_, struct dpl_gl *gl)
{
    struct wavefront_state *state = state_;
    if (gl)
        wavefront_gpu_finish(state, gl);
    wavefront_cpu_finish(state);
    *state = (struct wavefront_state){0};
}

const struct light_technique light_wavefront = {
    .name = "wavefront",
    .summary = "a mesh of rays drawn where they arrive, each triangle by the change of its area",
    .source = "Wallace 2016",
    .params = params,
    .params_size = sizeof(struct wavefront),
    .state_size = sizeof(struct wavefront_state),
    .channels = 3,
    .physical = true,
    .energy = 0.1,
    .reflects = true,
    .trace = wavefront_trace,
    .draw = wavefront_draw,
    .finish = finish,
};
