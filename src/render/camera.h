/* render/camera.h: from the scene's camera to the matrix that shaders use. */
#ifndef RENDER_CAMERA_H
#define RENDER_CAMERA_H

#include "scene/scene.h"

/* The part of a picture that is drawn, a tile or all of it; pixels, from the picture's lower left corner. */
struct camera_view {
    int width, height; /* of the whole picture */
    int left, bottom, columns, rows;
};

/* The rays of that part: from the eye along ahead + right x + up y, x and y from -1 to 1 across it. `ahead` is a unit
 * vector, to the middle, where the part is the whole picture. */
struct camera_rays {
    double ahead[3], right[3], up[3];
};
struct camera_rays camera_rays(const struct scene_camera *camera, const struct camera_view *view);

/* World to the part's clip space, as OpenGL wants its columns. */
void camera_matrix(const struct scene_camera *camera, const struct camera_view *view, float columns[16]);

#endif
