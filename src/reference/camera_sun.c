#include "reference/camera_sun.h"

#include "base/vector3.h"
#include "reference/camera_medium.h"

#include "optics/refraction.h"

void camera_sun_place(const struct camera_scene *scene, struct draws *draws, double to_sun[3])
{
    double place[2], u = draws_next(draws), v = draws_next(draws);
    optics_disc_spread(u, v, place);
    optics_disc_place(&scene->world.sun, place, to_sun);
}

bool camera_sun_direct(const struct camera_scene *scene, const double place[3], const double to_sun[3],
                       struct camera_beam *beam)
{
    struct camera_hit water;
    if (to_sun[1] <= 0 || !camera_scene_clear(scene, place, to_sun, CAMERA_FARTHEST) ||
        camera_scene_water(scene, place, to_sun, CAMERA_FARTHEST, &water))
        return false;
    vector3_scale(to_sun, -1, beam->direction);
    vector3_copy(scene->world.sky->sun, beam->irradiance);
    return true;
}

static bool same_index(const struct camera_water *water)
{
    return water->ior[0] == water->ior[2];
}

/* Light that enters through the surface of that normal and comes to a place in the water. */
static bool refracted(const struct camera_scene *scene, const double place[3], const double to_sun[3],
                      const double normal[3], int color, struct camera_beam *beam)
{
    const struct camera_water *water = &scene->world.water;
    double cosine = vector3_dot(to_sun, normal), back[3];
    struct camera_hit entry;
    if (cosine <= 0)
        return false;
    optics_refract(to_sun, normal, water->ior[color], beam->direction);
    vector3_scale(beam->direction, -1, back);
    if (!camera_scene_water(scene, place, back, CAMERA_FARTHEST, &entry) || vector3_dot(entry.normal, normal) < 0.5 ||
        !camera_scene_clear(scene, place, back, entry.distance) || !camera_scene_lit(scene, &entry, to_sun))
        return false;
    double share = (1 - optics_fresnel_reflectance(cosine, water->ior[color])) * cosine / vector3_dot(back, normal);
    for (int c = 0; c < 3; c++)
        beam->irradiance[c] = same_index(water) || c == color
                                  ? scene->world.sky->sun[c] * share * camera_medium_left(water, c, entry.distance)
                                  : 0;
    return true;
}

/* Light that comes from below off the surface. */
static bool reflected(const struct camera_scene *scene, const double place[3], const double to_sun[3],
                      struct camera_beam *beam)
{
    const double back[3] = {to_sun[0], -to_sun[1], to_sun[2]};
    struct camera_hit mirror;
    if (!camera_scene_water(scene, place, back, CAMERA_FARTHEST, &mirror) || mirror.normal[1] < 0.5 ||
        !camera_scene_clear(scene, place, back, mirror.distance) || !camera_scene_lit(scene, &mirror, to_sun))
        return false;
    vector3_scale(back, -1, beam->direction);
    for (int c = 0; c < 3; c++)
        beam->irradiance[c] =
            scene->world.sky->sun[c] * optics_fresnel_reflectance(to_sun[1], scene->world.water.ior[c]);
    return true;
}

int camera_sun_at_rest(const struct camera_scene *scene, const double place[3], bool wet, const double to_sun[3],
                       struct camera_beam beams[CAMERA_BEAMS_MAX])
{
    /* The surface, and the sides of a block that look to the sun. */
    const double normals[3][3] = {{0, 1, 0}, {copysign(1, to_sun[0]), 0, 0}, {0, 0, copysign(1, to_sun[2])}};
    int count = 0;
    if (!(scene->world.water.half > 0) || to_sun[1] <= 0)
        return 0;
    if (!wet)
        return reflected(scene, place, to_sun, beams) ? 1 : 0;
    int colors = same_index(&scene->world.water) ? 1 : 3;
    for (int k = 0; k < (isinf(scene->water.half) ? 1 : 3); k++)
        for (int c = 0; c < colors; c++)
            count += refracted(scene, place, to_sun, normals[k], colors == 1 ? 1 : c, beams + count);
    return count;
}
