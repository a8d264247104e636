/* touch.h: a hand in the water: what the left button takes hold of, as in Wallace's "WebGL Water" (2011).
 *
 * In a scene with a sphere, a press on it drags it, across the line of sight; where water can be disturbed, a press on
 * the water makes drops along the way of the mouse. A press on anything else is left to the camera. A press that meets
 * the water goes on through it as through flat water, so that the sphere is where it is seen. */
#ifndef VIEWER_TOUCH_H
#define VIEWER_TOUCH_H

#include "dapple/renderer.h"

enum touch_thing { TOUCH_NOTHING, TOUCH_WATER, TOUCH_SPHERE };

/* All zero: nothing is held. */
struct touch {
    enum touch_thing thing;
    double normal[3]; /* of the plane that the hand moves in */
    double last[3];   /* where it was in it */
};

/* What the left button did since the last frame. Places are -1 to 1 across the picture, to the right and up. */
struct touch_input {
    bool pressed, held;
    double pressed_at[2], place[2];
    double aspect; /* the picture's width / height */
};

/* Moves what is held; true while something is, so that the camera stays. */
bool touch_move(struct touch *touch, struct dpl_scene *scene, struct dpl_renderer *renderer,
                const struct touch_input *input);

/* Whether the sphere swims and sinks, or stays; the other. */
void touch_toggle_gravity(struct dpl_scene *scene);

/* Puts the sun where the target sees the eye. */
void touch_place_sun(struct dpl_scene *scene);

#endif
