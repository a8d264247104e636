/* compare.h: the scene's technique beside another one, and what was measured of the two. */
#ifndef VIEWER_COMPARE_H
#define VIEWER_COMPARE_H

#include "dapple/renderer.h"

struct viewer_compare {
    struct dpl_compare shown;
    bool measured; /* what follows is of the last picture, or of one shortly before */
    struct dpl_measure measure;
    double noise;        /* of the other technique's map, as dpl_renderer_noise() */
    double next_measure; /* s, real time */
    double ends;         /* s, real time: until then a technique may refine its map for this frame */
    double (*real_time)(void);
};

/* Compares nothing yet, with the reference. */
void compare_start(struct viewer_compare *compare, struct dpl_renderer *renderer, double (*real_time)(void));

/* Before a frame: gives techniques that refine their maps a few hundredths of a second for it. */
void compare_begin_frame(struct viewer_compare *compare, struct dpl_renderer *renderer);

/* After a frame; `drawn`: there is a picture. */
void compare_end_frame(struct viewer_compare *compare, struct dpl_renderer *renderer, bool drawn);

#endif
