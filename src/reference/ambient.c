#include "reference/ambient.h"

#include "base/vector3.h"
#include "reference/camera_path.h"

#include "base/sine.h"

#define BOUNCES 3
#define LIFT 1e-3 /* m that a path starts above its surface, which may be met by others there */

/* The i-th of `rays` directions about a normal, as Lambert's law has it: a Fibonacci spiral, turned by a share of a
 * whole turn (Swinbank & Purser 2006). */
static void direction_at(const double normal[3], int i, int rays, double turned, double out[3])
{
    const double golden = 0.6180339887498949;
    double u = (i + 0.5) / rays, radius = sqrt(u), sine, cosine;
    sine_cosine(i * golden + turned, &sine, &cosine);
    vector3_turn(normal, (const double[3]){radius * cosine, radius * sine, sqrt(1 - u)}, out);
}

static void bake(const struct camera_path *path, int index, const float position[3], const float normal_[3], int rays,
                 float irradiance[3])
{
    double place[3], normal[3], sum[3] = {0, 0, 0};
    for (int c = 0; c < 3; c++)
        normal[c] = (double)normal_[c];
    vector3_normalize(normal);
    for (int c = 0; c < 3; c++)
        place[c] = (double)position[c] + LIFT * normal[c];
    bool wet = camera_scene_wet(path->scene, place);
    struct draws turn = {.start = random_mix((uint64_t)index + 1)};
    double turned = draws_next(&turn);
    for (int i = 0; i < rays; i++) {
        struct draws draws = {.start = turn.start, .path = (uint64_t)i, .dimension = 1};
        double direction[3], radiance[3];
        direction_at(normal, i, rays, turned, direction);
        camera_path_radiance(path, place, direction, wet, &draws, radiance);
        vector3_along(sum, radiance, 1, sum);
    }
    for (int c = 0; c < 3; c++)
        irradiance[c] = (float)(sum[c] * M_PI / rays);
}

/* Light that is scattered almost straight on counts as not scattered: of a phase function with that anisotropy the
 * share of its square (Joseph, Wiscombe & Weinman 1976). */
static void straighten(struct optics_water *water)
{
    double g = fmax(water->anisotropy, 0);
    for (int c = 0; c < 3; c++)
        water->scattering[c] *= 1 - g * g;
    water->anisotropy = g > 0 ? g / (1 + g) : water->anisotropy;
}

bool ambient_bake(const struct camera_world *world, int count, const float *positions, const float *normals,
                  const int *rays, float *irradiance, const struct dpl_log *log)
{
    struct camera_world still = *world;
    struct camera_scene scene;
    still.water.surface = NULL;
    straighten(&still.water.optics);
    if (!camera_scene_make(&scene, &still, log))
        return false;
    const struct camera_path path = {.scene = &scene, .bounces = BOUNCES};
#pragma omp parallel for schedule(dynamic, 64)
    for (int i = 0; i < count; i++)
        bake(&path, i, positions + 3 * (size_t)i, normals + 3 * (size_t)i, rays[i], irradiance + 3 * (size_t)i);
    camera_scene_finish(&scene);
    return true;
}

bool ambient_clear(const struct camera_world *world, int count, const float *pairs, bool *clear,
                   const struct dpl_log *log)
{
    struct camera_scene scene;
    if (!camera_scene_make(&scene, world, log))
        return false;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < count; i++) {
        double from[3], way[3];
        for (int c = 0; c < 3; c++) {
            from[c] = (double)pairs[6 * i + c];
            way[c] = (double)pairs[6 * i + 3 + c] - from[c];
        }
        double length = sqrt(vector3_dot(way, way));
        vector3_normalize(way);
        clear[i] = camera_scene_clear(&scene, from, way, length);
    }
    camera_scene_finish(&scene);
    return true;
}
