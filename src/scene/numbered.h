/* scene/numbered.h: sections that come in numbers, as [wave.3]: each is there from the moment that one of its values is
 * set. */
#ifndef SCENE_NUMBERED_H
#define SCENE_NUMBERED_H

#include "dapple/scene.h"

#define SCENE_NUMBERED_NAME_SIZE 12 /* bytes of "camera.16" */

/* Gives all of them their names and defaults; none is there. */
void scene_numbered_start(struct dpl_scene *scene);

/* The section of that name, whether it is there or not; NULL-named where the name is none of theirs. */
struct dpl_section scene_numbered_find(const struct dpl_scene *scene, const char *name);

/* Notes that the section of that name is there, or that it is not; false where the name is none of theirs. */
bool scene_numbered_mark(struct dpl_scene *scene, const char *name, bool present);

/* The index-th of those that are there; NULL-named past the last, and then the index is less by as many as there are.
 */
struct dpl_section scene_numbered_section(const struct dpl_scene *scene, int *index);

/* "wave.1 to wave.64, camera.1 to camera.16" */
void scene_numbered_list(char *text, size_t size);

#endif
