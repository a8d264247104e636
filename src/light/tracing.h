/* light/tracing.h: what the techniques that follow single rays share on the CPU: the surface between its vertices, the
 * part of a receiver that a map shows, sums that do not depend on the order of adding, and numbers by chance.
 * light/tracing.glsl is its twin. */
#ifndef LIGHT_TRACING_H
#define LIGHT_TRACING_H

#include "light/light.h"
#include "reference/ray.h"

#include <stdint.h>

/* A surface, ready to be looked up at many places. */
struct tracing_surface {
    const float *texels, *shifts; /* as in struct surface */
    int columns, rows;
    bool periodic;
    double half, per_spacing; /* m, 1/m */
};
struct tracing_surface tracing_surface_of(const struct surface *surface);

/* The surface by straight lines along x and z between its vertices, at a place (m) of the surface at rest; to_light
 * stays. False beyond the edge of a bounded surface. */
bool tracing_surface_at(const struct tracing_surface *surface, double x, double z, struct ray_point *point);

/* The square of a receiver that a slice's map shows. Places on it are counted in texels from its first corner. */
struct tracing_view {
    int side;              /* texels */
    double corner[2];      /* m, x and z */
    double texels_a_meter; /* along a side */
    double period;         /* texels after which a periodic surface's light is the same; 0: never */
};
struct tracing_view tracing_view_of(const struct light_input *input, bool periodic, int side, int slice);

/* How many copies of what lies from `least` to `most` (texels) along an axis the view shows, a period apart; `first`:
 * how far the first is moved. */
int tracing_copies(const struct tracing_view *view, double least, double most, double *first);

/* Light on a view in whole numbers, three for each texel. All zero: none yet. */
struct tracing_sums {
    int side;
    uint64_t *texels;
};
/* Starts with darkness. */
bool tracing_sums_start(struct tracing_sums *sums, int side, const struct dpl_log *log);
void tracing_sums_finish(struct tracing_sums *sums);

/* Adds light to a texel; beyond the view there is none. May be called by several threads at once. */
void tracing_sums_add(struct tracing_sums *sums, int x, int z, const double light[3]);

/* The sums, each colour times its scale. */
void tracing_sums_read(const struct tracing_sums *sums, const double scale[3], float *texels);

/* Four numbers, 0 to 1 without 1, that look like chance, for four counters (pcg4d of Jarzynski & Olano 2020, "Hash
 * Functions for GPU Rendering"). */
void tracing_random(const uint32_t counters[4], double numbers[4]);

/* Colours that share a refractive index share a ray: how many at a time, 3 or 1. */
int tracing_colors_together(const struct ray_medium *rays);

#endif
