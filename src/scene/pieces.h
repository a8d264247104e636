/* scene/pieces.h: what built shapes consist of: panels, blocks and tubes. */
#ifndef SCENE_PIECES_H
#define SCENE_PIECES_H

#include "scene/world_builder.h"

/* The object's material; where the object gives no pattern, with this one. */
struct world_part piece_material(const struct scene_object *object, int pattern);

/* Adds a face as builder_face() does, with cells as narrow as asked for also where it is large. */
void piece_panel(struct world_builder *builder, const double corner[3], const double right[3], const double up[3],
                 double cell, const double color[3]);

/* The same, but that it reaches `over` m beyond its edges, through what it meets there: faces that only touch let light
 * through. Its pattern starts at the corner all the same. */
void piece_panel_over(struct world_builder *builder, const double corner[3], const double right[3], const double up[3],
                      double over, double cell, const double color[3]);

/* Moves the pattern of what was built from vertex `first` on, m: so that it goes on from face to face. */
void piece_move_pattern(struct world_builder *builder, int first, double across, double up);

/* Adds the six sides of a block, seen from outside. */
void piece_block(struct world_builder *builder, const double low[3], const double high[3], double cell,
                 const double color[3]);

/* Adds a round tube along a line of points, with flat ends. */
void piece_tube(struct world_builder *builder, const double (*line)[3], int points, double radius, int sides,
                const double color[3]);

#endif
