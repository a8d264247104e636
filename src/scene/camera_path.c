#include "scene/camera_path.h"

#include "scene/scene.h"

#include <math.h>
#include <string.h>

#define SPEED_MAX 3.0 /* of the velocity at a key, mean speeds of the slower side */

const struct dpl_param scene_camera_key_params[] = {
    PARAM_FLOAT(struct scene_camera_key, time, 0, 0, 3600, "s", "when the camera is here; keys may stand in any order"),
    PARAM_FLOATS(struct scene_camera_key, position, 3, -10000, 10000, "m", "place of the eye", 0, 0.2, 4),
    PARAM_FLOATS(struct scene_camera_key, target, 3, -10000, 10000, "m", "place that is looked at", 0, -0.6, 0),
    PARAM_FLOAT(struct scene_camera_key, field_of_view, 45, SCENE_FIELD_OF_VIEW_MIN, SCENE_FIELD_OF_VIEW_MAX, "degrees",
                "height of the view"),
    PARAM_END,
};

/* The keys that are there, by time; those of one time by number. */
struct path {
    struct scene_camera_key keys[SCENE_CAMERA_KEYS_MAX];
    int count;
    bool closed;
};

static struct path read_path(const struct dpl_scene *scene)
{
    struct path path = {.closed = scene->camera.closed};
    for (int k = 0; k < SCENE_CAMERA_KEYS_MAX; k++) {
        if (!scene->camera_key_present[k])
            continue;
        int place = path.count++;
        for (; place > 0 && path.keys[place - 1].time > scene->camera_keys[k].time; place--)
            path.keys[place] = path.keys[place - 1];
        path.keys[place] = scene->camera_keys[k];
    }
    if (path.closed && path.count > 1) { /* of the last key the time alone counts */
        double time = path.keys[path.count - 1].time;
        path.keys[path.count - 1] = path.keys[0];
        path.keys[path.count - 1].time = time;
    }
    return path;
}

/* One value of the keys, a vector of `count` numbers, found at `offset` in a key. */
struct channel {
    size_t offset;
    int count;
};

static const double *value_at(const struct path *path, const struct channel *channel, int key)
{
    return (const double *)((const char *)(path->keys + key) + channel->offset);
}

/* The mean velocity from one key to the next, and the time that it takes; false where that is none. */
static bool mean_velocity(const struct path *path, const struct channel *channel, int from, double velocity[3],
                          double *seconds)
{
    const double *a = value_at(path, channel, from), *b = value_at(path, channel, from + 1);
    *seconds = path->keys[from + 1].time - path->keys[from].time;
    for (int c = 0; c<channel->count && * seconds> 0; c++)
        velocity[c] = (b[c] - a[c]) / *seconds;
    return *seconds > 0;
}

static double length(const double *vector, int count)
{
    double sum = 0;
    for (int c = 0; c < count; c++)
        sum += vector[c] * vector[c];
    return sqrt(sum);
}

/* The velocity at a key; 0 where the path starts, ends or is cut. */
static void key_velocity(const struct path *path, const struct channel *channel, int key, double velocity[3])
{
    double before[3], after[3], seconds_before, seconds_after;
    int last = path->count - 1, left = key - 1, right = key;
    if (path->closed && (key == 0 || key == last)) {
        left = last - 1;
        right = 0;
    }
    velocity[0] = velocity[1] = velocity[2] = 0;
    if (left < 0 || right >= last || !mean_velocity(path, channel, left, before, &seconds_before) ||
        !mean_velocity(path, channel, right, after, &seconds_after))
        return;
    for (int c = 0; c < channel->count; c++)
        velocity[c] = (before[c] * seconds_after + after[c] * seconds_before) / (seconds_before + seconds_after);
    double speed = length(velocity, channel->count);
    double most = SPEED_MAX * fmin(length(before, channel->count), length(after, channel->count));
    for (int c = 0; c < channel->count && speed > most; c++)
        velocity[c] *= most / speed;
}

/* Hermite's cubic between two keys; `place`: 0 to 1 on the way. */
static void interpolate(const struct path *path, const struct channel *channel, int from, double place, double *value)
{
    const double *a = value_at(path, channel, from), *b = value_at(path, channel, from + 1);
    double at_a[3], at_b[3], seconds = path->keys[from + 1].time - path->keys[from].time, left = 1 - place;
    key_velocity(path, channel, from, at_a);
    key_velocity(path, channel, from + 1, at_b);
    for (int c = 0; c < channel->count; c++)
        value[c] = left * left * ((1 + 2 * place) * a[c] + place * seconds * at_a[c]) +
                   place * place * ((3 - 2 * place) * b[c] - left * seconds * at_b[c]);
}

/* The key's own values. */
static void hold(struct scene_camera *camera, const struct scene_camera_key *key)
{
    memcpy(camera->position, key->position, sizeof camera->position);
    memcpy(camera->target, key->target, sizeof camera->target);
    camera->field_of_view = key->field_of_view;
}

struct scene_camera scene_camera_at(const struct dpl_scene *scene, double time)
{
    static const struct channel position = {offsetof(struct scene_camera_key, position), 3},
                                target = {offsetof(struct scene_camera_key, target), 3},
                                field_of_view = {offsetof(struct scene_camera_key, field_of_view), 1};
    struct scene_camera camera = scene->camera;
    const struct path path = read_path(scene);
    if (path.count < 2)
        return camera;
    double first = path.keys[0].time, round = path.keys[path.count - 1].time - first;
    if (path.closed && round > 0)
        time = first + (time - first) - round * floor((time - first) / round);
    int from = 0;
    while (from < path.count - 1 && path.keys[from + 1].time <= time)
        from++;
    if (time <= first || from == path.count - 1) {
        hold(&camera, path.keys + from);
        return camera;
    }
    double place = (time - path.keys[from].time) / (path.keys[from + 1].time - path.keys[from].time);
    interpolate(&path, &position, from, place, camera.position);
    interpolate(&path, &target, from, place, camera.target);
    interpolate(&path, &field_of_view, from, place, &camera.field_of_view);
    /* Where keys rise and fall again the spline may go a little beyond them. */
    camera.field_of_view = fmin(fmax(camera.field_of_view, SCENE_FIELD_OF_VIEW_MIN), SCENE_FIELD_OF_VIEW_MAX);
    return camera;
}
