#include "render/sand.h"

#include <string.h>

#define SAND_SIDE 2048 /* texels */

bool sand_update(struct dpl_gl *gl, struct sand *sand, const struct dpl_scene *scene)
{
    bool drawn = sand->color.name != 0 && sand->program.generation == gl->generation &&
                 !memcmp(&sand->params, &scene->floor, sizeof sand->params) && sand->size == scene->settings.size &&
                 sand->seed == scene->settings.seed;
    if (drawn)
        return true;
    if (!program_ready(gl, &sand->program, "render/sand.glsl", ""))
        return false;
    texture_resize(gl, &sand->color, GL_RGBA8, SAND_SIDE, SAND_SIDE, TEXTURE_REPEAT, TEXTURE_MIPMAP);
    texture_draw_to(gl, &sand->color);
    program_use(gl, &sand->program);
    program_vec3(gl, &sand->program, "mean_color", scene->floor.color);
    program_float(gl, &sand->program, "contrast", scene->floor.contrast);
    program_float(gl, &sand->program, "spots", scene->settings.size / scene->floor.grain);
    program_int(gl, &sand->program, "seed", scene->settings.seed);
    gpu_draw_screen(gl);
    texture_make_mipmaps(gl, &sand->color);
    sand->params = scene->floor;
    sand->size = scene->settings.size;
    sand->seed = scene->settings.seed;
    return true;
}

void sand_finish(struct dpl_gl *gl, struct sand *sand)
{
    program_finish(gl, &sand->program);
    texture_finish(gl, &sand->color);
    *sand = (struct sand){0};
}
