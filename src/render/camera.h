/* render/camera.h: from the scene's camera to the matrix that shaders use. */
#ifndef RENDER_CAMERA_H
#define RENDER_CAMERA_H

#include "scene/scene.h"

/* The rays of the picture: from the eye along ahead + right x + up y, x and y from -1 to 1. */
struct camera_rays {
    double ahead[3], right[3], up[3];
};
struct camera_rays camera_rays(const struct scene_camera *camera, int width, int height);

/* World to clip space for a picture of that shape, as OpenGL wants its columns. */
void camera_matrix(const struct scene_camera *camera, int width, int height, float columns[16]);

#endif
