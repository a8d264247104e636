/* light/random_caustics.h: frames of a loop of caustics from random waves, by wave theory. */
#ifndef LIGHT_RANDOM_CAUSTICS_H
#define LIGHT_RANDOM_CAUSTICS_H

#include "base/fft.h"

/* All that the frames depend on. */
struct random_caustics_recipe {
    int side, frames, seed;
    int colors;         /* wavelengths that are averaged */
    double tile;        /* m */
    double loop;        /* s */
    double correlation; /* m, length over which the correlation of heights falls to 1/e */
    double height;      /* m, RMS */
    double depth;       /* m, of the floor */
    double ior;
    double wavelength; /* m, the shortest of those averaged; 0: the shortest that the texels hold */
};

/* All zero: none yet. */
struct random_caustics {
    struct random_caustics_recipe recipe;
    struct fft *forward, *inverse;
    float (*grid)[2];
    float *heights;                     /* m */
    float *amplitudes, *phases, *turns; /* of each wave: m; whole turns at the start, and a loop */
};

/* Readies what all frames share. */
bool random_caustics_begin(struct random_caustics *caustics, const struct random_caustics_recipe *recipe,
                           const struct dpl_log *log);

/* Fills `heights`, side × side, for one frame. */
void random_caustics_heights(struct random_caustics *caustics, int frame);

/* One frame of light, side × side, whose mean is 1. */
void random_caustics_light(struct random_caustics *caustics, int frame, float *light);

/* The shortest wavelength averaged, m. */
double random_caustics_wavelength(const struct random_caustics_recipe *recipe);

void random_caustics_finish(struct random_caustics *caustics);

#endif
