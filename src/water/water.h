/* water/water.h: the interface of a water model, and the list of them. One file per model.
 *
 * A new model is a copy of the shortest file in this folder and one line in water.c. */
#ifndef WATER_WATER_H
#define WATER_WATER_H

#include "base/param.h"
#include "water/surface.h"

#define WATER_WAVES_MAX 64
#define WATER_CONSTANTS_MAX 128 /* vec4 constants of a model's shader */

/* One wave of `sines`: a section `[wave.N]` of scene text. */
struct wave {
    int cycles[2];    /* whole waves across the tile, along x and z */
    double amplitude; /* m */
    double phase;     /* degrees */
    double period;    /* s; 0: from the dispersion relation */
};
extern const struct dpl_param water_wave_params[];

/* What a model may need to know of the scene; filled by the scene, valid during the call. */
struct water_setup {
    double size;  /* m, side of the tile */
    double depth; /* m */
    double loop;  /* s; 0: does not loop */
    int mesh;     /* vertices a side that the user asks of models without a grid of their own */
    const struct wave *waves;
    int wave_count;
    const void *params; /* the model's own struct */
};

struct water_model {
    const char *name;
    const char *summary;            /* one line */
    const char *source;             /* whose it is */
    const struct dpl_param *params; /* ends with PARAM_END; NULL: none */
    size_t params_size;
    bool periodic; /* its left and right edges join, and its upper and lower */

    /* Vertices a side of the grid that the model wants. */
    int (*grid)(const struct water_setup *setup);
    /* Fills heights and slopes of a surface that has that grid, at `time` seconds. */
    void (*evaluate)(const struct water_setup *setup, double time, struct surface *surface);
    /* Height and slopes at any one point, exact: what the grid is held against. */
    void (*sample)(const struct water_setup *setup, double time, double x, double z, double out[3]);

    /* The same on the GPU; NULL: the grid is evaluated on the CPU and uploaded. The shader file defines
     * `vec3 water(vec2 xz)` over `uniform vec4 constants[]`; `constants` writes what it needs, returns how many. */
    const char *shader;
    int (*constants)(const struct water_setup *setup, double time, float constants[WATER_CONSTANTS_MAX][4]);
};

extern const struct water_model *const water_models[]; /* ends with NULL */

/* The i-th model's name, NULL past the last: the choices of `water.model`. */
const char *water_model_name(int i);

/* Gives the surface the model's grid, heights and slopes at `time`. */
bool water_evaluate(const struct water_model *model, const struct water_setup *setup, double time,
                    struct surface *surface, const struct dpl_log *log);

#endif
