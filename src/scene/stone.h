/* scene/stone.h: the form and the colours of a stone, for rocks and for pebbles. */
#ifndef SCENE_STONE_H
#define SCENE_STONE_H

#include "scene/world_builder.h"

struct stone_style {
    int divisions;    /* of an icosahedron's edges: 20 divisions² triangles */
    int planes;       /* that the stone has broken along */
    double roundness; /* 0: sharp edges between them; 1: nearly a ball */
    double roughness; /* of its surface, in half sizes */
    double layers;    /* of sediment, a half size; 0: none */
    bool grown_over;  /* dark growth low down and in hollows, pale above */
};

/* Adds one stone, as struct scene_shape's build() wants. */
bool stone_build(struct world_builder *builder, const struct scene_object *object, int seed,
                 const struct stone_style *style);

#endif
