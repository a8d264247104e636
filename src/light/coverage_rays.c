/* The first part of coverage.c: every vertex bends its light once, whatever the number of receivers. */
#include "light/coverage.h"

#include "base/log.h"
#include "base/vector.h"
#include "optics/refraction.h"

#include <math.h>
#include <stdlib.h>

bool coverage_ray(const double sun[3], double ior, bool upwards, const double slopes[2], double uvq[3])
{
    double length = sqrt(1 + slopes[0] * slopes[0] + slopes[1] * slopes[1]);
    double normal[3] = {-slopes[0] / length, 1 / length, -slopes[1] / length}, out[3];
    if (sun[0] * normal[0] + sun[1] * normal[1] + sun[2] * normal[2] <= 0)
        return false;
    if (upwards)
        optics_reflect(sun, normal, out);
    else
        optics_refract(sun, normal, ior, out);
    if (upwards ? out[1] <= 0 : out[1] >= 0)
        return false;
    uvq[0] = out[0] / out[1];
    uvq[1] = out[2] / out[1];
    uvq[2] = 1 / out[1];
    return true;
}

struct coverage_flat coverage_flat_water(const double sun[3], double ior, bool upwards)
{
    struct coverage_flat flat = {.upwards = upwards, .ior = ior, .sun = {sun[0], sun[1], sun[2]}};
    const double nothing = 1e-12; /* what rounding makes of the light that water of index 1 throws back */
    double uvq[3] = {0}, reflectance = optics_fresnel_reflectance(sun[1], ior);
    coverage_ray(sun, ior, upwards, (const double[2]){0, 0}, uvq);
    flat.u = uvq[0];
    flat.v = uvq[1];
    flat.q = uvq[2];
    flat.share = upwards ? reflectance : 1 - reflectance;
    if (flat.share < nothing)
        flat.share = 0;
    return flat;
}

static bool resize(struct coverage_rays *rays, int columns, int rows, const struct dpl_log *log)
{
    if (rays->u && rays->columns == columns && rays->rows == rows)
        return true;
    coverage_rays_finish(rays);
    size_t count = (size_t)columns * (size_t)rows;
    rays->u = base_allocate(log, count * 4, sizeof(float), "rays");
    if (!rays->u)
        return false;
    rays->v = rays->u + count;
    rays->q = rays->v + count;
    rays->weight = rays->q + count;
    rays->columns = columns;
    rays->rows = rows;
    return true;
}

void coverage_rays_finish(struct coverage_rays *rays)
{
    free(rays->u);
    *rays = (struct coverage_rays){0};
}

/* One row of vertices. As optics/refraction.c, in single precision; `upwards` is 1 for light that is thrown back, 0 for
 * light that is let in. */
VECTOR_CLONES static void trace_row(const struct coverage_flat *flat, float upwards, const float *restrict texels,
                                    int count, float *restrict u, float *restrict v, float *restrict q,
                                    float *restrict weight)
{
    const float sx = (float)flat->sun[0], sy = (float)flat->sun[1], sz = (float)flat->sun[2];
    const float ior = (float)flat->ior, square = ior * ior, flat_q = (float)flat->q;
    const float flat_u = (float)flat->u, flat_v = (float)flat->v;
    const float scale = flat->share > 0 ? (float)(1 / (flat->share * flat->sun[1])) : 0.0f;
    const float inwards = 1.0f - upwards, sign = upwards - inwards;
    for (int i = 0; i < count; i++) {
        float slope_x = texels[3 * i + 1], slope_z = texels[3 * i + 2];
        float facing = vector_positive(sy - sx * slope_x - sz * slope_z); /* cosine × length of the normal */
        float up = 1.0f / sqrtf(1.0f + slope_x * slope_x + slope_z * slope_z);
        float cosine = facing * up + 1e-7f; /* not 0 / 0 where the index is 1 */
        float inside = sqrtf(square - 1.0f + cosine * cosine);
        float across = (cosine - inside) / (cosine + inside);
        float along = (square * cosine - inside) / (square * cosine + inside);
        float reflectance = 0.5f * (across * across + along * along);
        /* ior × direction let in, or direction thrown back: some of the normal less the direction to the sun */
        float turn = (upwards * 2.0f * cosine + inwards * (cosine - inside)) * up;
        float down = sign * (turn - sy); /* > 0: it arrives */
        float arrives = rintf(vector_clamp(0.5f + 1e6f * down, 0.0f, 1.0f)), stays = 1.0f - arrives;
        float per_height = sign * arrives / (down * arrives + stays);
        u[i] = (-turn * slope_x - sx) * per_height + stays * flat_u;
        v[i] = (-turn * slope_z - sz) * per_height + stays * flat_v;
        q[i] = (upwards + inwards * ior) * per_height + stays * flat_q;
        weight[i] = arrives * scale * facing * (upwards * reflectance + inwards * (1.0f - reflectance));
    }
}

bool coverage_rays_trace(struct coverage_rays *rays, const struct surface *surface, const struct coverage_flat *flat,
                         const struct dpl_log *log)
{
    int repeated = surface->periodic ? 1 : 0;
    if (!resize(rays, surface->columns + repeated, surface->rows + repeated, log))
        return false;
#pragma omp parallel for
    for (int j = 0; j < rays->rows; j++) {
        const float *texels = surface->texels + (size_t)(j % surface->rows) * (size_t)surface->columns * 3;
        size_t to = (size_t)j * (size_t)rays->columns;
        float *row[] = {rays->u + to, rays->v + to, rays->q + to, rays->weight + to};
        trace_row(flat, flat->upwards ? 1.0f : 0.0f, texels, surface->columns, row[0], row[1], row[2], row[3]);
        for (int k = 0; repeated && k < 4; k++)
            row[k][surface->columns] = row[k][0];
    }
    return true;
}
