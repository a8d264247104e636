/* What solids and floor get from all around. */
#include "render/physical.h"

#include "base/log.h"

#include <math.h>
#include <stdlib.h>

#define FLOOR_SIDE 96 /* points of the floor a side */

/* Irradiance of the sky on a surface, by its harmonics (Ramamoorthi & Hanrahan 2001, eq. 13 without its table). */
static void sky_irradiance(const struct optics_sky *sky, const float n[3], double out[3])
{
    const double x = (double)n[0], y = (double)n[1], z = (double)n[2];
    const double basis[9] = {0.282095,
                             0.488603 * y,
                             0.488603 * z,
                             0.488603 * x,
                             1.092548 * x * y,
                             1.092548 * y * z,
                             0.315392 * (3 * z * z - 1),
                             1.092548 * x * z,
                             0.546274 * (x * x - y * y)};
    for (int c = 0; c < 3; c++) {
        double sum = 0;
        for (int i = 0; i < 9; i++)
            sum += basis[i] * sky->harmonics[i][c] * (i == 0 ? M_PI : i < 4 ? 2 * M_PI / 3 : M_PI / 4);
        out[c] = fmax(sum, 0);
    }
}

static void point_ambient(const struct physical *physical, const float position[3], const float normal[3], float *out)
{
    const struct physical_light *light = &physical->light;
    double sky[3], up = 0.5 + 0.5 * (double)normal[1], depth = fmax(-(double)position[1], 0);
    sky_irradiance(&physical->sky, normal, sky);
    for (int c = 0; c < 3; c++) {
        double below = light->diffuse_below[c] * exp(-light->diffuse_extinction[c] * depth) * (0.25 + 0.75 * up) +
                       M_PI * light->floor_radiance[c] * (1 - up);
        out[c] = (float)(position[1] < 0 ? below : sky[c]);
    }
}

static bool bake_solids(struct physical *physical, const struct frame *frame)
{
    const struct world *world = &physical->world;
    float *ambient = base_allocate(frame->gl->log, (size_t)world->vertex_count * 3, sizeof *ambient, "ambient light");
    if (!ambient)
        return false;
    for (int i = 0; i < world->vertex_count; i++)
        point_ambient(physical, world->vertices[i].position, world->vertices[i].normal, ambient + 3 * i);
    solids_upload(&physical->solids, frame->gl, world, ambient);
    free(ambient);
    return true;
}

static bool bake_floor(struct physical *physical, const struct frame *frame)
{
    static const float up[3] = {0, 1, 0};
    struct seabed *seabed = &physical->seabed;
    const struct world *world = &physical->world;
    int side = world->vertex_count > 0 ? FLOOR_SIDE : 1;
    float *texels = base_allocate(frame->gl->log, (size_t)(side * side) * 4, sizeof *texels, "ambient light");
    if (!texels)
        return false;
    double *square = seabed->ambient_square, margin = 2;
    square[2] = fmax(world->high[0] - world->low[0], world->high[2] - world->low[2]) + 2 * margin;
    square[0] = (world->low[0] + world->high[0] - square[2]) / 2;
    square[1] = (world->low[2] + world->high[2] - square[2]) / 2;
    if (side == 1)
        square[0] = square[1] = 0, square[2] = 1;
    for (int j = 0; j < side; j++) {
        for (int i = 0; i < side; i++) {
            float place[3] = {(float)(square[0] + (i + 0.5) / side * square[2]), (float)-frame->scene->settings.depth,
                              (float)(square[1] + (j + 0.5) / side * square[2])};
            point_ambient(physical, place, up, texels + 4 * (j * side + i));
        }
    }
    texture_resize(frame->gl, &seabed->ambient, GL_RGBA16F, side, side, TEXTURE_CLAMP, TEXTURE_LINEAR);
    texture_upload(frame->gl, &seabed->ambient, texels);
    free(texels);
    return true;
}

bool ambient_update(struct physical *physical, const struct frame *frame)
{
    return bake_solids(physical, frame) && bake_floor(physical, frame);
}
