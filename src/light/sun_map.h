/* light/sun_map.h: brightness of the sun and its halo, as the look-up of techniques that are tuned by eye.
 *
 * Either is a square picture of the sun, in the red channel of a file or made from formulas. A sun map is read along
 * the picture's diagonal: m = 0 is the corner, m = 1/2 the middle. A sun picture is read all over, as a part of the sky
 * round the zenith. */
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

#define SUN_PICTURE_SIDE 256 /* texels */

/* The sky round the zenith, seen from straight below. A unit vector (x, y, z) upwards meets it at x / reach, z / reach,
 * from -1 to 1 across; beyond, the edge goes on. */
struct sun_picture {
    float reach;                                       /* sine of the angle from the zenith to the middle of an edge */
    float texels[SUN_PICTURE_SIDE * SUN_PICTURE_SIDE]; /* row 0 is the smallest z */
};

/* The sun, `width` degrees across, of brightness 1, and round it a halo, `halo` times as wide, whose brightness falls
 * from 1 to 0 as the power `falloff` of the distance from its edge. */
void sun_picture_halo(struct sun_picture *picture, double width, double halo, double falloff);

/* A picture that spans `width` degrees, right is +x and down +z; the distance from its middle is the angle to the
 * zenith. */
bool sun_picture_read(struct sun_picture *picture, double width, const char *path, const struct dpl_log *log);

#endif
