/* scene/icosphere.h: a sphere of triangles of about the same size. */
#ifndef SCENE_ICOSPHERE_H
#define SCENE_ICOSPHERE_H

#include "scene/world_builder.h"

/* Adds the unit sphere about the origin: an icosahedron, its edges divided, drawn out to the sphere. It has
 * 10 divisions² + 2 vertices and 20 divisions² triangles. Returns the first vertex's index; position and normal are
 * filled in. */
int icosphere_add(struct world_builder *builder, int divisions);

#endif
