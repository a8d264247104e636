/* light/vertical_ray.h: what vertex-ray and pixel-ray share: points of the floor from which one ray each goes straight
 * up, leaves the water, and sees a place in the sky (Sánchez-Crespo, "Inexpensive Underwater Caustics Using Cg";
 * Guardado and Sánchez-Crespo in GPU Gems 1, chapter 2).
 *
 *   1. the height, or the slopes, of the water straight above a point: bilinear between the surface's vertices
 *   2. the water's normal: by central differences of heights, or from the slopes
 *   3. a ray straight up leaves by Snell's law; none does where the water throws all light back inside
 *   4. its angle to the vertical, and its direction, are a place in the picture of the sun: that is the brightness
 *
 * Brightness has no physical scale: 1 where the ray meets the sun, 0 where it meets neither sun nor halo. The vertical
 * ray moves nowhere on its way, so depth does not matter: light neither gathers nor spreads with it, and neighbours
 * know nothing of each other. Bright is where water lies level, be it a crest, which gathers light, or a trough, which
 * does not. Absorption is not in the map: all ways are vertical and, but for the waves' height, as long as under flat
 * water. */
#ifndef LIGHT_VERTICAL_RAY_H
#define LIGHT_VERTICAL_RAY_H

#include "light/light.h"
#include "light/sun_map.h"

enum vertical_normals { VERTICAL_DIFFERENCES, VERTICAL_SLOPES };

/* Parameters of both techniques; each has a table of those that it knows. */
struct vertical_ray {
    int mesh, normals;
    double sun_width, halo, falloff;
    char sun_map[DPL_PARAM_TEXT_SIZE];
};
#define VERTICAL_RAY_SUN_PARAMS                                                                                        \
    PARAM_FLOAT(struct vertical_ray, sun_width, 0.53, 0.01, 90, "degrees",                                             \
                "width of its own sun, which stands straight overhead, as the method assumes, wherever [sun] is"),     \
        PARAM_FLOAT(struct vertical_ray, halo, 10, 1, 100, "sun widths",                                               \
                    "width of the halo, and of sun_map; 1 = the bare sun"),                                            \
        PARAM_FLOAT(struct vertical_ray, falloff, 2, 0.1, 16, "",                                                      \
                    "power of the loss from the sun's edge to that of the halo"),                                      \
        PARAM_TEXT(struct vertical_ray, sun_map,                                                                       \
                   "picture of the sun and its halo, square; empty = a disc and its halo")

/* A square of points on the floor, row by row. */
struct vertical_points {
    int side;     /* points */
    double x, z;  /* m, the first */
    double step;  /* m, between neighbours */
    double apart; /* m, from a point to where heights are taken for differences, both ways */
    enum vertical_normals normals;
};

/* Points along one axis, on the surface's grid: where heights are taken before, at and after each. */
struct vertical_axis {
    int count;
    int *cells[3];
    float *inside[3]; /* 0 to 1 across the cell */
    float *per_meter; /* 1 / the distance between the first and the last of the three */
};

struct vertical_ray_state {
    struct vertical_ray params; /* that the picture was made for */
    bool ready, uploaded;       /* the picture is; the texture too */
    struct sun_picture sun;
    /* GPU */
    struct gpu_program program, mesh_program;
    struct gpu_texture sun_texture, vertices;
    /* CPU */
    struct vertical_axis columns, rows;
    int grid_columns, threads;
    float *room;           /* for each thread: blended rows of the surface, slopes of a row of points */
    struct light_map mesh; /* brightness of the mesh's vertices */
};

/* Brings the picture of the sun up to date with the parameters, and on a GPU its texture too; `gl` may be NULL. */
bool vertical_ray_prepare(struct vertical_ray_state *state, struct dpl_gl *gl, const struct light_input *input);

/* Writes the brightness of points on the CPU. */
bool vertical_ray_trace(struct vertical_ray_state *state, const struct light_input *input,
                        const struct vertical_points *points, float *brightness);

/* Makes the texels of a map dark that have no water above them. */
void vertical_ray_cut(const struct light_input *input, int slice, const struct light_map *map);

/* Sets the uniforms of light/vertical_ray.glsl in the program in use. */
void vertical_ray_bind(const struct vertical_ray_state *state, struct dpl_gl *gl, const struct light_input *input,
                       const struct gpu_program *program, const struct vertical_points *points);

/* The cell, of so many on an axis, that a place in cells from its start lies in, and how far in; periodic places are
 * wrapped round, others moved to the nearer end. */
int vertical_ray_locate(double place, int cells, bool periodic, float *inside);

/* Finish function of both techniques. */
void vertical_ray_finish(void *state, struct dpl_gl *gl);

#endif
