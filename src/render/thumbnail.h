/* render/thumbnail.h: small pictures of the textures that a frame was made from. */
#ifndef RENDER_THUMBNAIL_H
#define RENDER_THUMBNAIL_H

#include "dapple/renderer.h"
#include "gpu/program.h"
#include "water/surface_gpu.h"

#define THUMBNAILS 3 /* normals, caustic map, the map that it is compared with */

/* All zero: none yet. */
struct thumbnails {
    struct gpu_program program;
    struct gpu_texture textures[THUMBNAILS];
};

/* Draws the index-th anew; NULL-named past the last. `other` is NULL where nothing is compared. */
struct dpl_thumbnail thumbnails_draw(struct dpl_gl *gl, struct thumbnails *thumbnails, int index,
                                     const struct surface_gpu *surface, const struct gpu_texture *map,
                                     const struct gpu_texture *other);

void thumbnails_finish(struct dpl_gl *gl, struct thumbnails *thumbnails);

#endif
