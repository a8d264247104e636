/* light/coverage_gpu.h: the GPU's half of the technique `coverage`.
 *
 *     surface ─→ rays ─→ cells, added up on one receiver ─→ sharp (a point sun's light) ─→ disc ─→ layer of the map
 */
#ifndef LIGHT_COVERAGE_GPU_H
#define LIGHT_COVERAGE_GPU_H

#include "gpu/program.h"
#include "light/detail.h"
#include "light/light.h"

#define COVERAGE_FINEST 3 /* times the map's side, of a sharp map */
#define COVERAGE_LEVELS                                                                                                \
    (14 + COVERAGE_FINEST - 1) /* sides of the sharp map: LIGHT_MAP_MAX, half of it, … 1; finer ones */
#define COVERAGE_TAPS 192      /* texels that a footprint touches; as in coverage_disc.glsl */

/* The footprint of the sun's disc on one receiver: weights of the texels of the sharp map. */
struct coverage_disc {
    int map_side;         /* texels of the map that it was made for; 0: not made */
    double covariance[3]; /* likewise, in texels of the map: xx, xz, zz */
    int fineness, level,
        side;  /* the sharp map's side: the map's times the fineness, halved `level` times, rounded up */
    int count; /* of taps; 0: nothing is smeared */
    float taps[COVERAGE_TAPS][4]; /* x, z, weight */
};

/* All zero: none yet. */
struct coverage_gpu {
    struct gpu_program rays_program, resolve_program, fold_program, disc_program, add_program, points_program;
    struct gpu_texture rays[3];                  /* one, or one for each of red green blue */
    bool computed;                               /* by compute shaders; otherwise by blending */
    GLuint light;                                /* whole numbers: three for each texel */
    int light_side;                              /* texels a side that it holds */
    struct gpu_texture blended[COVERAGE_LEVELS]; /* in place of `light`, where there is no compute: with a margin */
    struct gpu_texture sharp[COVERAGE_LEVELS];   /* a point sun's light */
    struct coverage_disc discs[LIGHT_SLICES_MAX];
};

bool coverage_gpu_draw(struct coverage_gpu *gpu, struct dpl_gl *gl, const struct light_input *input,
                       const struct light_samples *samples, struct gpu_texture *map);

/* What every vertex does with light of that index, by the program of coverage_rays.glsl; resizes `rays`. */
void coverage_gpu_draw_rays(struct dpl_gl *gl, const struct gpu_program *program, const struct light_input *input,
                            double ior, struct gpu_texture *rays);

void coverage_gpu_finish(struct coverage_gpu *gpu, struct dpl_gl *gl);

/* Brings the footprint up to date. */
void coverage_disc_make(struct coverage_disc *disc, int side, const double covariance[3], int fineness);

/* The fineness that a footprint of that radius, in texels of the map, has room for, at most `wanted`. */
int coverage_disc_fineness(double radius, int wanted);

#endif
