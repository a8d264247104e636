/* render/picture.h: a picture of any size: what of it is drawn at once, and how the parts are joined. */
#ifndef RENDER_PICTURE_H
#define RENDER_PICTURE_H

#include "gpu/target.h"
#include "render/camera.h"

/* All zero: the device's limits count. */
struct picture {
    int side_max; /* pixels of a tile; 0: as the device can */
    void (*progress)(void *user, int done, int tiles);
    void *user;
    void *pixels; /* of a tile on its way back from the GPU */
    size_t pixels_size;
};

/* How a picture is cut. */
struct picture_tiles {
    int width, height, side, margin; /* pixels; `margin` is drawn round each tile and then left away */
    int columns, rows;
};

/* `samples` a pixel; `margin`: how far, in pixels, a look's filters reach across the picture. A picture that the device
 * can draw at once is one tile. */
struct picture_tiles picture_cut(const struct picture *picture, const struct dpl_gl *gl, int width, int height,
                                 int samples, int margin);

/* What is drawn for the index-th tile. */
struct camera_view picture_view(const struct picture_tiles *tiles, int index);

/* Reads the index-th tile, which has been drawn into the texture, bytes or floats, into its place of the image. */
bool picture_read(struct picture *picture, struct gpu_texture *texture, struct dpl_gl *gl,
                  const struct picture_tiles *tiles, int index, struct dpl_image *image);

/* Tiles of that renderer's pictures are no larger; 0: as the device can. */
struct dpl_renderer;
void renderer_limit_tiles(struct dpl_renderer *renderer, int side);

void picture_finish(struct picture *picture);

#endif
