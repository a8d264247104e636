#include "reference/camera.h"

#include <stdlib.h>

#define PHOTONS_LEAST 1000.0
#define PHOTONS_MOST 1e7 /* of a pass, for the sake of memory */

bool camera_begin(struct camera *camera, const struct camera_world *world, const struct camera_sight *sight,
                  const struct camera_settings *settings, const struct dpl_log *log)
{
    size_t pixels = (size_t)sight->width * (size_t)sight->height;
    int photons = (int)fmin(fmax(settings->photons * (double)pixels, PHOTONS_LEAST), PHOTONS_MOST);
    camera_finish(camera);
    camera->sight = *sight;
    camera->settings = *settings;
    camera->sums = base_allocate(log, pixels * 3, sizeof *camera->sums, "picture");
    if (camera->sums && camera_scene_make(&camera->scene, world, log) &&
        camera_photons_begin(&camera->photons, &camera->scene, sight, photons, log))
        return true;
    camera_finish(camera);
    return false;
}

void camera_finish(struct camera *camera)
{
    camera_photons_finish(&camera->photons);
    camera_scene_finish(&camera->scene);
    free(camera->sums);
    *camera = (struct camera){0};
}

static void trace_pixel(struct camera *camera, const struct camera_path *path, int column, int row, bool wet)
{
    uint64_t pixel = (uint64_t)row * (uint64_t)camera->sight.width + (uint64_t)column;
    struct draws draws = {.start = random_mix(pixel + 1), .path = (uint64_t)camera->passes};
    double u = draws_next(&draws), v = draws_next(&draws), direction[3], radiance[3];
    camera_sight_ray(&camera->sight, column + u, row + v, direction);
    camera_path_radiance(path, camera->sight.eye, direction, wet, &draws, radiance);
    vector3_along(camera->sums + 3 * pixel, radiance, 1, camera->sums + 3 * pixel);
}

void camera_pass(struct camera *camera)
{
    const struct camera_path path = {
        .scene = &camera->scene,
        .photons = &camera->photons,
        .bounces = camera->settings.bounces,
        .sun_seen = true,
        .spread = camera_sight_spread(&camera->sight),
        .solid_radius = camera->settings.solid_radius,
        .water_radius = camera->settings.water_radius,
    };
    bool wet = camera_scene_wet(&camera->scene, camera->sight.eye);
    camera_photons_send(&camera->photons, (uint64_t)camera->passes);
#pragma omp parallel for schedule(dynamic)
    for (int row = 0; row < camera->sight.height; row++)
        for (int column = 0; column < camera->sight.width; column++)
            trace_pixel(camera, &path, column, row, wet);
    camera->passes++;
}

static int clamp(int at, int count)
{
    return at < 0 ? 0 : at < count ? at : count - 1;
}

void camera_read(const struct camera *camera, int left, int bottom, int columns, int rows, float *radiance)
{
    int width = camera->sight.width, height = camera->sight.height;
    for (int j = 0; j < rows; j++) {
        for (int i = 0; i < columns; i++) {
            size_t from = (size_t)clamp(bottom + j, height) * (size_t)width + (size_t)clamp(left + i, width);
            float *pixel = radiance + 4 * ((size_t)j * (size_t)columns + (size_t)i);
            for (size_t c = 0; c < 3; c++)
                pixel[c] = (float)(camera->sums[3 * from + c] / camera->passes);
            pixel[3] = 1;
        }
    }
}
