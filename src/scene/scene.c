#include "scene/scene.h"

#include "base/log.h"
#include "light/detail.h"
#include "optics/refraction.h"
#include "scene/world.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *edge_name(int i)
{
    static const char *const names[] = {"open", "walls", "glass", NULL};
    return names[i];
}

static const struct dpl_param settings_params[] = {
    PARAM_FLOAT(struct scene_settings, size, 4, 0.01, 10000, "m", "side of the square tile of water"),
    PARAM_FLOAT(struct scene_settings, depth, 1, 0, 1000, "m", "from the rest surface down to the floor"),
    PARAM_FLOAT(struct scene_settings, loop, 0, 0, 3600, "s", "every wave repeats after this time; 0 = no loop"),
    PARAM_CHOICE(struct scene_settings, edge, SCENE_EDGE_OPEN, edge_name,
                 "where water and floor end (looks physical and path-traced): open = at the horizon, or at the tile's "
                 "edges where the "
                 "model is bounded; walls = at the tile's edges; glass = the same, and one sees in from outside"),
    PARAM_INT(struct scene_settings, seed, 1, 0, 1000000, "", "start of everything random (grains of sand, photons)"),
    PARAM_END,
};

static const struct dpl_param camera_params[] = {
    PARAM_FLOATS(struct scene_camera, position, 3, -10000, 10000, "m", "place of the eye", 0, 0.2, 4),
    PARAM_FLOATS(struct scene_camera, target, 3, -10000, 10000, "m", "place that is looked at", 0, -0.6, 0),
    PARAM_FLOAT(struct scene_camera, field_of_view, 45, SCENE_FIELD_OF_VIEW_MIN, SCENE_FIELD_OF_VIEW_MAX, "degrees",
                "height of the view"),
    PARAM_FLOAT(struct scene_camera, near_plane, 0.1, 0.001, 9, "m", "nothing nearer is seen"),
    PARAM_FLOAT(struct scene_camera, far_plane, 100, 10, 100000, "m", "nothing farther is seen"),
    PARAM_FLOAT(struct scene_camera, exposure, 0, -20, 20, "stops",
                "of looks with linear light: each stop doubles the picture's brightness; at 0 what is white in full "
                "daylight is near white"),
    PARAM_COLOR(struct scene_camera, white, 4,
                "of looks with linear light: the light that looks white; that of the sun and the sky at noon", 1.1,
                0.98, 0.9),
    PARAM_BOOL(struct scene_camera, closed, false,
               "its path, [camera.1] and so on, is round: at the last key's time it is back at the first key"),
    PARAM_END,
};

/* Where nothing is laid, there is sand. */
static const char *floor_pattern_name(int i)
{
    return i == WORLD_PLAIN ? "sand" : world_pattern_name(i);
}

static const struct dpl_param floor_params[] = {
    PARAM_COLOR(struct scene_floor, color, 1, "mean colour of the sand", 0.71, 0.67, 0.51),
    PARAM_FLOAT(struct scene_floor, contrast, 1, 0, 4, "", "how much the sand's brightness varies; 0 = plain"),
    PARAM_FLOAT(struct scene_floor, grain, 0.008, 0.0005, 1, "m", "size of the smallest spots of the sand"),
    PARAM_FLOAT(struct scene_floor, relief_height, 0, 0, 100, "m",
                "looks physical and path-traced: how high the ripples of the sand are; 0 = flat"),
    PARAM_FLOAT(struct scene_floor, relief_length, 0.25, 0.001, 1000, "m",
                "from one crest of the ripples to the next, at least 1/256 of the tile"),
    PARAM_FLOAT(struct scene_floor, relief_turn, 20, -360, 360, "degrees", "way across the crests, from +x towards +z"),
    PARAM_TEXT(
        struct scene_floor, relief_map,
        "picture of the relief over the tile in place of ripples: black is relief_height below the mean, white as "
        "much above"),
    PARAM_CHOICE(struct scene_floor, pattern, WORLD_PLAIN, floor_pattern_name, "what the floor is laid with"),
    PARAM_FLOAT(struct scene_floor, pattern_size, 0.15, 0.001, 1000, "m",
                "side of a tile, width of a plank, height of a block"),
    PARAM_COLOR(struct scene_floor, joint, 1, "reflectance between tiles, planks or blocks", 0.5, 0.5, 0.48),
    PARAM_END,
};

