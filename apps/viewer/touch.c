#include "viewer/touch.h"

#include "viewer/camera_control.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DROP_RADIUS 0.03 /* sides of the tile: Wallace's, in units of his texture */
#define DROP_HEIGHT 0.01 /* half sides */
#define DROPS_MAX 16     /* a frame */
#define CEILING 10       /* half sides: how high the sphere is lifted at most */

static double get_number(const struct dpl_scene *scene, const char *key)
{
    char text[128];
    return dpl_scene_get(scene, key, text, sizeof text) ? strtod(text, NULL) : 0;
}

static void set_number(struct dpl_scene *scene, const char *key, double number)
{
    char text[64];
    snprintf(text, sizeof text, "%.6g", number);
    dpl_scene_set(scene, key, text);
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void walk(const struct camera_ray *ray, double way, double point[3])
{
    for (int c = 0; c < 3; c++)
        point[c] = ray->eye[c] + way * ray->direction[c];
}

/* Ways along a ray; infinite where it does not get there. */
static double way_to_plane(const struct camera_ray *ray, const double point[3], const double normal[3])
{
    double from[3], steep = dot(ray->direction, normal);
    for (int c = 0; c < 3; c++)
        from[c] = point[c] - ray->eye[c];
    double way = dot(from, normal) / steep;
    return way > 0 ? way : INFINITY;
}

static double way_to_water(const struct dpl_scene *scene, const struct camera_ray *ray)
{
    static const double rest[3] = {0, 0, 0}, up[3] = {0, 1, 0};
    double half = get_number(scene, "scene.size") / 2, point[3], way = way_to_plane(ray, rest, up);
    walk(ray, way, point);
    return fabs(point[0]) <= half && fabs(point[2]) <= half ? way : INFINITY;
}

static double way_to_sphere(const struct dpl_scene *scene, const struct dpl_renderer *renderer,
                            const struct camera_ray *ray)
{
    double center[3], from[3], radius = get_number(scene, "sphere.radius");
    if (!dpl_renderer_sphere(renderer, center))
        return INFINITY;
    for (int c = 0; c < 3; c++)
        from[c] = center[c] - ray->eye[c];
    double along = dot(from, ray->direction), square = along * along - dot(from, from) + radius * radius;
    return square >= 0 && along > sqrt(square) ? along - sqrt(square) : INFINITY;
}

/* The ray beyond flat water, by Snell's law: what it has along the water changes with the index. False where it is all
 * thrown back. */
static bool refract(const struct dpl_scene *scene, struct camera_ray *ray, double way)
{
    double ior = get_number(scene, "water.ior"), ratio = ray->direction[1] < 0 ? 1 / ior : ior;
    double x = ray->direction[0] * ratio, z = ray->direction[2] * ratio, square = 1 - x * x - z * z;
    if (square <= 0)
        return false;
    walk(ray, way, ray->eye);
    ray->direction[0] = x;
    ray->direction[1] = copysign(sqrt(square), ray->direction[1]);
    ray->direction[2] = z;
    return true;
}

/* True where a model that can be disturbed makes the water, alone or with another. */
static bool can_disturb(const struct dpl_scene *scene)
{
    for (int i = 0; dpl_scene_section(scene, i).name; i++) {
        struct dpl_section section = dpl_scene_section(scene, i);
        for (int w = 0; section.active && dpl_water_model(w).name; w++)
            if (dpl_water_model(w).disturbed && !strcmp(dpl_water_model(w).name, section.name))
                return true;
    }
    return false;
}

static enum touch_thing find_thing(const struct dpl_scene *scene, const struct dpl_renderer *renderer,
                                   struct camera_ray ray)
{
    double water = way_to_water(scene, &ray), sphere = way_to_sphere(scene, renderer, &ray);
    if (!isfinite(water) || sphere < water)
        return isfinite(sphere) ? TOUCH_SPHERE : TOUCH_NOTHING;
    if (refract(scene, &ray, water) && isfinite(way_to_sphere(scene, renderer, &ray)))
        return TOUCH_SPHERE;
    return can_disturb(scene) ? TOUCH_WATER : TOUCH_NOTHING;
}

static void take_hold(struct touch *touch, const struct dpl_scene *scene, struct dpl_renderer *renderer,
                      const struct camera_ray *ray)
{
    double center[3];
    double radius = DROP_RADIUS * get_number(scene, "scene.size");
    double height = DROP_HEIGHT * get_number(scene, "scene.size") / 2;
    touch->thing = find_thing(scene, renderer, *ray);
    if (touch->thing == TOUCH_WATER) {
        walk(ray, way_to_water(scene, ray), touch->last);
        dpl_renderer_drop(renderer, touch->last[0], touch->last[2], radius, height);
    } else if (touch->thing == TOUCH_SPHERE) {
        dpl_renderer_sphere(renderer, center);
        memcpy(touch->normal, ray->forward, sizeof touch->normal);
        walk(ray, way_to_plane(ray, center, touch->normal), touch->last);
    }
}

/* Drops a radius apart, from the last place on. */
static void stroke_water(struct touch *touch, const struct dpl_scene *scene, struct dpl_renderer *renderer,
                         const struct camera_ray *ray)
{
    double radius = DROP_RADIUS * get_number(scene, "scene.size"), way = way_to_water(scene, ray), point[3];
    double height = DROP_HEIGHT * get_number(scene, "scene.size") / 2;
    if (!isfinite(way))
        return;
    walk(ray, way, point);
    double x = point[0] - touch->last[0], z = point[2] - touch->last[2], length = hypot(x, z);
    int count = (int)fmin(length / radius, DROPS_MAX);
    for (int i = 0; i < count; i++) {
        touch->last[0] += x / length * radius;
        touch->last[2] += z / length * radius;
        dpl_renderer_drop(renderer, touch->last[0], touch->last[2], radius, height);
    }
}

static double clamp(double value, double low, double high)
{
    return fmin(fmax(value, low), fmax(high, low));
}

/* By as much as the hand has moved, and not through the walls. */
static void drag_sphere(struct touch *touch, struct dpl_scene *scene, const struct dpl_renderer *renderer,
                        const struct camera_ray *ray)
{
    char text[128];
    double center[3], point[3], way = way_to_plane(ray, touch->last, touch->normal);
    if (!isfinite(way) || !dpl_renderer_sphere(renderer, center))
        return;
    walk(ray, way, point);
    double radius = get_number(scene, "sphere.radius"), half = get_number(scene, "scene.size") / 2;
    double depth = get_number(scene, "scene.depth"), aside = half - radius;
    double x = clamp(center[0] + point[0] - touch->last[0], -aside, aside);
    double y = clamp(center[1] + point[1] - touch->last[1], radius - depth, CEILING * half);
    double z = clamp(center[2] + point[2] - touch->last[2], -aside, aside);
    memcpy(touch->last, point, sizeof point);
    snprintf(text, sizeof text, "%.7g %.7g %.7g", x, y, z);
    dpl_scene_set(scene, "sphere.position", text);
}

bool touch_move(struct touch *touch, struct dpl_scene *scene, struct dpl_renderer *renderer,
                const struct touch_input *input)
{
    struct camera_ray ray;
    if (input->pressed && camera_control_ray(scene, input->pressed_at, input->aspect, &ray))
        take_hold(touch, scene, renderer, &ray);
    if (camera_control_ray(scene, input->place, input->aspect, &ray)) {
        if (touch->thing == TOUCH_WATER)
            stroke_water(touch, scene, renderer, &ray);
        if (touch->thing == TOUCH_SPHERE)
            drag_sphere(touch, scene, renderer, &ray);
    }
    bool holds = touch->thing != TOUCH_NOTHING;
    if (!input->held)
        touch->thing = TOUCH_NOTHING;
    return holds;
}

void touch_toggle_gravity(struct dpl_scene *scene)
{
    char text[16];
    if (dpl_scene_get(scene, "sphere.gravity", text, sizeof text))
        dpl_scene_set(scene, "sphere.gravity", strcmp(text, "true") ? "true" : "false");
}

void touch_place_sun(struct dpl_scene *scene)
{
    const double degrees = 180 / M_PI, middle[2] = {0, 0};
    struct camera_ray ray;
    if (!camera_control_ray(scene, middle, 1, &ray))
        return;
    double elevation = asin(clamp(-ray.forward[1], -1, 1)) * degrees;
    dpl_scene_set(scene, "sun.by", "angles");
    set_number(scene, "sun.azimuth", atan2(-ray.forward[2], -ray.forward[0]) * degrees);
    set_number(scene, "sun.elevation", clamp(elevation, 1, 90)); /* it does not set */
}
