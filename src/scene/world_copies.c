#include "scene/world_copies.h"

#include "base/hash.h"
#include "base/random.h"
#include "scene/shape.h"

#include <math.h>
#include <string.h>

/* One copy. */
struct copy {
    double place[2];    /* m, x and z */
    double turn, scale; /* degrees; of the size */
    int seed;
};

/* The first copy stands as the object's values say. The others turn by the golden angle around it, each as far out as
 * gives all the same share of the disc (Vogel 1979), and a little off, so that no pattern shows. */
static struct copy copy_of(const struct scene_object *object, uint64_t object_seed, int index)
{
    uint64_t seed = object_seed + (uint64_t)index * 4;
    struct copy copy = {{object->position[0], object->position[2]}, object->turn, 1, (int)(random_mix(seed) >> 33)};
    if (index == 0)
        return copy;
    const double golden = M_PI * (3 - sqrt(5)), off = random_fraction(seed + 1) - 0.5;
    double angle = golden * index + off, out = sqrt((index + random_fraction(seed + 2) - 0.5) / object->count);
    copy.place[0] += object->spread * out * cos(angle);
    copy.place[1] += object->spread * out * sin(angle);
    copy.turn += 360 * random_fraction(seed + 3);
    copy.scale = 1 - object->variation * sqrt(random_fraction(seed + 2));
    return copy;
}

static bool build_copy(struct world_builder *builder, const struct world *world, const struct dpl_scene *scene,
                       const struct scene_object *object, const struct copy *copy)
{
    const struct world_part material = builder_material(object);
    struct scene_object scaled = *object;
    double position[3] = {copy->place[0], object->position[1], copy->place[1]}, floor[3];
    int first = builder->vertex_count;
    for (int a = 0; a < 3; a++)
        scaled.size[a] *= copy->scale;
    builder_part(builder, &material);
    if (!scene_shapes[object->shape]->build(builder, &scaled, copy->seed))
        return false;
    if (object->on_floor) {
        world_floor(world, scene->settings.size, position[0], position[2], floor);
        position[1] += floor[0] - scene->settings.depth;
    }
    builder_place(builder, first, copy->turn, object->tilt, position);
    return true;
}

static void fill_color(double color[3], const double own[3])
{
    if (color[0] == 0 && color[1] == 0 && color[2] == 0)
        memcpy(color, own, 3 * sizeof *color);
}

bool copies_build(struct world_builder *builder, const struct world *world, const struct dpl_scene *scene, int index)
{
    struct scene_object object = scene->objects[index];
    const struct scene_shape *shape = scene_shapes[object.shape];
    fill_color(object.color, shape->color[0]);
    fill_color(object.second_color, shape->color[1]);
    /* The name counts, so that two rocks are not the same one. */
    uint64_t seed = hash_bytes(hash_start, scene->object_names[index], strlen(scene->object_names[index]));
    seed = random_mix(hash_number(hash_number(seed, object.seed), scene->settings.seed));
    builder->name = scene->object_names[index];
    for (int k = 0; k < object.count; k++) {
        const struct copy copy = copy_of(&object, seed, k);
        if (!build_copy(builder, world, scene, &object, &copy))
            return false;
    }
    return true;
}
