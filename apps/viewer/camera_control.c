#include "viewer/camera_control.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define RADIANS_PER_PIXEL 0.005
#define WHEEL_RATIO 0.9       /* of the distance, a notch */
#define SPEED 1.0             /* m/s */
#define FAST 5.0              /* times the speed */
#define SECONDS_MAX 0.1       /* a slow frame moves no farther than this, so that a tap of a key stays a small step */
#define PITCH_MAX 1.55        /* radians; short of straight up and down, where left and right are undefined */
#define DISTANCE_MIN 0.02     /* m */
#define DISTANCE_MAX 5000.0   /* m */
#define COORDINATE_MAX 4999.0 /* m; with DISTANCE_MAX it stays in the range that the scene accepts */

/* A camera as its target and the way back from there to the eye. */
struct view {
    double target[3];
    double yaw, pitch; /* radians; yaw 0, pitch 0: the eye stands at +z of the target */
    double distance;   /* m */
};

static double clamp(double value, double low, double high)
{
    return fmin(fmax(value, low), high);
}

static bool get_point(const struct dpl_scene *scene, const char *key, double point[3])
{
    char text[128];
    return dpl_scene_get(scene, key, text, sizeof text) &&
           sscanf(text, "%lf %lf %lf", &point[0], &point[1], &point[2]) == 3;
}

static void set_point(struct dpl_scene *scene, const char *key, const double point[3])
{
    char text[128];
    snprintf(text, sizeof text, "%.7g %.7g %.7g", point[0], point[1], point[2]);
    dpl_scene_set(scene, key, text);
}

void camera_control_place(struct dpl_scene *scene, const double position[3], const double target[3])
{
    set_point(scene, "camera.position", position);
    set_point(scene, "camera.target", target);
}

/* The unit vector from the target to the eye. */
static void backward(const struct view *view, double out[3])
{
    out[0] = cos(view->pitch) * sin(view->yaw);
    out[1] = sin(view->pitch);
    out[2] = cos(view->pitch) * cos(view->yaw);
}

static bool read_view(const struct dpl_scene *scene, struct view *view)
{
    double eye[3], back[3];
    if (!get_point(scene, "camera.position", eye) || !get_point(scene, "camera.target", view->target))
        return false;
    for (int i = 0; i < 3; i++)
        back[i] = eye[i] - view->target[i];
    double across = hypot(back[0], back[2]);
    view->distance = clamp(hypot(across, back[1]), DISTANCE_MIN, DISTANCE_MAX);
    view->yaw = across > 0 ? atan2(back[0], back[2]) : 0;
    view->pitch = atan2(back[1], across);
    return true;
}

static void write_view(struct dpl_scene *scene, const struct view *view)
{
    double eye[3], target[3], back[3];
    backward(view, back);
    for (int i = 0; i < 3; i++) {
        target[i] = clamp(view->target[i], -COORDINATE_MAX, COORDINATE_MAX);
        eye[i] = target[i] + back[i] * view->distance;
    }
    camera_control_place(scene, eye, target);
}

static void orbit(struct view *view, const struct camera_input *input)
{
    view->yaw -= input->orbit[0] * RADIANS_PER_PIXEL;
    view->pitch = clamp(view->pitch + input->orbit[1] * RADIANS_PER_PIXEL, -PITCH_MAX, PITCH_MAX);
    view->distance = clamp(view->distance * pow(WHEEL_RATIO, input->wheel), DISTANCE_MIN, DISTANCE_MAX);
}

/* Turns the eye where it stands: the target moves. */
static void look_around(struct view *view, const struct camera_input *input)
{
    double before[3], after[3];
    backward(view, before);
    view->yaw -= input->look[0] * RADIANS_PER_PIXEL;
    view->pitch = clamp(view->pitch + input->look[1] * RADIANS_PER_PIXEL, -PITCH_MAX, PITCH_MAX);
    backward(view, after);
    for (int i = 0; i < 3; i++)
        view->target[i] += (before[i] - after[i]) * view->distance;
}

static void fly(struct view *view, const struct camera_input *input)
{
    double back[3], step = SPEED * (input->fast ? FAST : 1) * clamp(input->seconds, 0, SECONDS_MAX);
    backward(view, back);
    view->target[0] += step * (input->right * cos(view->yaw) - input->forward * back[0]);
    view->target[1] += step * (input->up - input->forward * back[1]);
    view->target[2] += step * (-input->right * sin(view->yaw) - input->forward * back[2]);
}

bool camera_control_move(struct dpl_scene *scene, const struct camera_input *input)
{
    bool orbits = input->orbit[0] != 0 || input->orbit[1] != 0 || input->wheel != 0;
    bool looks = input->look[0] != 0 || input->look[1] != 0;
    bool flies = input->forward != 0 || input->right != 0 || input->up != 0;
    struct view view;
    if (!(orbits || looks || flies) || !read_view(scene, &view))
        return false;
    if (orbits)
        orbit(&view, input);
    if (looks)
        look_around(&view, input);
    if (flies)
        fly(&view, input);
    write_view(scene, &view);
    return true;
}

bool camera_control_ray(const struct dpl_scene *scene, const double place[2], double aspect, struct camera_ray *ray)
{
    char text[64];
    struct view view;
    if (!read_view(scene, &view) || !get_point(scene, "camera.position", ray->eye) ||
        !dpl_scene_get(scene, "camera.field_of_view", text, sizeof text))
        return false;
    double back[3], square = 0, half = tan(strtod(text, NULL) * M_PI / 360), s = sin(view.yaw), c = cos(view.yaw);
    backward(&view, back);
    const double right[3] = {c, 0, -s}, up[3] = {-sin(view.pitch) * s, cos(view.pitch), -sin(view.pitch) * c};
    for (int i = 0; i < 3; i++) {
        ray->forward[i] = -back[i];
        ray->direction[i] = half * (place[0] * aspect * right[i] + place[1] * up[i]) - back[i];
        square += ray->direction[i] * ray->direction[i];
    }
    for (int i = 0; i < 3; i++)
        ray->direction[i] /= sqrt(square);
    return true;
}
