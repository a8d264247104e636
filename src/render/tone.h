/* render/tone.h: from the radiance that looks with linear light draw to a picture that a screen shows.
 *
 * Several samples a pixel are as many pictures, each through another place of the pixel, and their mean. */
#ifndef RENDER_TONE_H
#define RENDER_TONE_H

#include "gpu/program.h"
#include "gpu/target.h"
#include "render/frame.h"

/* All zero: none yet. */
struct tone {
    struct gpu_target radiance; /* what a look draws into */
    struct gpu_texture mean;    /* of the samples so far, where there are several */
    struct gpu_program add, show;
};

bool tone_ready(struct dpl_gl *gl, struct tone *tone, int width, int height, int samples);

/* Where in the pixel sample `index` of `count` lies, from -0.5 to 0.5 each way. */
void tone_place(int index, int count, double place[2]);

/* Takes what has been drawn into `radiance` as sample `index`, from 0. */
void tone_add(struct dpl_gl *gl, struct tone *tone, int index);

/* What the samples so far come to. */
struct gpu_texture *tone_radiance(struct tone *tone, int samples);

/* Draws that of all samples into the bound framebuffer as the frame's camera takes it, through the scene's curve,
 * encoded for the screen. */
void tone_show(struct tone *tone, const struct frame *frame);

void tone_finish(struct dpl_gl *gl, struct tone *tone);

#endif
