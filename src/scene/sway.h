/* scene/sway.h: how moving water carries what grows in it: slow waves that travel along and across the current. The
 * GPU's twin is sway.glsl. */
#ifndef SCENE_SWAY_H
#define SCENE_SWAY_H

#include "scene/scene.h"

#define SWAY_WAVES 3

/* At one time; the uniforms of sway.glsl as they stand. */
struct sway {
    float waves[SWAY_WAVES][4]; /* whole waves a metre along x, y, z, and the part of one at the origin */
    float current[4];           /* strength along x and z; 0 0 */
};
void sway_now(const struct dpl_scene *scene, double time, struct sway *sway);

/* How far a place is carried, m; `reach` is the vertex's sway. Never farther than reach times strength. */
void sway_move(const struct sway *sway, const float position[3], float reach, float moved[3]);

#endif
