#include "light/sun_map.h"

#include "base/log.h"
#include "io/format.h"

#include <math.h>

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

#define BRIGHTEST 65504 /* that a texture of half floats holds */

static bool is_sun_map(const struct dpl_image *image, const char *path, const struct dpl_log *log)
{
    if (image->width != image->height || image->width < 2)
        return base_fail(log, DPL_REASON_FILE_FORMAT, "%s: a sun map is square: %d × %d (accepted: 2 or more a side)",
                         path, image->width, image->height);
    for (int t = 0; t < image->width * image->height; t++) {
        double red = (double)image->pixels[t * image->channels];
        if (!(red >= 0 && red <= BRIGHTEST))
            return base_fail(log, DPL_REASON_FILE_FORMAT,
                             "%s: no brightness in column %d, row %d: \"%g\" (accepted: 0 to %d)", path,
                             t % image->width, t / image->width, red, BRIGHTEST);
    }
    return true;
}

/* A square picture whose red channel is brightness, or NULL. */
static struct dpl_image *read_square(const char *path, const struct dpl_log *log)
{
    struct dpl_image *image = io_read(path, log);
    if (!image || is_sun_map(image, path, log))
        return image;
    dpl_image_destroy(image);
    return NULL;
}

bool sun_map_read(struct sun_map *map, const char *path, const struct dpl_log *log)
{
    struct dpl_image *image = read_square(path, log);
    if (!image)
        return false;
    int half = image->width / 2;
    map->count = half < SUN_MAP_POINTS_MAX ? half : SUN_MAP_POINTS_MAX;
    for (int i = 0; i < map->count; i++) {
        int texel = (int)((long long)i * half / map->count);
        map->m[i] = ((float)texel + 0.5f) / (float)image->width;
        map->brightness[i] = image->pixels[(texel * image->width + texel) * image->channels];
    }
    dpl_image_destroy(image);
    return true;
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

static const double degree = M_PI / 180;

/* Sets how far the picture reaches: `width` degrees, and a margin of a texel, so that a halo ends before the edge. */
static void set_reach(struct sun_picture *picture, double width)
{
    picture->reach = (float)(sin(fmin(width / 2, 90) * degree) * SUN_PICTURE_SIDE / (SUN_PICTURE_SIDE - 2));
}

/* Where a texel's middle lies: its direction from the zenith along x and z, degrees; returns the angle. */
static double find_angle(const struct sun_picture *picture, int i, int j, double angles[2])
{
    double x = ((i + 0.5) / SUN_PICTURE_SIDE * 2 - 1) * (double)picture->reach;
    double z = ((j + 0.5) / SUN_PICTURE_SIDE * 2 - 1) * (double)picture->reach;
    double sine = hypot(x, z), angle = asin(fmin(sine, 1)) / degree;
    angles[0] = angle * x / sine;
    angles[1] = angle * z / sine;
    return angle;
}

void sun_picture_halo(struct sun_picture *picture, double width, double halo, double falloff)
{
    double radius = width / 2, end = fmin(radius * halo, 90), angles[2];
    set_reach(picture, width * halo);
    for (int t = 0; t < SUN_PICTURE_SIDE * SUN_PICTURE_SIDE; t++) {
        double angle = find_angle(picture, t % SUN_PICTURE_SIDE, t / SUN_PICTURE_SIDE, angles);
        double brightness = angle <= radius ? 1 : angle < end ? pow((end - angle) / (end - radius), falloff) : 0;
        picture->texels[t] = (float)brightness;
    }
}

/* The red channel between the middles of texels, bilinear; `place` from 0 to 1 across the image. */
static double image_at(const struct dpl_image *image, const double place[2])
{
    int corner[2];
    double part[2], sum = 0;
    for (int k = 0; k < 2; k++) {
        double at = fmin(fmax(place[k] * image->width - 0.5, 0), image->width - 1);
        corner[k] = (int)fmin(at, image->width - 2);
        part[k] = at - corner[k];
    }
    for (int k = 0; k < 4; k++) {
        int x = corner[0] + k % 2, z = corner[1] + k / 2;
        double share = (k % 2 ? part[0] : 1 - part[0]) * (k / 2 ? part[1] : 1 - part[1]);
        sum += share * (double)image->pixels[(z * image->width + x) * image->channels];
    }
    return sum;
}

bool sun_picture_read(struct sun_picture *picture, double width, const char *path, const struct dpl_log *log)
{
    struct dpl_image *image = read_square(path, log);
    if (!image)
        return false;
    set_reach(picture, width);
    for (int t = 0; t < SUN_PICTURE_SIDE * SUN_PICTURE_SIDE; t++) {
        double place[2];
        find_angle(picture, t % SUN_PICTURE_SIDE, t / SUN_PICTURE_SIDE, place);
        for (int k = 0; k < 2; k++)
            place[k] = 0.5 + place[k] / width;
        picture->texels[t] = (float)image_at(image, place);
    }
    dpl_image_destroy(image);
    return true;
}
