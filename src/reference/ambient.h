/* reference/ambient.h: light from all around: what comes to a place other than straight from the sun.
 *
 * That is the sky's light, through water at rest where water lies between, and the light of sun and sky that solids and
 * the water have thrown there. The sun's light that comes straight, or over the water's surface alone, is left out:
 * that is for caustic maps. */
#ifndef REFERENCE_AMBIENT_H
#define REFERENCE_AMBIENT_H

#include "reference/camera_world.h"

/* Irradiance at `count` places on surfaces of those normals, `count` × 3 each, by as many paths from each as `rays`
 * says of it; what waves the water has makes no difference. All places use the same directions about their normals,
 * turned for each, so that what noise there is varies evenly. The same for any number of threads. False (logged): no
 * memory. */
bool ambient_bake(const struct camera_world *world, int count, const float *positions, const float *normals,
                  const int *rays, float *irradiance, const struct dpl_log *log);

/* Whether no solid and no floor stands between `count` pairs of places, 2 × 3 numbers each. False (logged): no memory.
 */
bool ambient_clear(const struct camera_world *world, int count, const float *pairs, bool *clear,
                   const struct dpl_log *log);

#endif
