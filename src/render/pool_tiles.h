/* render/pool_tiles.h: what the pool's tiles and the clouds above it look like, drawn once as a texture. */
#ifndef RENDER_POOL_TILES_H
#define RENDER_POOL_TILES_H

#include "gpu/program.h"
#include "gpu/texture.h"

struct pool_tiles_settings {
    double color[3], contrast;
    int count, seed;
};

/* All zero: none yet. */
struct pool_tiles {
    struct gpu_program program;
    struct gpu_texture color; /* RGBA8 with mipmaps, repeats: tiles; clouds in alpha */
    struct pool_tiles_settings settings;
    unsigned generation; /* of the shader files that it was drawn with */
};

/* Draws it anew where the settings changed. The bound target and viewport change then. */
bool pool_tiles_update(struct dpl_gl *gl, struct pool_tiles *tiles, const struct pool_tiles_settings *settings);

void pool_tiles_finish(struct dpl_gl *gl, struct pool_tiles *tiles);

#endif
