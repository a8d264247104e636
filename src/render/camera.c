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

struct camera_rays camera_rays(const struct scene_camera *camera, int width, int height)
{
    vec3 position, ahead, up, right;
    sight(camera, position, ahead, up);
    glm_vec3_crossn(ahead, up, right);
    glm_vec3_crossn(right, ahead, up);
    double half = tan(camera->field_of_view * M_PI / 360), wide = half * width / height;
    struct camera_rays rays;
    for (int i = 0; i < 3; i++) {
        rays.ahead[i] = (double)ahead[i];
        rays.right[i] = (double)right[i] * wide;
        rays.up[i] = (double)up[i] * half;
    }
    return rays;
}

void camera_matrix(const struct scene_camera *camera, int width, int height, float columns[16])
{
    vec3 position, direction, up;
    sight(camera, position, direction, up);
    mat4 view, projection, product;
    glm_look(position, direction, up, view);
    glm_perspective(glm_rad((float)camera->field_of_view), (float)width / (float)height, (float)camera->near_plane,
                    (float)camera->far_plane, projection);
    glm_mat4_mul(projection, view, product);
    memcpy(columns, product, sizeof product);
}
