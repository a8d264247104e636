/* render/sand.h: the sand's colour, drawn once as a texture that covers the tile. */
#ifndef RENDER_SAND_H
#define RENDER_SAND_H

#include "gpu/program.h"
#include "scene/scene.h"

/* All zero: none yet. */
struct sand {
    struct gpu_program program;
    struct gpu_texture color;  /* RGBA8 with mipmaps, repeats */
    struct scene_floor params; /* that it was drawn for */
    double size;
    int seed;
};

/* Draws it anew where the scene's floor, size or seed changed. */
bool sand_update(struct dpl_gl *gl, struct sand *sand, const struct dpl_scene *scene);

void sand_finish(struct dpl_gl *gl, struct sand *sand);

#endif
