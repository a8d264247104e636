/* light/blur.h: the box blur of a finished caustic map (Collard & Mundi 2022, section 3.4): each texel becomes the mean
 * of the (2 width)² texels from `width` before it to `width` - 1 after it, along x and z. The map repeats beyond its
 * edges. */
#ifndef LIGHT_BLUR_H
#define LIGHT_BLUR_H

#include "gpu/program.h"
#include "light/light.h"

/* All zero: none yet. */
struct light_blur {
    struct gpu_program program;
    struct light_map lines; /* half done: blurred along x */
};

/* Blurs every slice of a map in place. */
bool blur_map(struct light_blur *blur, struct light_map *map, int width, const struct dpl_log *log);

/* Draws every slice, blurred, into another texture of the same size. */
bool blur_draw(struct light_blur *blur, struct dpl_gl *gl, const struct gpu_texture *from, int width,
               struct gpu_texture *to);

void blur_finish(struct light_blur *blur, struct dpl_gl *gl);

#endif