static const struct dpl_param current_params[] = {
    PARAM_FLOAT(struct scene_current, strength, 1, 0, 10, "", "how far plants sway; 0 = they stand still"),
    PARAM_FLOAT(struct scene_current, azimuth, 20, -360, 360, "degrees",
                "way that they sway along, from +x towards +z"),
    PARAM_FLOAT(struct scene_current, period, 4, 0.1, 1000, "s",
                "of one sway; where the scene loops a part of its loop"),
    PARAM_FLOAT(struct scene_current, length, 5, 0.1, 10000, "m", "from places that sway alike to the next"),
    PARAM_END,
};

static const char *tone_name(int i)
{
    static const char *const names[] = {"filmic", "linear", NULL};
    return names[i];
}

static const char *quality_name(int i)
{
    static const char *const names[] = {"low", "medium", "high", "ultra", NULL};
    return names[i];
}

static const struct dpl_param render_params[] = {
    PARAM_CHOICE(struct scene_render, look, 0, scene_look_name, "how the scene is shaded"),
    PARAM_COLOR(struct scene_render, background, 1, "colour where there is nothing", 51.0 / 255, 71.0 / 255,
                79.0 / 255),
    PARAM_INT(struct scene_render, samples, 1, 1, 16, "",
              "samples a pixel, for smooth edges; the device takes the next number that it has"),
    PARAM_CHOICE(struct scene_render, tone, SCENE_TONE_FILMIC, tone_name,
                 "of looks with linear light: filmic = highlights roll off as on film; linear = what is too bright is "
                 "cut off"),
    PARAM_CHOICE(struct scene_render, quality, SCENE_QUALITY_MEDIUM, quality_name,
                 "how much work a picture is worth to looks that have a choice: steps, resolution, samples of light"),
    PARAM_BOOL(struct scene_render, wireframe, false, "draw only the edges of triangles"),
    PARAM_END,
};

/* Sections whose number is fixed. */
struct fixed_section {
    const char *name, *help;
    const struct dpl_param *params;
    size_t offset; /* of the values in struct dpl_scene */
};
static const struct fixed_section fixed_sections[] = {
    {"scene", "the tile of water", settings_params, offsetof(struct dpl_scene, settings)},
    {"sun", "the sun (multi-sample, pixel-ray and vertex-ray have their own, straight overhead)", optics_sun_params,
     offsetof(struct dpl_scene, sun)},
    {"sky", "the light of sun and sky (look `physical`)", optics_sky_params, offsetof(struct dpl_scene, sky)},
    {"water", "the water and its waves", water_medium_params, offsetof(struct dpl_scene, medium)},
    {"sphere", "a ball in the water", water_sphere_params, offsetof(struct dpl_scene, sphere)},
    {"caustics", "the caustic map", light_settings_params, offsetof(struct dpl_scene, caustics)},
    {"camera", "the view", camera_params, offsetof(struct dpl_scene, camera)},
    {"floor", "the floor: its sand, its relief", floor_params, offsetof(struct dpl_scene, floor)},
    {"current", "water that goes to and fro below the waves, and plants with it", current_params,
     offsetof(struct dpl_scene, current)},
    {"render", "the picture", render_params, offsetof(struct dpl_scene, render)},
};
enum { FIXED_COUNT = sizeof fixed_sections / sizeof *fixed_sections };

static void *allocate_params(const struct dpl_param *params, size_t size, const struct dpl_log *log)
{
    void *values = params ? base_allocate(log, 1, size, "scene") : NULL;
    if (values)
        param_defaults(params, values);
    return values;
}

