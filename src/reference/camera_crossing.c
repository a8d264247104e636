#include "reference/camera_crossing.h"

#include "base/vector3.h"

#include "optics/refraction.h"

struct camera_crossing camera_crossing(const struct camera_hit *hit, const double direction[3], double ior)
{
    struct camera_crossing crossing = {.wet = vector3_dot(direction, hit->face) > 0, .reflectance = 1};
    double side = crossing.wet ? 1 : -1; /* of what is refracted */
    const double *normal = vector3_dot(direction, hit->normal) * side > 0 ? hit->normal : hit->face;
    double back[3], cosine = fmin(fabs(vector3_dot(direction, normal)), 1);
    vector3_scale(direction, -1, back);
    optics_reflect(back, normal, crossing.reflected);
    vector3_keep_side(hit->face, -side, crossing.reflected);
    if (!crossing.wet)
        optics_refract(back, normal, ior, crossing.refracted);
    else if (optics_refract_out(direction, normal, ior, crossing.refracted))
        cosine = fmin(vector3_dot(crossing.refracted, normal), 1);
    else
        return crossing;
    crossing.reflectance = optics_fresnel_reflectance(cosine, ior);
    vector3_keep_side(hit->face, side, crossing.refracted);
    return crossing;
}
