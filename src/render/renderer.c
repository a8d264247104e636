/* The renderer: what it owns, what is asked of it beside pictures (renderer_frame.c). See dapple/renderer.h. */
#include "base/log.h"
#include "render/renderer_state.h"

#include <math.h>
#include <stdlib.h>

struct dpl_renderer *dpl_renderer_create(struct dpl_gl *gl, enum dpl_device device, const struct dpl_log *log)
{
    struct dpl_renderer *renderer = base_allocate(log, 1, sizeof *renderer, "renderer");
    if (!renderer)
        return NULL;
    renderer->gl = gl;
    renderer->log = log;
    renderer->timer.gl = gl;
    renderer->lighting = (struct lighting){.gl = gl, .device = device, .log = log, .timer = &renderer->timer};
    return renderer;
}

void dpl_renderer_destroy(struct dpl_renderer *renderer)
{
    if (!renderer)
        return;
    struct dpl_gl *gl = renderer->gl;
    lighting_finish(&renderer->lighting);
    timer_finish(&renderer->timer);
    if (gl) {
        difference_finish(gl, &renderer->difference);
        sand_finish(gl, &renderer->sand);
        target_finish(gl, &renderer->target);
        tone_finish(gl, &renderer->tone);
        thumbnails_finish(gl, &renderer->thumbnails);
        for (int i = 0; scene_looks[i]; i++)
            if (renderer->look_states[i])
                scene_looks[i]->finish(renderer->look_states[i], gl);
        gpu_leave(gl, 0);
    }
    for (int i = 0; scene_looks[i]; i++)
        free(renderer->look_states[i]);
    picture_finish(&renderer->picture);
    free(renderer);
}

bool renderer_leave(struct dpl_renderer *renderer, unsigned framebuffer)
{
    if (!renderer->gl)
        return true;
    bool ok = gpu_check(renderer->gl);
    gpu_leave(renderer->gl, framebuffer);
    return ok;
}

/* Ends a call that returns an image. */
static struct dpl_image *leave_with_image(struct dpl_renderer *renderer, struct dpl_image *image)
{
    if (renderer_leave(renderer, 0))
        return image;
    dpl_image_destroy(image);
    return NULL;
}

struct dpl_image *dpl_renderer_surface(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time)
{
    timer_frame(&renderer->timer);
    bool ok = lighting_make_surface(&renderer->lighting, scene, time);
    ok = renderer_leave(renderer, 0) && ok;
    if (!ok)
        return NULL;
    const struct surface *surface = &renderer->lighting.surface;
    struct dpl_image *image = dpl_image_create(surface->columns, surface->rows, renderer->log);
    for (size_t i = 0; image && i < (size_t)surface->columns * (size_t)surface->rows * 3; i++)
        image->pixels[i] = surface->texels[i];
    return image;
}

struct dpl_image *dpl_renderer_slice(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time,
                                     int slice)
{
    double receivers[LIGHT_SLICES_MAX];
    int slices = scene_receivers(scene, receivers);
    if (slice < 0 || slice >= slices) {
        base_fail(renderer->log, DPL_REASON_RANGE,
                  "slice: out of range: \"%d\" (accepted: 0 to %d, as caustics.slices says)", slice, slices - 1);
        return NULL;
    }
    timer_frame(&renderer->timer);
    bool ok = lighting_make(&renderer->lighting, scene, time, -1, false);
    renderer->compared = false;
    timer_pass(&renderer->timer, NULL);
    struct lit_map *lit = renderer->lighting.maps + LIT_SCENE;
    struct dpl_image *image = ok ? lighting_image(&renderer->lighting, lit, slice) : NULL;
    return leave_with_image(renderer, image);
}

struct dpl_image *dpl_renderer_map(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time)
{
    return dpl_renderer_slice(renderer, scene, time, 0);
}

void dpl_renderer_tiles(struct dpl_renderer *renderer, void (*drawn)(void *user, int done, int tiles), void *user)
{
    renderer->picture.progress = drawn;
    renderer->picture.user = user;
}

void dpl_renderer_path(struct dpl_renderer *renderer, bool follows)
{
    renderer->still = !follows;
}