struct dpl_scene *dpl_scene_create(const struct dpl_log *log)
{
    struct dpl_scene *scene = base_allocate(log, 1, sizeof *scene, "scene");
    if (!scene)
        return NULL;
    scene->log = log;
    for (int i = 0; i < FIXED_COUNT; i++)
        param_defaults(fixed_sections[i].params, (char *)scene + fixed_sections[i].offset);
    for (int o = 0; o < SCENE_OBJECTS_MAX; o++)
        param_defaults(scene_object_params, scene->objects + o);
    scene_numbered_start(scene);
    bool ok = true;
    for (int i = 0; water_models[i]; i++) {
        const struct water_model *model = water_models[i];
        scene->model_params[i] = allocate_params(model->params, model->params_size, log);
        ok = ok && (!model->params || scene->model_params[i]);
    }
    for (int i = 0; light_techniques[i]; i++) {
        const struct light_technique *technique = light_techniques[i];
        scene->technique_params[i] = allocate_params(technique->params, technique->params_size, log);
        ok = ok && (!technique->params || scene->technique_params[i]);
    }
    for (int i = 0; scene_looks[i]; i++) {
        scene->look_params[i] = allocate_params(scene_looks[i]->params, scene_looks[i]->params_size, log);
        ok = ok && scene->look_params[i];
    }
    if (ok)
        return scene;
    dpl_scene_destroy(scene);
    return NULL;
}

void dpl_scene_destroy(struct dpl_scene *scene)
{
    if (!scene)
        return;
    for (int i = 0; water_models[i]; i++)
        free(scene->model_params[i]);
    for (int i = 0; light_techniques[i]; i++)
        free(scene->technique_params[i]);
    for (int i = 0; scene_looks[i]; i++)
        free(scene->look_params[i]);
    free(scene);
}

static bool model_moves(const struct dpl_scene *scene, int model)
{
    return water_model_has(scene->medium.model, model, (const void *const *)scene->model_params);
}

struct dpl_section dpl_scene_section(const struct dpl_scene *scene, int index)
{
    char *base = (char *)scene;
    if (index < FIXED_COUNT) {
        const struct fixed_section *fixed = fixed_sections + index;
        return (struct dpl_section){fixed->name, fixed->help, fixed->params, base + fixed->offset, true};
    }
    index -= FIXED_COUNT;
    for (int i = 0; water_models[i]; i++)
        if (water_models[i]->params && index-- == 0)
            return (struct dpl_section){water_models[i]->name, water_models[i]->summary, water_models[i]->params,
                                        scene->model_params[i], model_moves(scene, i)};
    for (int i = 0; light_techniques[i]; i++)
        if (light_techniques[i]->params && index-- == 0)
            return (struct dpl_section){light_techniques[i]->name, light_techniques[i]->summary,
                                        light_techniques[i]->params, scene->technique_params[i],
                                        scene->caustics.technique == i};
    for (int i = 0; scene_looks[i]; i++)
        if (index-- == 0)
            return (struct dpl_section){scene_looks[i]->section, scene_looks[i]->summary, scene_looks[i]->params,
                                        scene->look_params[i], scene->render.look == i};
    struct dpl_section numbered = scene_numbered_section(scene, &index);
    if (numbered.name || index >= scene->object_count)
        return numbered;
    return (struct dpl_section){scene->object_names[index], "one object, or copies of one", scene_object_params,
                                base + ((char *)(scene->objects + index) - (char *)scene), true};
}

