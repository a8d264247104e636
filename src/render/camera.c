#include "render/camera.h"

#include <cglm/cglm.h>
#include <string.h>

/* The direction of sight; a camera that stands on its target looks along -z. */
static void sight(const struct scene_camera *camera, vec3 position, vec3 direction)
{
    for (int i = 0; i < 3; i++) {
        position[i] = (float)camera->position[i];
        direction[i] = (float)(camera->target[i] - camera->position[i]);
    }
    if (glm_vec3_norm(direction) < 1e-6f)
        glm_vec3_copy((vec3){0, 0, -1}, direction);
    glm_vec3_normalize(direction);
}

void camera_matrix(const struct scene_camera *camera, int width, int height, float columns[16])
{
    vec3 position, direction;
    sight(camera, position, direction);
    /* Straight up or down the picture's upper edge is -z. */
    vec3 up = {0, 1, 0};
    if (fabsf(direction[1]) > 0.9999f)
        glm_vec3_copy((vec3){0, 0, -1}, up);
    mat4 view, projection, product;
    glm_look(position, direction, up, view);
    glm_perspective(glm_rad((float)camera->field_of_view), (float)width / (float)height, (float)camera->near_plane,
                    (float)camera->far_plane, projection);
    glm_mat4_mul(projection, view, product);
    memcpy(columns, product, sizeof product);
}
