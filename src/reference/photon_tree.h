/* reference/photon_tree.h: photons where they have come to, and which of them lie near a place: a balanced k-d tree
 * (Bentley 1975) in the order of the array itself. */
#ifndef REFERENCE_PHOTON_TREE_H
#define REFERENCE_PHOTON_TREE_H

#include <stdbool.h>

struct photon {
    float position[3];
    float vector[3]; /* of a photon on a solid its normal there, of one in the water the way it goes */
    float flux[3];   /* in the water: times the way that it stands for, m */
};

struct photon_tree {
    struct photon *photons;
    unsigned char *axes; /* that the photon at that index divides */
    int count;
};

/* Orders `count` photons. The order depends on the photons alone. */
void photon_tree_build(struct photon_tree *tree);

/* Calls `visit` for each photon nearer than the radius, in the order of the tree. */
void photon_tree_visit(const struct photon_tree *tree, const double place[3], double radius,
                       void (*visit)(void *user, const struct photon *photon), void *user);

#endif
