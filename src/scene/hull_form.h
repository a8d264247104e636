/* scene/hull_form.h: the form of a wooden boat, as a surface. */
#ifndef SCENE_HULL_FORM_H
#define SCENE_HULL_FORM_H

/* The point of a hull of that size (length along x, keel to the top of the stem, breadth along z; m), its bow towards
 * +x, its keel at the height 0: `along` from 0 at the transom to 1 at the stem, `up` from 0 at the keel to 1 at the
 * edge. It is the half at z ≥ 0. */
void hull_point(const double size[3], double along, double up, double point[3]);

/* The point at a height in m; where the hull is not as low or as high, its lowest or highest. */
void hull_point_at(const double size[3], double along, double height, double point[3]);

#endif
