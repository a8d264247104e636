/* scene/world_floor.h: the relief of the floor: ripples of sand, or heights from a picture. */
#ifndef SCENE_WORLD_FLOOR_H
#define SCENE_WORLD_FLOOR_H

#include "scene/scene.h"
#include "scene/world.h"

/* Fills the relief of a world that has none. False (logged): no memory, or a picture that cannot be used. */
bool floor_build(struct world *world, const struct dpl_scene *scene, const struct dpl_log *log);

#endif
