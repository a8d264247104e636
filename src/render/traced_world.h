/* render/traced_world.h: the scene as those who trace rays through it see it (reference/camera_world.h). */
#ifndef RENDER_TRACED_WORLD_H
#define RENDER_TRACED_WORLD_H

#include "reference/camera_world.h"
#include "scene/scene.h"
#include "scene/world.h"

/* All zero: none yet. What it points to stays the caller's. */
struct traced_world {
    struct camera_world camera;
    struct scene_floor floor; /* of the scene */
    const struct world *solids;
    float *positions, *normals; /* of the solids' vertices, carried by the current */
    bool *casts;                /* of each triangle */
    int *parts;                 /* that each triangle belongs to */
    struct surface relief;
    unsigned char *sand; /* sand_side² × 4: reflectance of a sandy floor over the tile, 0 to 255; NULL: its mean */
    int sand_side;
};

/* Makes it of the scene at a time, with water whose surface is `water`, or at rest: NULL. `periodic`: water and floor
 * have no end. */
bool traced_world_make(struct traced_world *traced, const struct dpl_scene *scene, const struct world *solids,
                       const struct optics_sky *sky, const struct surface *water, bool periodic, double time,
                       const struct dpl_log *log);

void traced_world_finish(struct traced_world *traced);

#endif
