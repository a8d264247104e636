/* The sky's upper half as a disc: a direction's place is its level part, divided by 1 + its upward part (a
 * stereographic projection), so that it needs neither angles nor a seam. Beyond the horizon's circle it goes on as on
 * the horizon. */
#include "render/physical.h"

#include "base/log.h"

#include <math.h>
#include <stdlib.h>

#define SIDE 256
#define HORIZON 0.45  /* as in sky.glsl */
#define MOST 60000.0f /* half floats end at 65504 */
#define LOWEST 0.004  /* upward part of the lowest direction: half a row of the sky above the horizon */

static void texel_radiance(const struct optics_sky *sky, int i, int j, float *texel)
{
    double x = ((i + 0.5) / SIDE - 0.5) / HORIZON, z = ((j + 0.5) / SIDE - 0.5) / HORIZON, square = x * x + z * z;
    double direction[3] = {2 * x / (1 + square), fmax((1 - square) / (1 + square), LOWEST), 2 * z / (1 + square)};
    double length = sqrt(direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2]);
    double radiance[3];
    for (int c = 0; c < 3; c++)
        direction[c] /= length;
    optics_sky_radiance(sky, direction, radiance);
    for (int c = 0; c < 3; c++)
        texel[c] = fminf((float)radiance[c], MOST);
}

bool sky_texture_update(struct sky_texture *texture, struct dpl_gl *gl, const struct optics_sky *sky)
{
    if (texture->texels.name && texture->fingerprint == sky->fingerprint)
        return true;
    float *texels = base_allocate(gl->log, (size_t)SIDE * SIDE * 4, sizeof *texels, "sky");
    if (!texels)
        return false;
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++)
            texel_radiance(sky, i, j, texels + 4 * (j * SIDE + i));
    texture_resize(gl, &texture->texels, GL_RGBA16F, SIDE, SIDE, TEXTURE_CLAMP, TEXTURE_MIPMAP);
    texture_upload(gl, &texture->texels, texels);
    texture_make_mipmaps(gl, &texture->texels);
    texture->fingerprint = sky->fingerprint;
    optics_sky_radiance(sky, (const double[3]){0.6, -0.8, 0}, texture->ground);
    free(texels);
    return true;
}
