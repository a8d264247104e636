#include "render/camera.h"

#include <cglm/cglm.h>
#include <math.h>
#include <string.h>

/* The direction of sight; a camera that stands on its target looks along -z. */
static void sight(const struct scene_camera *camera, vec3 position, vec3 direction, vec3 up)
{
    for (int i = 0; i < 3; i++) {
        position[i] = (float)camera->position[i];
        direction[i] = (float)(camera->target[i] - camera->position[i]);
    }
    if (glm_vec3_norm(direction) < 1e-6f)
        glm_vec3_copy((vec3){0, 0, -1}, direction);
    glm_vec3_normalize(direction);
    bool steep = fabsf(direction[1]) > 0.9999f; /* then the picture's upper edge is -z */
    glm_vec3_copy(steep ? (vec3){0, 0, -1} : (vec3){0, 1, 0}, up);
}

/* The part of the picture along one axis, both ends of which are -1 and 1: its middle and half its length. */
static void part_of(int start, int length, int whole, double *middle, double *half)
{
    *middle = (2.0 * start + length) / whole - 1;
    *half = (double)length / whole;
}

struct camera_rays camera_rays(const struct scene_camera *camera, const struct camera_view *view)
{
    vec3 position, ahead, up, right;
    sight(camera, position, ahead, up);
    glm_vec3_crossn(ahead, up, right);
    glm_vec3_crossn(right, ahead, up);
    double high = tan(camera->field_of_view * M_PI / 360), wide = high * view->width / view->height;
    double x, y, half_x, half_y;
    part_of(view->left, view->columns, view->width, &x, &half_x);
    part_of(view->bottom, view->rows, view->height, &y, &half_y);
    struct camera_rays rays;
    for (int i = 0; i < 3; i++) {
        rays.ahead[i] = (double)ahead[i] + x * wide * (double)right[i] + y * high * (double)up[i];
        rays.right[i] = (double)right[i] * wide * half_x;
        rays.up[i] = (double)up[i] * high * half_y;
    }
    return rays;
}

void camera_matrix(const struct scene_camera *camera, const struct camera_view *view, float columns[16])
{
    vec3 position, direction, up;
    sight(camera, position, direction, up);
    mat4 look, projection, product;
    double x, y, half_x, half_y;
    part_of(view->left, view->columns, view->width, &x, &half_x);
    part_of(view->bottom, view->rows, view->height, &y, &half_y);
    glm_look(position, direction, up, look);
    glm_perspective(glm_rad((float)camera->field_of_view), (float)view->width / (float)view->height,
                    (float)camera->near_plane, (float)camera->far_plane, projection);
    for (int i = 0; i < 4; i++) { /* the part to -1 … 1, before the division by w */
        projection[i][0] = (projection[i][0] - (float)x * projection[i][3]) / (float)half_x;
        projection[i][1] = (projection[i][1] - (float)y * projection[i][3]) / (float)half_y;
    }
    glm_mat4_mul(projection, look, product);
    memcpy(columns, product, sizeof product);
}
