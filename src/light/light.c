#include "light/light.h"

#include "base/log.h"

#include <stdlib.h>

extern const struct light_technique light_multi_sample;

const struct light_technique *const light_techniques[] = {&light_multi_sample, NULL};

const char *light_technique_name(int i)
{
    const int count = sizeof light_techniques / sizeof *light_techniques - 1;
    return i >= 0 && i < count ? light_techniques[i]->name : NULL;
}

const struct dpl_param light_sun_params[] = {
    PARAM_FLOAT(struct light_sun, elevation, 60, 0, 90, "degrees",
                "height of the sun above the horizon; 90 = overhead"),
    PARAM_FLOAT(struct light_sun, azimuth, 30, -360, 360, "degrees", "direction towards the sun, from +x towards +z"),
    PARAM_FLOAT(struct light_sun, angular_radius, 0.2665, 0, 10, "degrees", "half the sun's width; 0 = a point"),
    PARAM_END,
};

const struct dpl_param light_medium_params[] = {
    PARAM_CHOICE(struct light_medium, model, 0, water_model_name, "water model; see `dapple list waters`"),
    PARAM_FLOAT(struct light_medium, ior, 1.333, 1, 3, "", "refractive index of the water (physical techniques)"),
    PARAM_FLOATS(struct light_medium, absorption, 3, 0, 100, "1/m",
                 "absorption coefficient in red, green and blue (physical techniques)", 0.35, 0.07, 0.03),
    PARAM_END,
};

const struct dpl_param light_settings_params[] = {
    PARAM_CHOICE(struct light_settings, technique, 0, light_technique_name, "technique; see `dapple list techniques`"),
    PARAM_INT(struct light_settings, map, 512, 1, LIGHT_MAP_MAX, "texels", "side of the caustic map"),
    PARAM_INT(struct light_settings, mesh, 512, 2, LIGHT_MESH_MAX, "vertices",
              "side of the surface's grid, for water models without one of their own"),
    PARAM_FLOAT(struct light_settings, depth_bias, 0.6, 0, 10, "m",
                "added to the depth by techniques that are tuned by eye (multi-sample)"),
    PARAM_INT(struct light_settings, blur, 0, 0, 5, "texels", "box blur of the finished map: mean of (2 blur)² texels"),
    PARAM_END,
};

bool light_map_resize(struct light_map *map, int side, int channels, const struct dpl_log *log)
{
    if (map->texels && map->side == side && map->channels == channels)
        return true;
    light_map_finish(map);
    float *texels = base_allocate(log, (size_t)side * (size_t)side * (size_t)channels, sizeof *texels, "caustic map");
    if (texels)
        *map = (struct light_map){side, channels, texels};
    return texels != NULL;
}

void light_map_finish(struct light_map *map)
{
    free(map->texels);
    *map = (struct light_map){0};
}
