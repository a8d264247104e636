/* scene/world.h: everything solid in a scene as triangles, for who draws it and for who traces rays.
 *
 * A section [object.NAME] of scene text is one object of a shape (scene/shape.h); the floor is a height over the tile.
 * Both are made from the scene's values alone, at rest; what sways in the water is moved by sway_move(), whose twin is
 * scene/sway.glsl. */
#ifndef SCENE_WORLD_H
#define SCENE_WORLD_H

#include "dapple/scene.h"

#include <stddef.h>
#include <stdint.h>

struct world_vertex {
    float position[3]; /* m */
    float normal[3];   /* unit, out of the object */
    float color[3];    /* diffuse reflectance, linear */
    float place[2];    /* m along the surface: where a pattern is looked up */
    float sway;        /* m that a current of strength 1 carries it sideways; 0: it stands still */
};

enum world_pattern { WORLD_PLAIN, WORLD_TILES, WORLD_PLANKS, WORLD_BLOCKS, WORLD_PATTERNS };

/* The i-th pattern's name, NULL past the last: the choices of `object.NAME.pattern`. */
const char *world_pattern_name(int i);

/* Triangles of one material. */
struct world_part {
    int first, count;    /* in `indices` */
    int pattern;         /* enum world_pattern */
    double pattern_size; /* m, of a tile, a plank's width, a block's height */
    double joint[3];     /* reflectance between tiles */
    bool two_sided;      /* leaves: lit on whichever side is seen */
    bool casts;          /* throws a shadow on other things (walls of an enclosure may not) */
};

/* All zero: none yet. */
struct world {
    struct world_vertex *vertices;
    unsigned *indices; /* three a triangle, counter-clockwise seen from outside */
    struct world_part *parts;
    int vertex_count, index_count, part_count;
    double low[3], high[3]; /* world_box() of all of it */

    int relief_side;      /* vertices of the floor a side of the tile, periodic; 0: flat */
    float *relief;        /* relief_side²: m above the flat floor; row 0 is the smallest z */
    uint64_t fingerprint; /* of what it was made from; changes when the world changes */
};

/* Makes the world of the scene, or leaves it where nothing changed. False (logged): no memory, or a file that cannot be
 * used; then the world stays as it was. */
bool world_build(struct world *world, const struct dpl_scene *scene, const struct dpl_log *log);
void world_finish(struct world *world);

/* The box around all triangles that come above a level, m, and around the ways that a current of that strength may
 * carry them; low > high: there are none. */
void world_box(const struct world *world, double strength, double level, double low[3], double high[3]);

/* Reflectance there: the vertices' colour, interpolated, with the part's pattern on it. scene/pattern.glsl is its
 * twin. */
void world_color(const struct world_part *part, const float color[3], const float place[2], float reflectance[3]);

/* The floor's height and slopes at a place, m above -depth, interpolated; 0 where it is flat. */
void world_floor(const struct world *world, double tile_size, double x, double z, double height_slopes[3]);

#endif
