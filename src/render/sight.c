/* From where the eye sees the water: from above it, from in it, half and half, or through a tank's panes. */
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

/* A sight through one of the panes across x or z. */
static struct sight through_pane(const struct frame *frame, int axis)
{
    struct sight sight = {.side = -1, .plane_index = frame->scene->medium.ior, .pane = true};
    sight.plane[axis] = frame->camera->position[axis] > 0 ? 1 : -1;
    sight.plane[3] = waves_extent(frame);
    return sight;
}

/* Nearly all that has come into a tank through one pane, or from above, is thrown back whole by the panes at its side.
 */
static void find_mirrors(const struct frame *frame, struct sight *sight)
{
    bool comes_in = frame->scene->settings.edge == SCENE_EDGE_GLASS && (sight->pane || sight->side > 0);
    for (int a = 0; a < 2; a++)
        sight->mirrors[a] = comes_in && sight->plane[2 * a] == 0 ? 2 * waves_extent(frame) : 0;
}

int sight_find(const struct frame *frame, struct sight sights[SIGHTS_MAX])
{
    const double *eye = frame->camera->position;
    bool glass = frame->scene->settings.edge == SCENE_EDGE_GLASS, above, below;
    int count = 0;
    find_lens(frame, &above, &below);
    if (glass && !over_water(frame, eye)) {
        above = eye[1] > 0;
        below = false;
    }
    if (above)
        sights[count++] = through_surface(frame, 1, below);
    if (below)
        sights[count++] = through_surface(frame, -1, above);
    for (int axis = 0; axis <= 2; axis += 2) {
        if (!glass || fabs(eye[axis]) < waves_extent(frame))
            continue;
        sights[count] = through_pane(frame, axis);
        sights[count].beside = count > 0;
        count++;
    }
    for (int i = 0; i < count; i++)
        find_mirrors(frame, sights + i);
    return count;
}
