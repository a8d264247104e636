/* render/probes.h: light from all around at the vertices of solids, from fewer places of which each has many rays.
 *
 * A probe stands for the vertices of a part that lie in one cell of a grid and face about the same way. A vertex gets
 * the mean of the probes around it, the nearer and the more alike they face the more: so that noise becomes smooth. */
#ifndef RENDER_PROBES_H
#define RENDER_PROBES_H

#include "base/log.h"
#include "scene/world.h"

#include <stdbool.h>

struct probe {
    int part, cell[3];
    float position[3], normal[3];
    float irradiance[3]; /* to be filled by the caller */
};

/* All zero: none. */
struct probes {
    struct probe *all; /* sorted by part and cell */
    int count;
    double *spacing; /* m, the side of a cell, of each part */
    int *parts;      /* of each vertex; -1: of none */
};

/* Places them on the world. False (logged): no memory. */
bool probes_place(struct probes *probes, const struct world *world, const struct dpl_log *log);

/* Irradiance at every vertex of the world, three numbers each. */
void probes_spread(const struct probes *probes, const struct world *world, float *irradiance);

void probes_finish(struct probes *probes);

#endif
