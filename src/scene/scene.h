/* scene/scene.h: the scene's values, for the code that renders them. */
#ifndef SCENE_SCENE_H
#define SCENE_SCENE_H

#include "dapple/scene.h"
#include "light/light.h"
#include "optics/sky.h"
#include "scene/camera_path.h"
#include "scene/look.h"
#include "scene/numbered.h"
#include "scene/object.h"
#include "water/water.h"

/* What is at the tile's edges. */
enum scene_edge { SCENE_EDGE_OPEN, SCENE_EDGE_WALLS, SCENE_EDGE_GLASS };

struct scene_settings {
    double size, depth, loop;
    int edge; /* enum scene_edge */
    int seed;
};

struct scene_floor {
    double color[3];
    double contrast, grain;
    double relief_height, relief_length; /* m */
    double relief_turn;                  /* degrees */
    char relief_map[DPL_PARAM_TEXT_SIZE];
    int pattern;         /* enum world_pattern; WORLD_PLAIN: sand */
    double pattern_size; /* m */
    double joint[3];
};

/* Section [current]: how the water goes to and fro, by which what grows in it sways. */
struct scene_current {
    double strength, azimuth; /* degrees */
    double period, length;    /* s, m */
};

enum scene_tone { SCENE_TONE_FILMIC, SCENE_TONE_LINEAR };
enum scene_quality { SCENE_QUALITY_LOW, SCENE_QUALITY_MEDIUM, SCENE_QUALITY_HIGH, SCENE_QUALITY_ULTRA };

struct scene_render {
    int look; /* index into scene_looks */
    double background[3];
    int samples;
    int tone;    /* enum scene_tone */
    int quality; /* enum scene_quality */
    bool wireframe;
};

struct dpl_scene {
    const struct dpl_log *log;
    struct scene_settings settings;
    struct optics_sun sun;
    struct optics_sky_settings sky;
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
    char wave_names[WATER_WAVES_MAX][SCENE_NUMBERED_NAME_SIZE]; /* "wave.1", … */
    struct scene_camera_key camera_keys[SCENE_CAMERA_KEYS_MAX]; /* [camera.N] is entry N - 1 */
    bool camera_key_present[SCENE_CAMERA_KEYS_MAX];
    char camera_key_names[SCENE_CAMERA_KEYS_MAX][SCENE_NUMBERED_NAME_SIZE];
    struct scene_object objects[SCENE_OBJECTS_MAX];
    char object_names[SCENE_OBJECTS_MAX][SCENE_OBJECT_NAME_SIZE]; /* "object.NAME" */
    int object_count;
};

/* The heights of the receivers that the scene asks light for; returns how many, 1 to LIGHT_SLICES_MAX. */
int scene_receivers(const struct dpl_scene *scene, double heights[LIGHT_SLICES_MAX]);

/* The same of those that get light thrown back, beside them; 0 to LIGHT_SLICES_MAX. */
int scene_reflected(const struct dpl_scene *scene, double heights[LIGHT_SLICES_MAX]);

/* The squares of receivers that the scene's maps show; those of periodic water are the tile. */
void scene_windows(const struct dpl_scene *scene, bool periodic, const double *heights, int count,
                   struct ray_window *windows);

/* The parts of a scene that a water model sees. `waves` is room for WATER_WAVES_MAX, filled with those present. */
struct water_setup scene_water_setup(const struct dpl_scene *scene, struct wave *waves);

#endif
