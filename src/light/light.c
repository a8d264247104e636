#include "light/light.h"

#include "base/log.h"

#include <stdlib.h>

extern const struct light_technique light_coverage, light_wavefront, light_photons, light_beams, light_hemisphere,
    light_multi_sample, light_vertex_ray, light_pixel_ray, light_precomputed, light_reference;

const struct light_technique *const light_techniques[] = {&light_coverage,
                                                          &light_wavefront,
                                                          &light_photons,
                                                          &light_beams,
                                                          &light_hemisphere,
                                                          &light_multi_sample,
                                                          &light_vertex_ray,
                                                          &light_pixel_ray,
                                                          &light_precomputed,
                                                          &light_reference,
                                                          NULL};
_Static_assert(sizeof light_techniques / sizeof *light_techniques - 1 <= LIGHT_TECHNIQUES_MAX,
               "room for the state of each");

const char *light_technique_name(int i)
{
    const int count = sizeof light_techniques / sizeof *light_techniques - 1;
    return i >= 0 && i < count ? light_techniques[i]->name : NULL;
}

static const char *window_name(int i)
{
    static const char *const names[] = {"tile", "light", NULL};
    return names[i];
}

const struct dpl_param light_settings_params[] = {
    PARAM_CHOICE(struct light_settings, technique, 0, light_technique_name, "technique; see `dapple list techniques`"),
    PARAM_INT(struct light_settings, map, 512, 1, LIGHT_MAP_MAX, "texels", "side of the caustic map"),
    PARAM_INT(struct light_settings, mesh, 0, 0, LIGHT_MESH_MAX, "vertices",
              "side of the surface's grid, for water models without one of their own; 0 = as caustics.error needs"),
    PARAM_FLOAT(struct light_settings, error, 1, 0.05, 20, "%",
                "wanted error of a physical map (RMS), where its detail is left open: mesh, coverage's fineness and "
                "footprints"),
    PARAM_CHOICE(struct light_settings, window, LIGHT_WINDOW_TILE, window_name,
                 "of bounded water, what the map shows: tile = the square straight below the water; light = where its "
                 "light falls"),
    PARAM_FLOAT(struct light_settings, margin, 0, 0, 4, "tiles",
                "of bounded water, how far the map goes on beyond that square on every side"),
    PARAM_INT(struct light_settings, slices, 1, 1, LIGHT_SLICES_MAX, "",
              "maps at even steps from the floor (slice 0) up towards the surface"),
    PARAM_FLOAT(
        struct light_settings, ceiling, 0, 0, 1000, "m",
        "height above the water of a ceiling whose reflected light is mapped in place of the floor's (pictures then "
        "show it on the floor); 0 = the floor"),
    PARAM_INT(struct light_settings, reflected_slices, 0, 0, LIGHT_SLICES_MAX, "",
              "beside those: maps of reflected light, for what stands above the water, at even steps up to "
              "reflected_height (look = physical)"),
    PARAM_FLOAT(struct light_settings, reflected_height, 3, 0.01, 1000, "m",
                "height above the water of the highest map of reflected light"),
    PARAM_FLOAT(struct light_settings, depth_bias, 0.6, 0, 10, "m",
                "added to the depth by techniques that are tuned by eye (multi-sample)"),
    PARAM_INT(struct light_settings, blur, 0, 0, 5, "texels", "box blur of the finished map: mean of (2 blur)² texels"),
    PARAM_END,
};

bool light_map_resize(struct light_map *map, int side, int channels, int slices, const struct dpl_log *log)
{
    map->noise = 0;
    if (map->texels && map->side == side && map->channels == channels && map->slices == slices)
        return true;
    light_map_finish(map);
    size_t count = (size_t)side * (size_t)side * (size_t)channels * (size_t)slices;
    float *texels = base_allocate(log, count, sizeof *texels, "caustic map");
    if (texels)
        *map = (struct light_map){.side = side, .channels = channels, .slices = slices, .texels = texels};
    return texels != NULL;
}

float *light_map_slice(const struct light_map *map, int slice)
{
    return map->texels + (size_t)slice * (size_t)map->side * (size_t)map->side * (size_t)map->channels;
}

struct dpl_image *light_map_image(const struct light_map *map, int slice, const struct dpl_log *log)
{
    const float *texels = light_map_slice(map, slice);
    struct dpl_image *image = dpl_image_create(map->side, map->side, log);
    for (size_t i = 0; image && i < (size_t)map->side * (size_t)map->side; i++)
        for (size_t c = 0; c < 3; c++)
            image->pixels[i * 3 + c] = texels[map->channels == 1 ? i : i * 3 + c];
    return image;
}

void light_map_finish(struct light_map *map)
{
    free(map->texels);
    *map = (struct light_map){0};
}
