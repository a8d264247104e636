#include "light/blur.h"

/* Mean of the 2·width texels along one axis; `step` is the distance of neighbours in memory, `count` their number. */
static float mean_along(const float *line, int index, int count, size_t step, int width)
{
    float sum = 0.0f;
    for (int k = index - width; k < index + width; k++)
        sum += line[(size_t)((k + count * width) % count) * step];
    return sum / (float)(2 * width);
}

static void blur_slice(const struct light_blur *blur, const struct light_map *map, int slice, int width)
{
    int side = map->side, row = side * map->channels;
    float *lines = blur->lines.texels, *texels = light_map_slice(map, slice);
#pragma omp parallel for
    for (int j = 0; j < side; j++)
        for (int i = 0; i < row; i++)
            lines[(size_t)j * (size_t)row + (size_t)i] =
                mean_along(texels + (size_t)j * (size_t)row + i % map->channels, i / map->channels, side,
                           (size_t)map->channels, width);
#pragma omp parallel for
    for (int j = 0; j < side; j++)
        for (int i = 0; i < row; i++)
            texels[(size_t)j * (size_t)row + (size_t)i] = mean_along(lines + i, j, side, (size_t)row, width);
}

bool blur_map(struct light_blur *blur, struct light_map *map, int width, const struct dpl_log *log)
{
    if (width == 0)
        return true;
    if (!light_map_resize(&blur->lines, map->side, map->channels, 1, log))
        return false;
    for (int slice = 0; slice < map->slices; slice++)
        blur_slice(blur, map, slice, width);
    return true;
}

bool blur_draw(struct light_blur *blur, struct dpl_gl *gl, const struct gpu_texture *from, int width,
               struct gpu_texture *to)
{
    if (!program_ready(gl, &blur->program, "light/blur.glsl", ""))
        return false;
    program_use(gl, &blur->program);
    texture_bind(gl, from, 0);
    program_int(gl, &blur->program, "map", 0);
    program_int(gl, &blur->program, "width", width);
    for (int slice = 0; slice < to->layers; slice++) {
        texture_draw_to_layer(gl, to, slice);
        program_int(gl, &blur->program, "slice", slice);
        gpu_draw_screen(gl);
    }
    return true;
}

void blur_finish(struct light_blur *blur, struct dpl_gl *gl)
{
    if (gl)
        program_finish(gl, &blur->program);
    light_map_finish(&blur->lines);
}