void renderer_limit_tiles(struct dpl_renderer *renderer, int side)
{
    renderer->picture.side_max = side;
}

bool dpl_renderer_drop(struct dpl_renderer *renderer, double x, double z, double radius, double height)
{
    if (!isfinite(x) || !isfinite(z) || !isfinite(height) || !isfinite(radius) || !(radius > 0))
        return base_fail(renderer->log, DPL_REASON_RANGE,
                         "drop: not finite, or no radius: \"%g %g %g %g\" (accepted: finite numbers, a radius above 0)",
                         x, z, radius, height);
    return lighting_drop(&renderer->lighting, (struct water_drop){x, z, radius, height});
}

bool dpl_renderer_sphere(const struct dpl_renderer *renderer, double center[3])
{
    for (int c = 0; c < 3; c++)
        center[c] = renderer->sphere[c];
    return renderer->has_sphere;
}

void dpl_renderer_progress(struct dpl_renderer *renderer, bool (*step)(void *user, double done), void *user)
{
    renderer->lighting.progress = (struct light_progress){step, user};
}

double dpl_renderer_noise(const struct dpl_renderer *renderer)
{
    return renderer->lighting.maps[renderer->compared ? LIT_OTHER : LIT_SCENE].map.noise;
}

void dpl_renderer_compare(struct dpl_renderer *renderer, const struct dpl_compare *compare)
{
    renderer->compare = *compare;
    if (!light_technique_name(compare->technique))
        renderer->compare.mode = DPL_COMPARE_NOTHING;
}

bool dpl_renderer_measure(struct dpl_renderer *renderer, struct dpl_measure *measure)
{
    struct lit_map *maps = renderer->lighting.maps;
    if (!renderer->compared)
        return base_fail(renderer->log, DPL_REASON_UNSUPPORTED, "nothing to measure: the last frame compared nothing");
    gpu_enter(renderer->gl);
    bool physical = true, ok = true;
    struct dpl_image *images[2];
    for (int i = 0; i < 2; i++) {
        images[i] = lighting_image(&renderer->lighting, maps + i, 0);
        physical = physical && light_techniques[maps[i].technique]->physical;
        ok = ok && images[i];
    }
    ok = ok && dpl_measure_map(images[LIT_SCENE], images[LIT_OTHER], !physical, maps[LIT_OTHER].map.noise, measure,
                               renderer->log);
    for (int i = 0; i < 2; i++)
        dpl_image_destroy(images[i]);
    return renderer_leave(renderer, 0) && ok;
}

void dpl_renderer_reload(struct dpl_renderer *renderer)
{
    if (renderer->gl)
        renderer->gl->generation++;
}

void dpl_renderer_time_passes(struct dpl_renderer *renderer, enum dpl_timing timing, double (*now)(void))
{
    bool possible = timing == DPL_TIMING_QUERIES ? renderer->gl && renderer->gl->info.timer_queries : now != NULL;
    for (int i = 0; i < TIMER_FRAMES; i++)
        renderer->timer.frames[i].count = 0;
    renderer->timer.timing = possible ? timing : DPL_TIMING_OFF;
    renderer->timer.now = now;
    renderer->timer.times[0].name = NULL;
}

struct dpl_pass_time dpl_renderer_pass_time(const struct dpl_renderer *renderer, int index)
{
    return timer_time(&renderer->timer, index);
}

struct dpl_thumbnail dpl_renderer_thumbnail(struct dpl_renderer *renderer, int index)
{
    const struct lit_map *maps = renderer->lighting.maps;
    const struct gpu_texture *other = renderer->compared ? maps[LIT_OTHER].shown : NULL;
    if (!renderer->gl || !maps[LIT_SCENE].shown)
        return (struct dpl_thumbnail){0};
    gpu_enter(renderer->gl);
    struct dpl_thumbnail thumbnail = thumbnails_draw(renderer->gl, &renderer->thumbnails, index,
                                                     &renderer->lighting.surface_gpu, maps[LIT_SCENE].shown, other);
    gpu_leave(renderer->gl, 0);
    return thumbnail;
}
