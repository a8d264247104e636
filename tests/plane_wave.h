/* tests/plane_wave.h: the light below a plane wave, worked out: the way of each ray along one axis, and the sum over
 * all folds. Laws are written a second time, in angles. */
#ifndef TESTS_PLANE_WAVE_H
#define TESTS_PLANE_WAVE_H

#include "optics/sun.h"

#include <math.h>
#include <string.h>

/* A cos(k x) */
struct plane_wave {
    double size; /* m, of the tile */
    int cycles;  /* along x */
    double amplitude, ior, absorption;
};

/* A ray from a point of the wave. */
struct way {
    double x, weight; /* where it meets the receiver; before division by what flat water gives */
};

static inline double fresnel(double in, double out)
{
    double across = sin(in - out) / sin(in + out), along = tan(in - out) / tan(in + out);
    return (across * across + along * along) / 2;
}

static inline struct way way_of(const struct plane_wave *wave, const double light[3], double amplitude, double x,
                                double y)
{
    double k = 2 * M_PI * wave->cycles / wave->size, height = amplitude * cos(k * x);
    double slope = -amplitude * k * sin(k * x), length = hypot(slope, 1);
    double normal[3] = {-slope / length, 1 / length, 0}, direction[3];
    double in = fmax(acos(light[0] * normal[0] + light[1] * normal[1]), 1e-5), out = asin(sin(in) / wave->ior);
    for (int c = 0; c < 3; c++) {
        double along = (light[c] - cos(in) * normal[c]) / sin(in);
        direction[c] = y < 0 ? -cos(out) * normal[c] - sin(out) * along : cos(in) * normal[c] - sin(in) * along;
    }
    double way = (y - height) / direction[1], share = y < 0 ? 1 - fresnel(in, out) : fresnel(in, out);
    double absorbed = y < 0 ? exp(-wave->absorption * way) : 1;
    return (struct way){x + direction[0] * way, cos(in) * length * share * absorbed};
}

/* Adds to each column of texels the light of one direction: over each small step of x it is spread evenly between the
 * ends, which sums weight / |dX/dx| over all folds. Returns what flat water gives. */
static inline double wave_add(const struct plane_wave *wave, const double light[3], double y, int side, double *columns)
{
    const int steps = 1000;
    double size = wave->size;
    struct way last = way_of(wave, light, wave->amplitude, 0, y);
    for (int i = 1; i <= steps; i++) {
        struct way next = way_of(wave, light, wave->amplitude, size * i / steps, y);
        double from = (fmin(last.x, next.x) / size + 0.5) * side, to = (fmax(last.x, next.x) / size + 0.5) * side;
        double flux = (last.weight + next.weight) / 2 * side / steps;
        for (int texel = (int)floor(from); texel <= (int)floor(to); texel++)
            columns[((texel % side) + side) % side] +=
                flux * (to > from ? (fmin(to, texel + 1) - fmax(from, texel)) / (to - from) : 1);
        last = next;
    }
    return way_of(wave, light, 0, 0, y).weight;
}

/* The light of each column of `side` texels at height y, in units of flat water's: the mean over the sun's disc. */
static inline void wave_columns(const struct plane_wave *wave, const struct optics_sun *sun, double y, int side,
                                double *columns)
{
    const struct optics_disc disc = optics_sun_disc(sun);
    int places = sun->angular_radius > 0 ? 300 : 1;
    double flat = 0;
    memset(columns, 0, (size_t)side * sizeof *columns);
    for (int i = 0; i < places; i++) { /* a spiral of equal areas */
        double radius = sqrt((i + 0.5) / places), turn = 2.399963 * i, light[3];
        optics_disc_place(&disc, (const double[2]){radius * cos(turn), radius * sin(turn)}, light);
        flat += wave_add(wave, places > 1 ? light : disc.middle, y, side, columns);
    }
    for (int i = 0; i < side; i++)
        columns[i] /= flat;
}

#endif
