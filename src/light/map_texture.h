/* light/map_texture.h: caustic maps as one texture array, a layer each receiver; shaders read it through
 * light/map.glsl. */
#ifndef LIGHT_MAP_TEXTURE_H
#define LIGHT_MAP_TEXTURE_H

#include "dapple/image.h"
#include "gpu/program.h"
#include "gpu/texture.h"
#include "light/light.h"
#include "reference/ray.h"

enum map_origin { MAP_DRAWN, MAP_UPLOADED };

/* Makes the texture that size. `origin`: floats as the CPU makes them, halves as the GPU does. `finished`: it is shown,
 * with smaller levels, which keep far floor from flickering, where the device draws to such formats. */
void map_texture_resize(struct dpl_gl *gl, struct gpu_texture *map, int side, int channels, int slices,
                        enum map_origin origin, bool finished, bool periodic);

/* Room for a map of three channels that the device wants as four. All zero: none yet; its owner frees `texels`. */
struct map_room {
    float *texels;
    size_t count;
};

/* Copies a map into a texture of its size made for MAP_UPLOADED. False (logged): no memory. */
bool map_texture_upload(struct dpl_gl *gl, const struct gpu_texture *texture, const struct light_map *map,
                        struct map_room *room);

/* Sets the uniforms of light/map.glsl in the program in use, the texture on the given unit. `windows` are
 * those of the receivers, of which the first two count, `size` is the tile's side in metres. */
void map_texture_bind(struct dpl_gl *gl, const struct gpu_texture *map, const struct ray_window *windows, double size,
                      const struct gpu_program *program, int unit);

/* The same for maps of light thrown back: the uniforms of render/receiver.glsl. */
void map_texture_bind_reflected(struct dpl_gl *gl, const struct gpu_texture *map, const struct ray_window *windows,
                                double size, const struct gpu_program *program, int unit);

/* Channels that hold something: 1 or 3. */
int map_texture_channels(const struct gpu_texture *map);

/* One slice as a new image of three channels. */
struct dpl_image *map_texture_read(struct dpl_gl *gl, struct gpu_texture *map, int slice);

#endif
