/* light/light.h: the interface of a technique, and the list of them. One technique a file, its shaders beside it.
 *
 * A technique turns the water's surface into caustic maps, one for each height that it is asked for: irradiance on a
 * horizontal receiver there in units of what flat water would give. Receivers below the surface get refracted light,
 * those above it light that the surface throws back. A technique that is tuned by eye has no such scale. Whoever shows,
 * stores or compares a map does not know which technique made it. A new technique is a copy of the shortest file in
 * this folder, pixel_ray.c, and its name in light.c. */
#ifndef LIGHT_LIGHT_H
#define LIGHT_LIGHT_H

#include "base/param.h"
#include "dapple/image.h"
#include "gpu/texture.h"
#include "optics/sun.h"
#include "reference/ray.h"
#include "water/surface_gpu.h"

#define LIGHT_MAP_MAX 8192  /* texels a side */
#define LIGHT_MESH_MAX 4096 /* vertices a side */
#define LIGHT_SLICES_MAX 64
#define LIGHT_TECHNIQUES_MAX 16

/* Section [caustics]: what every technique may need to know. */
enum light_window { LIGHT_WINDOW_TILE, LIGHT_WINDOW_LIGHT };
struct light_settings {
    int technique;           /* index into light_techniques */
    int map, mesh;           /* texels, vertices a side */
    double error;            /* per cent, wanted */
    int window;              /* enum light_window */
    double margin;           /* sides of the tile */
    int slices;              /* receivers below the surface */
    double ceiling;          /* m above the rest surface, of a receiver there; 0: none */
    int reflected_slices;    /* receivers above the surface, beside those below it */
    double reflected_height; /* m above the rest surface, of the highest of them */
    double depth_bias;       /* m */
    int blur;
};
extern const struct dpl_param light_settings_params[];

/* Told after each step of a technique that refines its map, with the share that is done, 0 to 1. Returns false to be
 * content with the map as it then is. */
struct light_progress {
    bool (*step)(void *user, double done); /* NULL: goes on to the end */
    void *user;
};

/* One task for a technique. Valid during the call. */
struct light_input {
    const struct surface *surface;         /* for trace(); its grid is filled */
    const struct surface_gpu *surface_gpu; /* for draw(); its texture is filled */
    const struct water_model *model;       /* that made both; for who wants points beside the grid's */
    const struct water_setup *setup;
    double time;                      /* s */
    const double *receivers;          /* m, y of each slice of the map, never 0: below the surface or above it */
    int slices;                       /* 1 to LIGHT_SLICES_MAX */
    const struct ray_window *windows; /* of each receiver, that its map shows; that of periodic water is the tile */
    const struct optics_sun *sun;
    const struct water_medium *medium;
    const struct light_settings *settings;
    int seed; /* of techniques that leave something to chance */
    struct light_progress progress;
    const void *params; /* the technique's own struct */
    const struct dpl_log *log;
};

/* Caustic maps on the CPU, a slice each receiver. Row 0 is the smallest z. All zero: none yet. */
struct light_map {
    int side, channels, slices;
    float *texels; /* slices × side × side × channels */
    double noise;  /* RMS of what chance adds, in units of the map's RMS; 0: none, or not known */
};

struct light_technique {
    const char *name;
    const char *summary;            /* one line */
    const char *source;             /* whose it is */
    const struct dpl_param *params; /* ends with PARAM_END; NULL: none */
    size_t params_size;
    size_t state_size; /* kept between frames, starts zeroed */
    int channels;      /* of its map: 1 grey, 3 red green blue */
    bool physical;     /* its map is irradiance in units of flat water */
    double energy;     /* of a physical one: how far, at its defaults, the mean of a periodic map may be off, a share */
    bool reflects;     /* serves receivers above the surface too */
    bool vertical;     /* looks straight up: gets choppy water as it is above each place, without shifts */
    bool refines;      /* its map gets better while it is called again with the same input */

    /* Fills the map on the CPU. NULL: only on the GPU. The map has its size. */
    bool (*trace)(void *state, const struct light_input *input, struct light_map *map);
    /* Fills the texture, a layer each receiver, on the GPU. NULL: only on the CPU. The texture has its size. */
    bool (*draw)(void *state, struct dpl_gl *gl, const struct light_input *input, struct gpu_texture *map);
    /* Frees what the state owns and leaves it zeroed; gl is NULL where there is no OpenGL. */
    void (*finish)(void *state, struct dpl_gl *gl);
};

extern const struct light_technique *const light_techniques[]; /* ends with NULL */

/* The i-th technique's name, NULL past the last: the choices of `caustics.technique`. */
const char *light_technique_name(int i);

/* Makes the map that size, or leaves it where it already is. */
bool light_map_resize(struct light_map *map, int side, int channels, int slices, const struct dpl_log *log);

/* The texels of one slice. */
float *light_map_slice(const struct light_map *map, int slice);

/* One slice as a new image of three channels. */
struct dpl_image *light_map_image(const struct light_map *map, int slice, const struct dpl_log *log);
void light_map_finish(struct light_map *map);

#endif
