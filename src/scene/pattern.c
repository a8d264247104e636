/* What is laid in rows: tiles, planks, blocks of masonry. All are bricks: rows of one height, each shifted along. The
 * GPU's twin is pattern.glsl. */
#include "scene/world.h"

#include <math.h>
#include <string.h>

/* How far a row is shifted along. */
enum shift { SHIFT_NONE, SHIFT_HALF, SHIFT_RANDOM };

static const struct {
    const char *name;
    float length; /* of a brick, in its height */
    enum shift shift;
    float joint; /* share of the height */
    float shade; /* by how much bricks differ in brightness */
} styles[WORLD_PATTERNS] = {[WORLD_PLAIN] = {.name = "plain"},
                            [WORLD_TILES] = {"tiles", 1, SHIFT_NONE, 0.03f, 0.06f},
                            [WORLD_PLANKS] = {"planks", 14, SHIFT_RANDOM, 0.02f, 0.16f},
                            [WORLD_BLOCKS] = {"blocks", 2, SHIFT_HALF, 0.045f, 0.12f}};

const char *world_pattern_name(int i)
{
    return i >= 0 && i < WORLD_PATTERNS ? styles[i].name : NULL;
}

/* 0 to 1 for each brick (integer hash by multiplication and shift, PCG: O'Neill 2014; Jarzynski & Olano 2020). */
static float brick_random(int column, int row)
{
    uint32_t state = (uint32_t)column * 1664525u + (uint32_t)row * 22695477u + 2891336453u;
    state = state * 747796405u + 2891336453u;
    uint32_t word = ((state >> ((state >> 28) + 4)) ^ state) * 277803737u;
    return (float)(((word >> 22) ^ word) >> 8) / 16777216.0f;
}

/* Each whole number has a joint of that width about it. */
static bool in_joint(float place, float joint)
{
    float inside = place + 0.5f * joint;
    return inside - floorf(inside) < joint;
}

void world_color(const struct world_part *part, const float color[3], const float place[2], float reflectance[3])
{
    memcpy(reflectance, color, 3 * sizeof *color);
    if (part->pattern == WORLD_PLAIN)
        return;
    const float size = (float)part->pattern_size, length = styles[part->pattern].length;
    const enum shift shift = styles[part->pattern].shift;
    float across = place[1] / size, row = floorf(across), along = place[0] / (size * length);
    if (shift == SHIFT_HALF)
        along += 0.5f * (row - 2 * floorf(row / 2));
    else if (shift == SHIFT_RANDOM)
        along += brick_random(0, (int)row);
    float joint = styles[part->pattern].joint;
    bool open = !in_joint(along, joint / length) && !in_joint(across, joint);
    float shade = 1 + styles[part->pattern].shade * (2 * brick_random((int)floorf(along), (int)row) - 1);
    for (int c = 0; c < 3; c++)
        reflectance[c] = open ? fminf(color[c] * shade, 1) : (float)part->joint[c];
}
