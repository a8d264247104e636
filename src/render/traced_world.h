/* render/traced_world.h: the scene as the plain things that reference/ traces rays through. */
#ifndef RENDER_TRACED_WORLD_H
#define RENDER_TRACED_WORLD_H

#include "reference/camera_world.h"
#include "scene/scene.h"
#include "scene/world.h"

/* All zero: none. */
struct traced_world {
    struct camera_world world;
    const struct world *solids;
    const struct dpl_scene *scene;
    float *positions, *normals; /* of the vertices, where the water has carried them */
    bool *casts;                /* of the triangles */
    int *parts;                 /* which of the world's parts a triangle is of */
    struct surface relief;
    unsigned char *sand; /* sand_side² × 4: reflectance of the tile's floor, 0 to 255; NULL: floor.color */
    int sand_side;
};

/* Of the scene at a time, with the water at rest. `scene`, `solids` and `sky` outlive it. */
bool traced_world_make(struct traced_world *traced, const struct dpl_scene *scene, const struct world *solids,
                       const struct optics_sky *sky, double time, const struct dpl_log *log);
void traced_world_finish(struct traced_world *traced);

#endif
