#include "light/sun_map.h"

#include "base/log.h"
#include "io/format.h"

/* Black up to the first point. */
static const float disc[][2] = {
    {0.16f, 0.0f},  {0.20f, 0.004f}, {0.25f, 0.03f}, {0.28f, 0.08f}, {0.30f, 0.14f}, {0.32f, 0.23f},
    {0.34f, 0.34f}, {0.36f, 0.46f},  {0.38f, 0.60f}, {0.40f, 0.73f}, {0.42f, 0.84f}, {0.44f, 0.93f},
    {0.46f, 0.99f}, {0.475f, 1.0f},  {0.49f, 0.99f}, {0.50f, 0.96f},
};

void sun_map_disc(struct sun_map *map)
{
    map->count = sizeof disc / sizeof *disc;
    for (int i = 0; i < map->count; i++) {
        map->m[i] = disc[i][0];
        map->brightness[i] = disc[i][1];
    }
}

bool sun_map_read(struct sun_map *map, const char *path, const struct dpl_log *log)
{
    struct dpl_image *image = io_read(path, log);
    if (!image)
        return false;
    bool square = image->width == image->height && image->width > 1;
    if (!square)
        base_fail(log, DPL_REASON_FILE_FORMAT, "%s: a sun map is square: %d × %d", path, image->width, image->height);
    int half = image->width / 2;
    map->count = !square ? 0 : half < SUN_MAP_POINTS_MAX ? half : SUN_MAP_POINTS_MAX;
    for (int i = 0; i < map->count; i++) {
        int texel = (int)((long long)i * half / map->count);
        map->m[i] = ((float)texel + 0.5f) / (float)image->width;
        map->brightness[i] = image->pixels[(texel * image->width + texel) * image->channels];
    }
    dpl_image_destroy(image);
    return square;
}

float sun_map_at(const struct sun_map *map, float m)
{
    int i = 0;
    while (i < map->count && map->m[i] <= m)
        i++;
    if (i == 0 || i == map->count)
        return map->brightness[i ? i - 1 : 0];
    float part = (m - map->m[i - 1]) / (map->m[i] - map->m[i - 1]);
    return map->brightness[i - 1] + part * (map->brightness[i] - map->brightness[i - 1]);
}

float sun_map_start(const struct sun_map *map)
{
    int i = 0;
    while (i + 1 < map->count && map->brightness[i + 1] == map->brightness[0])
        i++;
    return map->m[i];
}
