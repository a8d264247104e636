#include "scene/world.h"

#include <stddef.h>

const char *world_pattern_name(int i)
{
    static const char *const names[WORLD_PATTERNS] = {"plain", "tiles", "planks", "blocks"};
    return i >= 0 && i < WORLD_PATTERNS ? names[i] : NULL;
}
