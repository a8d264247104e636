/* light/sun_map.h: brightness of the sun and its halo, as the look-up of techniques that are tuned by eye.
 *
 * The map is a square picture of the sun, read along its diagonal: m = 0 is the corner, m = 1/2 the middle. */
#ifndef LIGHT_SUN_MAP_H
#define LIGHT_SUN_MAP_H

#include "dapple/log.h"

#include <stdbool.h>

#define SUN_MAP_POINTS_MAX 1024

/* Brightness as points with straight lines between them, in rising order of m. */
struct sun_map {
    int count;
    float m[SUN_MAP_POINTS_MAX], brightness[SUN_MAP_POINTS_MAX];
};

/* The soft disc of Collard & Mundi's program. */
void sun_map_disc(struct sun_map *map);

/* Reads the diagonal of a square picture's red channel. */
bool sun_map_read(struct sun_map *map, const char *path, const struct dpl_log *log);

/* Brightness at m; outside the points that of the nearer end. */
float sun_map_at(const struct sun_map *map, float m);

/* The largest m up to which the map stays as it starts: below it there is nothing to look up. */
float sun_map_start(const struct sun_map *map);

#endif
