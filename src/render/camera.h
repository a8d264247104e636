/* render/camera.h: from the scene's camera to the matrix that shaders use. */
#ifndef RENDER_CAMERA_H
#define RENDER_CAMERA_H

#include "scene/scene.h"

/* World to clip space for a picture of that shape, as OpenGL wants its columns. */
void camera_matrix(const struct scene_camera *camera, int width, int height, float columns[16]);

#endif
