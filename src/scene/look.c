#include "scene/look.h"

#include "dapple/scene.h"

extern const struct scene_look look_physical, look_collard, look_pool, look_sanchez_crespo, look_fourier,
    look_path_traced;

const struct scene_look *const scene_looks[] = {&look_physical, &look_collard,     &look_pool, &look_sanchez_crespo,
                                                &look_fourier,  &look_path_traced, NULL};
_Static_assert(sizeof scene_looks / sizeof *scene_looks - 1 <= SCENE_LOOKS_MAX, "room for the state of each");

const char *scene_look_name(int i)
{
    const int count = sizeof scene_looks / sizeof *scene_looks - 1;
    return i >= 0 && i < count ? scene_looks[i]->name : NULL;
}

struct dpl_entry dpl_look(int index)
{
    const struct scene_look *look = scene_look_name(index) ? scene_looks[index] : NULL;
    return look ? (struct dpl_entry){.name = look->name, .summary = look->summary} : (struct dpl_entry){0};
}
