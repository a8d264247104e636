/* From where the eye sees the water: from above it, from in it, half and half, or through a tank's pane. */
#include "render/physical.h"

#include <math.h>

#define CLEARANCE 0.02 /* m that the plane keeps from the eye where waves lift the water to it */

static double water_height(const struct frame *frame, double x, double z)
{
    double height, slopes[2], shifts[2], area;
    struct water_points point = {1, &x, &z, &height, slopes, slopes + 1, shifts, shifts + 1, &area};
    water_sample(water_models[frame->scene->medium.model], frame->setup, frame->time, &point);
    return height;
}

static bool over_water(const struct frame *frame, const double place[3])
{
    double extent = waves_extent(frame);
    return extent == 0 || fmax(fabs(place[0]), fabs(place[2])) < extent;
}

/* Whether points of the lens, the near plane's middle and corners, lie above the water and below it. */
static void find_lens(const struct frame *frame, bool *above, bool *below)
{
    const struct scene_camera *camera = frame->camera;
    const struct camera_rays *rays = &frame->rays;
    *above = *below = false;
    for (int i = 0; i < 25; i++) {
        double x = i % 5 / 2.0 - 1, y = i / 5 / 2.0 - 1, point[3];
        for (int c = 0; c < 3; c++)
            point[c] =
                camera->position[c] + camera->near_plane * (rays->ahead[c] + x * rays->right[c] + y * rays->up[c]);
        bool wet = over_water(frame, point) && point[1] < water_height(frame, point[0], point[2]);
        *above = *above || !wet;
        *below = *below || wet;
    }
}

/* A sight through the rest surface, which the eye keeps to its side. */
static struct sight through_surface(const struct frame *frame, double side, bool line)
{
    double eye = frame->camera->position[1], ior = frame->scene->medium.ior;
    double level = side > 0 ? fmin(0, eye - CLEARANCE) : fmax(0, eye + CLEARANCE);
    return (struct sight){
        .side = side, .plane = {0, side, 0, side * level}, .plane_index = side > 0 ? ior : 1 / ior, .line = line};
}

/* A sight through the pane that faces the eye the most. */
static struct sight through_pane(const struct frame *frame)
{
    const double *eye = frame->camera->position;
    double extent = waves_extent(frame);
    int axis = fabs(eye[0]) > fabs(eye[2]) ? 0 : 2;
    struct sight sight = {.side = -1, .plane_index = frame->scene->medium.ior, .pane = true};
    sight.plane[axis] = eye[axis] > 0 ? 1 : -1;
    sight.plane[3] = extent;
    return sight;
}

int sight_find(const struct frame *frame, struct sight sights[2])
{
    bool above, below;
    find_lens(frame, &above, &below);
    if (frame->scene->settings.edge == SCENE_EDGE_GLASS && !over_water(frame, frame->camera->position)) {
        sights[0] = through_pane(frame);
        return 1;
    }
    int count = 0;
    if (above)
        sights[count++] = through_surface(frame, 1, below);
    if (below)
        sights[count++] = through_surface(frame, -1, above);
    return count;
}