struct water_setup scene_water_setup(const struct dpl_scene *scene, struct wave *waves)
{
    int count = 0;
    for (int w = 0; w < WATER_WAVES_MAX; w++)
        if (scene->wave_present[w])
            waves[count++] = scene->waves[w];
    double receivers[LIGHT_SLICES_MAX];
    struct water_setup setup = {
        .size = scene->settings.size,
        .depth = scene->settings.depth,
        .loop = scene->settings.loop,
        .mesh = scene->caustics.mesh,
        .seed = scene->settings.seed,
        .sphere = &scene->sphere,
        .waves = waves,
        .wave_count = count,
        .params = scene->model_params[scene->medium.model],
        .all_params = (const void *const *)scene->model_params,
    };
    scene_receivers(scene, receivers);
    double spread = sin(scene->sun.angular_radius * M_PI / 180) / (receivers[0] < 0 ? scene->medium.ior : 1);
    double blur = fmax(setup.size / scene->caustics.map, fabs(receivers[0]) * spread);
    if (setup.mesh == 0 && water_models[scene->medium.model]->shape(&setup).side == 0)
        setup.mesh = light_choose_mesh(water_models[scene->medium.model], &setup, receivers[0], scene->medium.ior, blur,
                                       scene->caustics.error / 100);
    return setup;
}

int scene_receivers(const struct dpl_scene *scene, double heights[LIGHT_SLICES_MAX])
{
    const double nearest = 1e-6; /* m; a receiver lies on one side of the rest surface */
    int count = scene->caustics.ceiling > 0 ? 1 : scene->caustics.slices;
    heights[0] = fmax(scene->caustics.ceiling, nearest);
    for (int k = 0; k < count && scene->caustics.ceiling == 0; k++)
        heights[k] = -fmax(scene->settings.depth * (count - k) / count, nearest);
    return count;
}

int scene_reflected(const struct dpl_scene *scene, double heights[LIGHT_SLICES_MAX])
{
    int count = scene->caustics.reflected_slices;
    for (int k = 0; k < count; k++)
        heights[k] = scene->caustics.reflected_height * (k + 1) / count;
    return count;
}

void scene_windows(const struct dpl_scene *scene, bool periodic, const double *heights, int count,
                   struct ray_window *windows)
{
    const double up[3] = {0, 1, 0}, flattest = 1e-3; /* of a ray: lower ones leave the window where it is */
    double to_sun[3], ray[3], size = scene->settings.size;
    double margin = periodic ? 0 : scene->caustics.margin * size;
    bool follows = !periodic && scene->caustics.window == LIGHT_WINDOW_LIGHT;
    optics_sun_direction(&scene->sun, to_sun);
    for (int k = 0; k < count; k++) {
        double along[2] = {0, 0};
        if (heights[k] > 0)
            optics_reflect(to_sun, up, ray);
        else
            optics_refract(to_sun, up, scene->medium.ior, ray);
        for (int a = 0; a < 2 && follows && fabs(ray[1]) > flattest; a++)
            along[a] = ray[2 * a] / ray[1] * heights[k];
        windows[k] = (struct ray_window){along[0] - size / 2 - margin, along[1] - size / 2 - margin, size + 2 * margin};
    }
}

struct dpl_view dpl_scene_view(const struct dpl_scene *scene, double time)
{
    struct scene_camera camera = scene_camera_at(scene, time);
    struct dpl_view view = {.field_of_view = camera.field_of_view};
    memcpy(view.position, camera.position, sizeof view.position);
    memcpy(view.target, camera.target, sizeof view.target);
    return view;
}

struct dpl_entry dpl_water_model(int index)
{
    const struct water_model *model = water_model_name(index) ? water_models[index] : NULL;
    return model ? (struct dpl_entry){.name = model->name,
                                      .summary = model->summary,
                                      .source = model->source,
                                      .disturbed = model->disturbed}
                 : (struct dpl_entry){0};
}

struct dpl_entry dpl_technique(int index)
{
    const struct light_technique *technique = light_technique_name(index) ? light_techniques[index] : NULL;
    return technique ? (struct dpl_entry){.name = technique->name,
                                          .summary = technique->summary,
                                          .source = technique->source,
                                          .physical = technique->physical,
                                          .energy = technique->energy,
                                          .reflects = technique->reflects,
                                          .refines = technique->refines}
                     : (struct dpl_entry){0};
}
