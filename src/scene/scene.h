/* scene/scene.h: the scene's values, for the code that renders them. */
#ifndef SCENE_SCENE_H
#define SCENE_SCENE_H

#include "dapple/scene.h"
#include "light/light.h"
#include "scene/look.h"
#include "scene/object.h"
#include "water/water.h"

struct scene_settings {
    double size, depth, loop;
    int seed;
};

struct scene_camera {
    double position[3], target[3];
    double field_of_view; /* degrees, vertical */
    double near_plane, far_plane;
};

struct scene_floor {
    double color[3];
    double contrast, grain;
    double relief_height, relief_length; /* m */
    double relief_turn;                  /* degrees */
    char relief_map[DPL_PARAM_TEXT_SIZE];
    double extent;       /* m; 0: endless */
    int pattern;         /* enum world_pattern; WORLD_PLAIN: sand */
    double pattern_size; /* m */
    double joint[3];
};

/* Section [current]: how the water goes to and fro, by which what grows in it sways. */
struct scene_current {
    double strength, azimuth; /* degrees */
    double period, length;    /* s, m */
};

struct scene_render {
    int look; /* index into scene_looks */
    double background[3];
    int samples;
    bool wireframe;
};

struct dpl_scene {
    const struct dpl_log *log;
    struct scene_settings settings;
    struct optics_sun sun;
    struct water_medium medium;
    struct water_sphere sphere;
    struct light_settings caustics;
    struct scene_camera camera;
    struct scene_floor floor;
    struct scene_current current;
    struct scene_render render;
    void *model_params[WATER_MODELS_MAX];         /* as water_models; NULL: it has none */
    void *technique_params[LIGHT_TECHNIQUES_MAX]; /* as light_techniques */
    void *look_params[SCENE_LOOKS_MAX];           /* as scene_looks */
    struct wave waves[WATER_WAVES_MAX];           /* [wave.N] is entry N - 1 */
    bool wave_present[WATER_WAVES_MAX];
    char wave_names[WATER_WAVES_MAX][12]; /* "wave.1", … */
    struct scene_object objects[SCENE_OBJECTS_MAX];
    char object_names[SCENE_OBJECTS_MAX][SCENE_OBJECT_NAME_SIZE]; /* "object.NAME" */
    int object_count;
};

/* The heights of the receivers that the scene asks light for; returns how many, 1 to LIGHT_SLICES_MAX. */
int scene_receivers(const struct dpl_scene *scene, double heights[LIGHT_SLICES_MAX]);

/* The squares of the receivers that the scene's maps show; those of periodic water are the tile. */
void scene_windows(const struct dpl_scene *scene, bool periodic, struct ray_window windows[LIGHT_SLICES_MAX]);

/* The parts of a scene that a water model sees. `waves` is room for WATER_WAVES_MAX, filled with those present. */
struct water_setup scene_water_setup(const struct dpl_scene *scene, struct wave *waves);

#endif
