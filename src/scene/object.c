#include "scene/object.h"

#include "scene/shape.h"
#include "scene/world.h"

const struct dpl_param scene_object_params[] = {
    PARAM_CHOICE(struct scene_object, shape, 0, scene_shape_name, "what it is; `dapple list shapes` says more"),
    PARAM_TEXT(struct scene_object, file, "of the shape mesh: a file .obj .gltf .glb .ply .stl, y upwards"),
    PARAM_FLOATS(struct scene_object, position, 3, -10000, 10000, "m", "middle of its base", 0, 0, 0),
    PARAM_BOOL(struct scene_object, on_floor, true, "its height counts from the floor below it; no: from the water"),
    PARAM_FLOATS(struct scene_object, size, 3, 0.001, 10000, "m", "along x, y and z, before it is turned", 1, 1, 1),
    PARAM_FLOAT(struct scene_object, turn, 0, -360, 360, "degrees", "about the vertical, from +x towards +z"),
    PARAM_FLOAT(struct scene_object, tilt, 0, -180, 180, "degrees", "of its top towards its own +x"),
    PARAM_COLOR(struct scene_object, color, 1, "reflectance; 0 0 0 = the shape's own", 0, 0, 0),
    PARAM_COLOR(struct scene_object, second_color, 1, "what its colour varies towards; 0 0 0 = the shape's own", 0, 0,
                0),
    PARAM_INT(struct scene_object, count, 1, 1, 10000, "", "copies, each a little different"),
    PARAM_FLOAT(struct scene_object, spread, 1, 0, 10000, "m", "radius of the disc that several copies stand in"),
    PARAM_FLOAT(struct scene_object, variation, 0.5, 0, 0.95, "", "share of its size by which a copy may be smaller"),
    PARAM_INT(struct scene_object, seed, 1, 0, 1000000, "", "start of what is random in its shape and its copies"),
    PARAM_FLOAT(struct scene_object, sway, 1, 0, 10, "",
                "how far a current carries it, in that of its shape; 0 = stiff"),
    PARAM_CHOICE(struct scene_object, pattern, WORLD_PLAIN, world_pattern_name, "of its surface"),
    PARAM_FLOAT(struct scene_object, pattern_size, 0.15, 0.001, 1000, "m",
                "side of a tile, width of a plank, height of a block"),
    PARAM_COLOR(struct scene_object, joint, 1, "reflectance between tiles, planks or blocks", 0.5, 0.5, 0.48),
    PARAM_BOOL(struct scene_object, casts, true, "throws a shadow"),
    PARAM_END,
};
