/* render/lighting.h: from a scene and a time to the water's surface and to caustic maps, each made where the device
 * makes it best. */
#ifndef RENDER_LIGHTING_H
#define RENDER_LIGHTING_H

#include "dapple/renderer.h"
#include "gpu/timer.h"
#include "light/blur.h"
#include "light/map_texture.h"
#include "scene/scene.h"

/* The maps of one technique. All zero: none yet. */
struct lit_map {
    int technique; /* index into light_techniques */
    bool on_cpu;   /* `map` holds it */
    struct light_map map;
    struct map_room room;
    struct gpu_texture texture, blurred;
    struct gpu_texture *shown; /* whichever of the two is finished; NULL: none has been made */
};

/* By the scene's technique; by the one that it is compared with; of light that is thrown back, by the scene's. */
enum { LIT_SCENE, LIT_OTHER, LIT_REFLECTED, LIT_MAPS };

#define LIGHTING_DROPS_MAX 64

struct lighting {
    struct dpl_gl *gl; /* NULL: CPU only */
    enum dpl_device device;
    const struct dpl_log *log;
    struct gpu_timer *timer;
    struct light_progress progress;
    struct wave waves[WATER_WAVES_MAX];
    struct water_setup setup;
    struct water_memory memory;
    struct water_drop drops[LIGHTING_DROPS_MAX]; /* that wait for the next frame */
    int drop_count;
    struct lit_receivers {
        int count;
        double heights[LIGHT_SLICES_MAX];
        struct ray_window windows[LIGHT_SLICES_MAX];
    } below, above;               /* those of LIT_SCENE and LIT_OTHER, and of LIT_REFLECTED */
    struct surface surface, flat; /* flat: as techniques that look straight up see choppy water */
    struct surface_gpu surface_gpu, flat_gpu;
    void *technique_states[2][LIGHT_TECHNIQUES_MAX]; /* of the receivers below, above; made when first used */
    struct light_blur blur;
    struct lit_map maps[LIT_MAPS];
};

/* Has a drop fall into the water of the next frame. False: too many wait already. */
bool lighting_drop(struct lighting *lighting, struct water_drop drop);

/* Makes the surface into `surface`, wherever it is computed. */
bool lighting_make_surface(struct lighting *lighting, const struct dpl_scene *scene, double time);

/* Makes the surface and the maps of the scene's technique, and of `other` (-1: none). `textures`: the GPU needs them
 * all, to draw a picture with; then also those of reflected light, if the scene asks for them. */
bool lighting_make(struct lighting *lighting, const struct dpl_scene *scene, double time, int other, bool textures);

/* The surface on the GPU as it is straight above each place, after textures were made. */
const struct surface_gpu *lighting_above(const struct lighting *lighting);

/* A finished map as a new image. */
struct dpl_image *lighting_image(struct lighting *lighting, struct lit_map *lit, int slice);

void lighting_finish(struct lighting *lighting);

#endif
