#include "scene/shape.h"

#include "dapple/scene.h"

#include <stddef.h>

extern const struct scene_shape shape_box, shape_pole, shape_sphere, shape_rock, shape_pebbles, shape_seaweed,
    shape_mesh, shape_basin, shape_steps, shape_ladder, shape_hall, shape_cave, shape_quay, shape_hull, shape_tank;

const struct scene_shape *const scene_shapes[] = {
    &shape_box,   &shape_pole,   &shape_sphere, &shape_rock, &shape_pebbles, &shape_seaweed, &shape_mesh, &shape_basin,
    &shape_steps, &shape_ladder, &shape_hall,   &shape_cave, &shape_quay,    &shape_hull,    &shape_tank, NULL};

const char *scene_shape_name(int i)
{
    const int count = sizeof scene_shapes / sizeof *scene_shapes - 1;
    return i >= 0 && i < count ? scene_shapes[i]->name : NULL;
}

struct dpl_entry dpl_shape(int index)
{
    const struct scene_shape *shape = scene_shape_name(index) ? scene_shapes[index] : NULL;
    return shape ? (struct dpl_entry){.name = shape->name, .summary = shape->summary} : (struct dpl_entry){0};
}
