/* scene/world_copies.h: an object's copies, each at its place. */
#ifndef SCENE_WORLD_COPIES_H
#define SCENE_WORLD_COPIES_H

#include "scene/scene.h"
#include "scene/world_builder.h"

/* Adds the scene's index-th object; `world` has the floor. False (logged) where it could not. */
bool copies_build(struct world_builder *builder, const struct world *world, const struct dpl_scene *scene, int index);

#endif
