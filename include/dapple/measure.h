/* dapple/measure.h: how far one image is from another, in numbers and in colours.
 *
 * Images must be of one size and hold finite values; otherwise the reason is logged and the call fails. */
#ifndef DAPPLE_MEASURE_H
#define DAPPLE_MEASURE_H

#include "dapple/image.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A map against its reference, over all texels and channels; E: the image's value times `gain`, R: the reference's. */
struct dpl_measure {
    double error;  /* relative root mean square: sqrt(Σ(E - R)² / ΣR²), without the reference's own noise */
    double p99;    /* 99th percentile of |E - R|, in units of the mean of R */
    double energy; /* mean of E / mean of R */
    double gain;   /* 1, or the one of least error */
};

/* `fit`: the image is first multiplied by the one gain that makes the error least, for techniques without a physical
 * scale. `noise`: of the reference, as dpl_renderer_noise() gives it. As it has nothing to do with the image's error,
 * its square is part of the square of what is seen, and is taken away: errors down to about a tenth of the noise are
 * known, as there are many texels. The percentile keeps it. A reference whose mean is not above 0 has no scale to
 * measure in: the call fails. */
DPL_API bool dpl_measure_map(const struct dpl_image *image, const struct dpl_image *reference, bool fit, double noise,
                             struct dpl_measure *result, const struct dpl_log *log);

/* Mean ꟻLIP (Andersson et al. 2020) of two pictures of displayable values 0 to 1 (sRGB): how different they look to one
 * who flips between them, 0 (alike) to 1. `pixels_per_degree` of the eye's view: 67 is a 0.7 m wide screen of 3840
 * pixels seen from 0.7 m. */
#define DPL_FLIP_PIXELS_PER_DEGREE 67.0
DPL_API bool dpl_measure_flip(const struct dpl_image *picture, const struct dpl_image *reference,
                              double pixels_per_degree, double *mean, const struct dpl_log *log);

/* Colours for numbers: equal steps of the number look like equal steps of colour. */
enum dpl_color_map {
    DPL_COLORS_DIFFERENCE, /* -1 blue, 0 white, 1 red */
    DPL_COLORS_MAGNITUDE,  /* 0 black, through violet and orange, 1 white */
};

/* The displayable colour (sRGB, 0 to 1) of a number; numbers outside the map's range get its end's. */
DPL_API void dpl_false_color(enum dpl_color_map map, double number, float color[3]);

/* A new image of the mean over the channels of (image × gain - reference) / range, in those colours; for
 * DPL_COLORS_MAGNITUDE of its absolute value. Returns NULL on failure; the caller destroys the image. */
DPL_API struct dpl_image *dpl_measure_colors(const struct dpl_image *image, const struct dpl_image *reference,
                                             double gain, double range, enum dpl_color_map map,
                                             const struct dpl_log *log);

#ifdef __cplusplus
}
#endif

#endif
