/* dapple/scene.h: what is to be rendered, as values that can be read from text, set by name, listed and saved.
 *
 * A scene is a list of sections; a section is a struct of values with a table that describes them (dapple/param.h).
 * `section.key` names a value everywhere: "sun.elevation", "wave.2.cycles", "multi-sample.steps".
 *
 * Threads: a scene may be used by one thread at a time. */
#ifndef DAPPLE_SCENE_H
#define DAPPLE_SCENE_H

#include "dapple/param.h"

#ifdef __cplusplus
extern "C" {
#endif

struct dpl_scene;

/* A section as controls and documentation see it. Valid until a section is taken away, or the scene is loaded anew or
 * destroyed. */
struct dpl_section {
    const char *name; /* as in scene text, without brackets */
    const char *help; /* one line */
    const struct dpl_param *params;
    void *values; /* the struct that `params` describes; write to it only through dpl_scene_set() */
    bool active;  /* false: belongs to a water model, technique or look that the scene does not use now */
};

/* A scene that comes with dapple. */
struct dpl_builtin_scene {
    const char *name;    /* NULL ends the list */
    const char *summary; /* one line */
    const char *text;    /* scene text */
};
DPL_API const struct dpl_builtin_scene *dpl_builtin_scenes(void);

/* Every value at its default. Returns NULL where memory is short. Destroy takes NULL. */
DPL_API struct dpl_scene *dpl_scene_create(const struct dpl_log *log);
DPL_API void dpl_scene_destroy(struct dpl_scene *scene);

/* Replaces the scene by a file, or, where no file of that name exists, by the built-in scene of that name. Values
 * that the text does not name get their defaults. Names of files in a scene's file are as from its folder. On failure
 * the scene stays as it was. */
DPL_API bool dpl_scene_load(struct dpl_scene *scene, const char *path_or_name);

/* The same from `length` bytes of text; `name` stands for the file in messages. */
DPL_API bool dpl_scene_read(struct dpl_scene *scene, const char *name, const char *text, size_t length);

/* Sets one value, checked as in scene text. `wave.N`, `camera.N` and `object.NAME` come into being when one of their
 * keys is set; N is 1 to 64, and 1 to 16; NAME is a word of letters, digits and `-`, and there may be 64 objects. */
DPL_API bool dpl_scene_set(struct dpl_scene *scene, const char *key, const char *value);

/* Takes away a section that came into being so, "wave.3". True also where a wave or a key is not there; false
 * (logged) for an object that is not there and for what is always there. */
DPL_API bool dpl_scene_remove(struct dpl_scene *scene, const char *section);

/* Writes one value as text. False (logged) where the key is unknown or `size` is too small. */
DPL_API bool dpl_scene_get(const struct dpl_scene *scene, const char *key, char *value, size_t size);

/* Writes the whole scene as text that dpl_scene_load() reads back to the same scene; whole or not at all. */
DPL_API bool dpl_scene_save(const struct dpl_scene *scene, const char *path);

/* The view at a time: that of [camera], or where two or more keys [camera.N] make a path, the place on it. */
struct dpl_view {
    double position[3], target[3]; /* m */
    double field_of_view;          /* degrees, of the picture's height */
};
DPL_API struct dpl_view dpl_scene_view(const struct dpl_scene *scene, double time);

/* The scene's sections, one at a time; NULL-named past the last. */
DPL_API struct dpl_section dpl_scene_section(const struct dpl_scene *scene, int index);

/* What `dapple list` shows: names and one line each of the water models, the techniques, the looks and the shapes of
 * objects, NULL past the last. */
struct dpl_entry {
    const char *name, *summary, *source;
    /* Of a technique: */
    bool physical; /* its map is irradiance in units of what flat water would give; else it is tuned by eye */
    double energy; /* of a physical one: how far, at its defaults, the mean of a periodic map may be off, a share */
    bool reflects; /* serves a ceiling above the water too */
    bool refines;  /* its map gets better step by step: see dpl_renderer_progress() */
    /* Of a water model: */
    bool disturbed; /* drops and the sphere move it */
};
DPL_API struct dpl_entry dpl_water_model(int index);
DPL_API struct dpl_entry dpl_technique(int index);
DPL_API struct dpl_entry dpl_look(int index);
DPL_API struct dpl_entry dpl_shape(int index); /* of objects */

#ifdef __cplusplus
}
#endif

#endif
