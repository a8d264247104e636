/* water/water.h: the interface of a water model, and the list of them. One file per model.
 *
 * A new model is a copy of the shortest file in this folder and one line in water.c. */
#ifndef WATER_WATER_H
#define WATER_WATER_H

#include "base/param.h"
#include "gpu/texture.h"
#include "optics/water_types.h"
#include "water/surface.h"

#define WATER_GRAVITY 9.81 /* m/s² */
#define WATER_MODELS_MAX 16
#define WATER_WAVES_MAX 64
#define WATER_CONSTANTS_MAX 128 /* vec4 constants of a model's shader */

/* Section [water]: which model makes the waves, and what the water is. */
struct water_medium {
    int model;            /* index into water_models */
    double ior;           /* refractive index of green light */
    double dispersion;    /* refractive index of blue light less that of red */
    int type;             /* optics/water_types.h */
    double absorption[3]; /* 1/m, red green blue, of type 0; so are the next */
    double scattering[3]; /* 1/m */
    double anisotropy;    /* mean cosine of the angle at which particles scatter, of all types */
    double roughness;     /* root mean square of slopes too fine for the grid */
};
extern const struct dpl_param water_medium_params[];

/* What the water does to light: as its type says, or by the medium's own numbers. */
struct optics_water water_optics(const struct water_medium *medium);

/* The refractive indices of red, green and blue light. */
void water_refractive_indices(const struct water_medium *medium, double ior[3]);

/* One wave of `sines`: a section `[wave.N]` of scene text. */
struct wave {
    int cycles[2];    /* whole waves across the tile, along x and z */
    double amplitude; /* m */
    double phase;     /* degrees */
    double period;    /* s; 0: from the dispersion relation */
    double steepness; /* 0: a sine; 1: a cusp at the crest, where the wave is alone */
};
extern const struct dpl_param water_wave_params[];

/* Section [sphere]: a ball that displaces the water of models that can be disturbed. */
struct water_sphere {
    double radius; /* m; 0: none */
    double position[3];
    bool gravity; /* it swims and sinks from there on, instead of staying */
};
extern const struct dpl_param water_sphere_params[];

/* Something that falls into the water of models that can be disturbed. */
struct water_drop {
    double x, z, radius, height; /* m; the height may be negative */
};

/* What models keep between frames, each its own state. All zero: nothing yet. */
struct water_memory {
    void *states[WATER_MODELS_MAX]; /* as water_models; NULL: has none, or has not been used */
};

/* What a model may need to know of the scene; filled by the scene, valid during the call. */
struct water_setup {
    double size;  /* m, side of the tile */
    double depth; /* m */
    double loop;  /* s; 0: does not loop */
    int mesh;     /* vertices a side that the user asks of models without a grid of their own */
    int seed;     /* start of everything random */
    const struct wave *waves;
    int wave_count;
    const struct water_sphere *sphere;
    const struct water_drop *drops; /* that fall now */
    int drop_count;
    const void *params;            /* the model's own struct */
    const void *const *all_params; /* those of every model, as water_models */
    struct water_memory *memory;   /* NULL: models that keep something cannot be used */
};

/* The grid that a model's surface has. */
struct water_shape {
    int side;      /* vertices */
    bool periodic; /* the left and right edges join, and the upper and lower */
    bool choppy;   /* points move horizontally too: `evaluate` and `sample` fill shifts, `sample` areas */
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
    size_t state_size; /* kept between frames, starts zeroed; 0: none */
    bool disturbed;    /* drops and the sphere move it */

    /* The grid; 0 vertices where the setup names no mesh and the model has no grid of its own. Needs no state. */
    struct water_shape (*shape)(const struct water_setup *setup);
    /* Brings the state to `time`; comes before the functions below. NULL: there is nothing to prepare. */
    bool (*prepare)(void *state, const struct water_setup *setup, double time, const struct dpl_log *log);
    /* Fills heights and slopes of a surface that has that grid, at `time` seconds. NULL: by `sample`. */
    void (*evaluate)(void *state, const struct water_setup *setup, double time, struct surface *surface);
    /* The surface at any points, exact where the model is. May be called by several threads at once. */
    void (*sample)(const void *state, const struct water_setup *setup, double time, struct water_points *points);
    /* Where the scene's sphere now is. NULL: where the scene has put it. */
    void (*sphere)(const void *state, const struct water_setup *setup, double center[3]);

    /* The same on the GPU; all NULL: the grid is evaluated on the CPU and uploaded. Either a shader file that defines
     * `vec3 water(vec2 xz)` over `uniform vec4 constants[]` (and, for a choppy model, `vec2 water_shift(vec2 xz)`);
     * `constants` writes what it needs, returns how many. Or a function of its own that resizes and fills the texture
     * of heights and slopes, and that of shifts where the model is choppy. */
    const char *shader;
    int (*constants)(const struct water_setup *setup, double time, float constants[WATER_CONSTANTS_MAX][4]);
    bool (*draw)(void *state, struct dpl_gl *gl, const struct water_setup *setup, double time,
                 struct gpu_texture *texels, struct gpu_texture *shifts);
    /* Frees what the state owns and leaves it zeroed; gl is NULL where there is no OpenGL. */
    void (*finish)(void *state, struct dpl_gl *gl);
};

extern const struct water_model *const water_models[]; /* ends with NULL */

/* The i-th model's name, NULL past the last: the choices of `water.model`. */
const char *water_model_name(int i);

/* True where waves of the model `part` move the water of `model`: it is that one, or a sum that has it. */
bool water_model_has(int model, int part, const void *const *all_params);

/* Adds the water at some points to a hash (base/hash.h): what a state of its model, a file or a second model makes of
 * it.
 */
uint64_t water_hash(uint64_t value, const struct water_model *model, const struct water_setup *setup, double time);

/* The model's points; where it is not choppy, shifts are 0 and areas 1. */
void water_sample(const struct water_model *model, const struct water_setup *setup, double time,
                  struct water_points *points);

/* Fills a surface of any grid with the model's points at its vertices. */
void water_fill(const struct water_model *model, const struct water_setup *setup, double time, struct surface *surface);

/* The model's state, made where there is none yet. NULL where the model has none, or memory is short (logged). */
void *water_state(const struct water_model *model, const struct water_setup *setup, const struct dpl_log *log);

/* Readies the model for `time`: what comes before everything else that is asked of it at that time. */
bool water_prepare(const struct water_model *model, const struct water_setup *setup, double time,
                   const struct dpl_log *log);

/* Frees all states. */
void water_memory_finish(struct water_memory *memory, struct dpl_gl *gl);

/* Where the scene's sphere is at the time that the model has been readied for. */
void water_sphere_center(const struct water_model *model, const struct water_setup *setup, double center[3]);

/* Fills a surface that has the model's grid. */
void water_evaluate_grid(const struct water_model *model, const struct water_setup *setup, double time,
                         struct surface *surface);

/* Gives the surface the model's grid, heights and slopes at `time`. */
bool water_evaluate(const struct water_model *model, const struct water_setup *setup, double time,
                    struct surface *surface, const struct dpl_log *log);

#endif
