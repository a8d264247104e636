/* reference/camera_scene.h: where rays meet the world of a picture. */
#ifndef REFERENCE_CAMERA_SCENE_H
#define REFERENCE_CAMERA_SCENE_H

#include "reference/camera_tiles.h"
#include "reference/camera_world.h"

/* All zero: none. */
struct camera_scene {
    struct camera_world world;
    RTCDevice device;
    RTCScene solids, casting; /* all triangles, and those that throw shadows; NULL: none */
    struct camera_tiles floor, water;
};

bool camera_scene_make(struct camera_scene *scene, const struct camera_world *world, const struct dpl_log *log);
void camera_scene_finish(struct camera_scene *scene);

enum camera_what { CAMERA_NOTHING, CAMERA_SOLID, CAMERA_WATER };

struct camera_hit {
    enum camera_what what;
    double distance; /* m; CAMERA_FARTHEST where there is nothing */
    double position[3];
    double normal[3]; /* interpolated; of a solid towards where the ray came from, of water into the air */
    double face[3];   /* the same of the mesh */
    double reflectance[3];
    bool casts; /* a solid throws shadows */
};

/* The first meeting of a ray that starts at a surface or in the open. */
struct camera_hit camera_scene_hit(const struct camera_scene *scene, const double origin[3], const double direction[3]);

/* The water's surface alone, nearer than `far`. False: none. */
bool camera_scene_water(const struct camera_scene *scene, const double origin[3], const double direction[3], double far,
                        struct camera_hit *hit);

/* True where nothing solid that throws shadows lies in the way for that many metres. */
bool camera_scene_clear(const struct camera_scene *scene, const double origin[3], const double direction[3],
                        double length);

/* True where nothing of that kind lies between the sun and a place of the water's surface; a wall that touches a side
 * of the water does. */
bool camera_scene_lit(const struct camera_scene *scene, const struct camera_hit *water, const double to_sun[3]);

/* True where a place is in the water. */
bool camera_scene_wet(const struct camera_scene *scene, const double place[3]);

#endif
