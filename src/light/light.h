/* light/light.h: the interface of a technique, and the list of them. One technique a file, its shaders beside it.
 *
 * A technique turns the water's surface into a caustic map: irradiance on the floor in units of what flat water would
 * give; a technique that is tuned by eye gives a brightness from 0 to 1. Whoever shows, stores or compares a map does
 * not know which technique made it. A new technique is a copy of the shortest file in this folder and one line in
 * light.c. */
#ifndef LIGHT_LIGHT_H
#define LIGHT_LIGHT_H

#include "base/param.h"
#include "gpu/texture.h"
#include "water/surface_gpu.h"

#define LIGHT_MAP_MAX 8192  /* texels a side */
#define LIGHT_MESH_MAX 4096 /* vertices a side */

/* Sections [sun], [water] and [caustics]: what every technique may need to know. */
struct light_sun {
    double elevation, azimuth, angular_radius; /* degrees */
};
struct light_medium {
    int model; /* index into water_models */
    double ior;
    double absorption[3]; /* 1/m */
};
struct light_settings {
    int technique;     /* index into light_techniques */
    int map, mesh;     /* texels, vertices a side */
    double depth_bias; /* m */
    int blur;
};
extern const struct dpl_param light_sun_params[], light_medium_params[], light_settings_params[];

/* One task for a technique. Valid during the call. */
struct light_input {
    const struct surface *surface;         /* for trace(); its grid is filled */
    const struct surface_gpu *surface_gpu; /* for draw(); its texture is filled */
    double depth;                          /* m, rest surface to floor */
    const struct light_sun *sun;
    const struct light_medium *medium;
    const struct light_settings *settings;
    const void *params; /* the technique's own struct */
    const struct dpl_log *log;
};

/* A caustic map on the CPU. Row 0 is the smallest z. All zero: none yet. */
struct light_map {
    int side, channels;
    float *texels; /* side × side × channels */
};

struct light_technique {
    const char *name;
    const char *summary;            /* one line */
    const char *source;             /* whose it is */
    const struct dpl_param *params; /* ends with PARAM_END; NULL: none */
    size_t params_size;
    size_t state_size; /* kept between frames, starts zeroed */
    int channels;      /* of its map: 1 grey, 3 red green blue */

    /* Fills the map on the CPU. NULL: only on the GPU. The map has its size. */
    bool (*trace)(void *state, const struct light_input *input, struct light_map *map);
    /* Fills the texture on the GPU. NULL: only on the CPU. The texture has its size. */
    bool (*draw)(void *state, struct dpl_gl *gl, const struct light_input *input, struct gpu_texture *map);
    /* Frees what the state owns and leaves it zeroed; gl is NULL where there is no OpenGL. */
    void (*finish)(void *state, struct dpl_gl *gl);
};

extern const struct light_technique *const light_techniques[]; /* ends with NULL */

/* The i-th technique's name, NULL past the last: the choices of `caustics.technique`. */
const char *light_technique_name(int i);

/* Makes the map that size, or leaves it where it already is. */
bool light_map_resize(struct light_map *map, int side, int channels, const struct dpl_log *log);
void light_map_finish(struct light_map *map);

#endif
