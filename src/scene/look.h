/* scene/look.h: the interface of a look, which draws the picture, and the list of them.
 *
 * A look is one file in src/render/, its shaders beside it; it stands above the scene, which knows it only by this
 * interface. A new look is a copy of src/render/look_fourier.c and one line in look.c. */
#ifndef SCENE_LOOK_H
#define SCENE_LOOK_H

#include "base/param.h"
#include "gpu/gl.h"

struct frame; /* render/frame.h */

struct scene_look {
    const char *name;
    const char *section;            /* of its values in scene text: "look.NAME" */
    const char *summary;            /* one line: what it shows, and whose it is */
    const struct dpl_param *params; /* ends with PARAM_END */
    size_t params_size;
    size_t state_size; /* kept between frames, starts zeroed */
    bool sand;         /* draws the floor with frame.sand */
    bool linear;       /* draws radiance, which camera.exposure and render.tone then make a picture of */
    int margin;        /* pixels: how far what is drawn in one changes others, as a blur does; 0: not at all */

    /* Readies programs, and textures that draw() needs. */
    bool (*prepare)(void *state, const struct frame *frame);
    /* Draws the part of the picture that frame.view tells into the bound target of that size, cleared to
     * render.background, within the scissor box that is set. */
    void (*draw)(void *state, const struct frame *frame);
    /* Frees what the state owns. */
    void (*finish)(void *state, struct dpl_gl *gl);
};

#define SCENE_LOOKS_MAX 8
extern const struct scene_look *const scene_looks[]; /* ends with NULL */

/* The i-th look's name, NULL past the last: the choices of `render.look`. */
const char *scene_look_name(int i);

#endif
