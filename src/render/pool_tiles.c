#include "render/pool_tiles.h"

#include <string.h>

#define TILES_SIDE 1024 /* texels */

bool pool_tiles_update(struct dpl_gl *gl, struct pool_tiles *tiles, const struct pool_tiles_settings *settings)
{
    if (!program_ready(gl, &tiles->program, "render/pool_tiles.glsl", ""))
        return false;
    if (tiles->color.name != 0 && tiles->generation == gl->generation &&
        !memcmp(&tiles->settings, settings, sizeof *settings))
        return true;
    texture_resize(gl, &tiles->color, GL_RGBA8, TILES_SIDE, TILES_SIDE, TEXTURE_REPEAT, TEXTURE_MIPMAP);
    texture_draw_to(gl, &tiles->color);
    program_use(gl, &tiles->program);
    program_vec3(gl, &tiles->program, "tile_color", settings->color);
    program_float(gl, &tiles->program, "contrast", settings->contrast);
    program_int(gl, &tiles->program, "tile_count", settings->count);
    program_int(gl, &tiles->program, "seed", settings->seed);
    gpu_draw_screen(gl);
    texture_make_mipmaps(gl, &tiles->color);
    tiles->settings = *settings;
    tiles->generation = gl->generation;
    return true;
}

void pool_tiles_finish(struct dpl_gl *gl, struct pool_tiles *tiles)
{
    program_finish(gl, &tiles->program);
    texture_finish(gl, &tiles->color);
    *tiles = (struct pool_tiles){0};
}
