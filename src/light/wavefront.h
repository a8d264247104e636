/* light/wavefront.h: what the CPU's and the GPU's half of the technique share. */
#ifndef LIGHT_WAVEFRONT_H
#define LIGHT_WAVEFRONT_H

#include "light/coverage.h"
#include "light/light.h"
#include "light/triangles.h"

enum wavefront_variant { WAVEFRONT_DERIVATIVES, WAVEFRONT_GEOMETRY, WAVEFRONT_NEIGHBOURS, WAVEFRONT_VARIANTS };
enum wavefront_area { WAVEFRONT_DETERMINANT, WAVEFRONT_LENGTHS };
enum wavefront_folds { WAVEFRONT_ADD, WAVEFRONT_OVERWRITE };

/* Section [wavefront]. */
struct wavefront {
    int variant, area, folds;
    int mesh; /* cells a side; 0: as the surface */
    bool weights;
    double most; /* ratio of areas: at a fold an image has none, and the ratio no end */
};

/* A vertex of the mesh on one receiver. */
struct wavefront_vertex {
    float moved[2]; /* texels, from where flat water has it */
    float light[3]; /* weight, red green blue */
};

struct wavefront_state {
    /* CPU */
    struct surface mesh; /* where it has not the surface's own vertices */
    struct coverage_rays rays;
    struct wavefront_vertex *vertices; /* (cells + 1)² */
    struct triangle_range *ranges;     /* cells + 1 */
    int cells;                         /* a side, that there is room for */
    /* GPU */
    struct gpu_program rays_program, programs[WAVEFRONT_VARIANTS];
    struct surface_gpu mesh_gpu; /* as `mesh`; its programs make it from the surface */
    struct gpu_texture bent;     /* of coverage_rays.glsl */
    struct light_samples samples;
};

/* A receiver as its map has it: the only place that knows where metres lie among texels. */
struct wavefront_receiver {
    double height; /* m */
    struct coverage_flat flat;
    double absorption[3]; /* 1/m, on the way to the receiver */
    double scale;         /* texels a metre */
    double cell;          /* texels of a cell in flat water */
    double offset[2];     /* texels from the map's corner to where flat water has vertex (0, 0) */
    double period;        /* texels after which the water repeats; 0: never */
};
struct wavefront_receiver wavefront_receiver_find(const struct light_input *input, int slice, int side, int cells,
                                                  bool periodic);

bool wavefront_trace(void *state, const struct light_input *input, struct light_map *map);
bool wavefront_draw(void *state, struct dpl_gl *gl, const struct light_input *input, struct gpu_texture *map);

void wavefront_cpu_finish(struct wavefront_state *state);
void wavefront_gpu_finish(struct wavefront_state *state, struct dpl_gl *gl);

#endif
