/* water/water.h: the interface of a water model, and the list of them. One file per model.
 *
 * A new model is a copy of the shortest file in this folder and one line in water.c. */
#ifndef WATER_WATER_H
#define WATER_WATER_H

#include "base/param.h"
#include "water/surface.h"

#define WATER_WAVES_MAX 64
#define WATER_CONSTANTS_MAX 128 /* vec4 constants of a model's shader */

/* Section [water]: which model makes the waves, and what the water is. */
struct water_medium {
    int model;            /* index into water_models */
    double ior;           /* refractive index of green light */
    double dispersion;    /* refractive index of blue light less that of red */
    double absorption[3]; /* 1/m, red green blue */
};
extern const struct dpl_param water_medium_params[];

/* The refractive indices of red, green and blue light. */
void water_refractive_indices(const struct water_medium *medium, double ior[3]);

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

/* Points of the surface: `count` numbers in each array. */
struct water_points {
    int count;
    const double *x, *z;       /* m, of the point at rest */
    double *height;            /* m */
    double *slope_x, *slope_z; /* of the surface where the point is now */
    double *shift_x, *shift_z; /* m, horizontally from where it rests */
    double *area;              /* of a small piece of surface seen from above, to its area at rest */
};

struct water_model {
    const char *name;
    const char *summary;            /* one line */
    const char *source;             /* whose it is */
    const struct dpl_param *params; /* ends with PARAM_END; NULL: none */
    size_t params_size;
    bool periodic; /* its left and right edges join, and its upper and lower */
    bool choppy;   /* its points move horizontally too: `evaluate` and `sample` fill shifts */

    /* Vertices a side of the grid that the model wants. */
    int (*grid)(const struct water_setup *setup);
    /* Fills heights and slopes of a surface that has that grid, at `time` seconds. */
    void (*evaluate)(const struct water_setup *setup, double time, struct surface *surface);
    /* The surface at any points, exact where the model is. May be called by several threads at once. */
    void (*sample)(const struct water_setup *setup, double time, struct water_points *points);

    /* The same on the GPU; NULL: the grid is evaluated on the CPU and uploaded. The shader file defines
     * `vec3 water(vec2 xz)` over `uniform vec4 constants[]`; `constants` writes what it needs, returns how many. */
    const char *shader;
    int (*constants)(const struct water_setup *setup, double time, float constants[WATER_CONSTANTS_MAX][4]);
};

extern const struct water_model *const water_models[]; /* ends with NULL */

/* The i-th model's name, NULL past the last: the choices of `water.model`. */
const char *water_model_name(int i);

/* The model's points; where it is not choppy, shifts are 0 and areas 1. */
void water_sample(const struct water_model *model, const struct water_setup *setup, double time,
                  struct water_points *points);

/* Gives the surface the model's grid, heights and slopes at `time`. */
bool water_evaluate(const struct water_model *model, const struct water_setup *setup, double time,
                    struct surface *surface, const struct dpl_log *log);

#endif
