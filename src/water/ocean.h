/* water/ocean.h: the parts of the model `ocean`; ocean.c tells how they work together. */
#ifndef WATER_OCEAN_H
#define WATER_OCEAN_H

#include "base/fft.h"
#include "gpu/program.h"
#include "water/water.h"

#define OCEAN_SIDE_MAX 1024  /* of a cascade's grid */
#define OCEAN_CASCADES_MAX 4 /* the c-th repeats 4^c times along the tile */
#define OCEAN_FIELDS 3       /* height, shift along x, shift along z */

enum ocean_spectrum { OCEAN_PHILLIPS, OCEAN_JONSWAP, OCEAN_TMA };

/* Section [ocean]. */
struct ocean {
    int spectrum;          /* enum ocean_spectrum */
    double wind_speed;     /* m/s */
    double wind_direction; /* degrees */
    double fetch;          /* m */
    double peak_enhancement, spreading, smoothing, amplitude, choppiness;
    int resolution; /* a cascade's grid has 32 · 2^resolution vertices a side */
    int cascades;
};

/* The numbers that the waves follow from, time apart. */
enum { OCEAN_NUMBERS = 15 };

/* Where a point lies in the spline of a cascade, along one axis. */
struct ocean_place {
    int cell;
    double weights[4], slopes[4]; /* of the coefficients cell - 1 to cell + 2; slopes a cell */
};

/* What is kept between frames. A cascade has modes × modes waves, wave numbers in the order of a Fourier transform. */
struct ocean_state {
    double numbers[OCEAN_NUMBERS]; /* that the waves were made from */
    double size;                   /* m, of the tile */
    double choppiness;
    int side, modes, cascades; /* side = 2 · modes */
    int tiles;                 /* of four fields: one a cascade where choppy, else one for all heights */
    int pairs;                 /* of fields that are used */
    double clock;              /* in seconds, or in loops */

    float (*amplitudes)[2]; /* m, complex; cascades × modes² */
    double *turns;          /* of a wave in a unit of the clock; likewise */
    float (*moved)[2];      /* amplitudes of one cascade now; modes² */
    float *spectrum;        /* of the fields now; tiles × modes² × 4: two pairs, each a complex number */
    float (*grids)[2];      /* spline coefficients of the fields; pairs × side² × 2 */
    struct fft *fft;

    struct ocean_place *columns;                /* of the surface's own vertices; vertices × cascades */
    int vertices, column_cascades, column_side; /* that they are for */

    struct gpu_program fft_program, texel_program, shift_program;
    struct gpu_texture modes_texture, passes[2]; /* tiles one below the other */
};

/* ocean_spectrum.c: variance density of heights by wave number, m⁴; waves travel towards (kx, kz), in 1/m. */
double ocean_density(const struct ocean *ocean, double depth, double kx, double kz);

/* ω of the linear dispersion relation, rad/s; `group`: dω/dk, m/s, NULL where nobody asks. */
double ocean_frequency(double k, double depth, double *group);

/* ocean_waves.c: brings the state's waves, `spectrum` and `grids` to the setup and the time. Those who draw on the GPU
 * pay for the grids too, so that any thread can ask for points without a lock: less than a millisecond where the
 * numbers are the defaults, 10 ms for four choppy cascades of 256². */
bool ocean_waves_prepare(struct ocean_state *state, const struct water_setup *setup, double time,
                         const struct dpl_log *log);
void ocean_waves_finish(struct ocean_state *state);

/* Cells of the c-th cascade's grid along the tile. */
int ocean_cells(const struct ocean_state *state, int cascade);

/* ocean_surface.c: the surface from the grids; `vertices`: a side, of the surfaces that are evaluated. */
bool ocean_surface_prepare(struct ocean_state *state, int vertices, const struct dpl_log *log);
void ocean_surface_finish(struct ocean_state *state);
void ocean_surface_evaluate(const struct ocean_state *state, struct surface *surface);
void ocean_surface_sample(const struct ocean_state *state, struct water_points *points);

/* ocean_gpu.c: the surface's textures from the spectrum. */
bool ocean_gpu_draw(struct ocean_state *state, struct dpl_gl *gl, int side, struct gpu_texture *texels,
                    struct gpu_texture *shifts);
void ocean_gpu_finish(struct ocean_state *state, struct dpl_gl *gl);

#endif
