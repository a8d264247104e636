#include "light/map_texture.h"

#include "base/log.h"

#include <stdlib.h>
#include <string.h>

int map_texture_channels(const struct gpu_texture *map)
{
    return map->format == GL_R16F || map->format == GL_R32F ? 1 : 3;
}

void map_texture_resize(struct dpl_gl *gl, struct gpu_texture *map, int side, int channels, int slices,
                        enum map_origin origin, bool finished, bool periodic)
{
    bool es = gl->info.es;
    /* OpenGL ES makes smaller levels of what it can draw to, which is not three channels. */
    GLenum half = channels == 1 ? GL_R16F : GL_RGBA16F, four = es ? GL_RGBA32F : GL_RGB32F;
    GLenum full = channels == 1 ? GL_R32F : four;
    GLenum format = origin == MAP_DRAWN || !gl->info.float_linear ? half : full;
    bool levels = finished && gl->info.float_render;
    texture_resize_array(gl, map, format, side, side, slices, periodic ? TEXTURE_REPEAT : TEXTURE_CLAMP,
                         levels ? TEXTURE_MIPMAP : TEXTURE_LINEAR);
}

bool map_texture_upload(struct dpl_gl *gl, const struct gpu_texture *texture, const struct light_map *map,
                        struct map_room *room)
{
    size_t count = (size_t)map->slices * (size_t)map->side * (size_t)map->side;
    if (texture->format != GL_RGBA16F && texture->format != GL_RGBA32F) {
        texture_upload(gl, texture, map->texels);
        return true;
    }
    if (room->count < count) {
        free(room->texels);
        room->texels = base_allocate(gl->log, count * 4, sizeof *room->texels, "caustic map");
        room->count = room->texels ? count : 0;
    }
    for (size_t i = 0; room->texels && i < count; i++)
        memcpy(room->texels + 4 * i, map->texels + 3 * i, 3 * sizeof *room->texels);
    if (room->texels)
        texture_upload(gl, texture, room->texels);
    return room->texels != NULL;
}

/* Names of the uniforms: texture, window, step. */
static void bind(struct dpl_gl *gl, const struct gpu_texture *map, const struct ray_window *windows, double size,
                 const struct gpu_program *program, int unit, const char *const names[3])
{
    const struct ray_window *first = windows, *next = windows + (map->layers > 1);
    const double in_tiles[3] = {first->x / size + 0.5, first->z / size + 0.5, first->side / size};
    const double step[3] = {(next->x - first->x) / size, (next->z - first->z) / size, 0};
    texture_bind(gl, map, (GLenum)unit);
    program_int(gl, program, names[0], unit);
    program_vec3(gl, program, names[1], in_tiles);
    program_vec3(gl, program, names[2], step);
}

void map_texture_bind(struct dpl_gl *gl, const struct gpu_texture *map, const struct ray_window *windows, double size,
                      const struct gpu_program *program, int unit)
{
    static const char *const names[] = {"light_texels", "light_window", "light_step"};
    bind(gl, map, windows, size, program, unit, names);
    program_int(gl, program, "light_channels", map_texture_channels(map));
}

void map_texture_bind_reflected(struct dpl_gl *gl, const struct gpu_texture *map, const struct ray_window *windows,
                                double size, const struct gpu_program *program, int unit)
{
    static const char *const names[] = {"reflected_texels", "reflected_window", "reflected_step"};
    bind(gl, map, windows, size, program, unit, names);
}

struct dpl_image *map_texture_read(struct dpl_gl *gl, struct gpu_texture *map, int slice)
{
    int side = map->width;
    size_t count = (size_t)side * (size_t)side;
    struct dpl_image *image = dpl_image_create(side, side, gl->log);
    float *texels = image ? base_allocate(gl->log, count * 4, sizeof *texels, "caustic map") : NULL;
    if (!texels) {
        dpl_image_destroy(image);
        return NULL;
    }
    texture_draw_to_layer(gl, map, slice);
    gl->ReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, texels);
    for (size_t i = 0; i < count; i++)
        for (size_t c = 0; c < 3; c++)
            image->pixels[i * 3 + c] = texels[i * 4 + (map_texture_channels(map) == 1 ? 0 : c)];
    free(texels);
    return image;
}
