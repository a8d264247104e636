/* The way of a frame: surface → light → look. See dapple/renderer.h. */
#include "dapple/renderer.h"

#include "base/log.h"
#include "render/camera.h"
#include "render/difference.h"
#include "render/lighting.h"
#include "render/picture.h"
#include "render/sand.h"
#include "render/thumbnail.h"
#include "render/tone.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct dpl_renderer {
    struct dpl_gl *gl; /* NULL: CPU only */
    const struct dpl_log *log;
    struct gpu_timer timer;
    struct lighting lighting;
    struct dpl_compare compare;
    bool compared; /* the maps made last are two */
    bool has_sphere;
    double sphere[3]; /* m, its middle in the last picture */
    struct difference difference;
    struct sand sand;
    void *look_states[SCENE_LOOKS_MAX]; /* made when first used */
    struct gpu_target target;
    struct tone tone;
    struct thumbnails thumbnails;
    struct picture picture;
    struct scene_camera camera; /* of the frame under way */
    bool still;                 /* the camera's path does not count */
};

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

/* Ends a call: true where OpenGL had nothing to say against it. */
static bool leave(struct dpl_renderer *renderer, unsigned framebuffer)
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
    if (leave(renderer, 0))
        return image;
    dpl_image_destroy(image);
    return NULL;
}

struct dpl_image *dpl_renderer_surface(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time)
{
    timer_frame(&renderer->timer);
    bool ok = lighting_make_surface(&renderer->lighting, scene, time);
    ok = leave(renderer, 0) && ok;
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

static void set_wireframe(struct dpl_gl *gl, bool on)
{
    if (gl->PolygonMode)
        gl->PolygonMode(GL_FRONT_AND_BACK, on ? GL_LINE : GL_FILL);
}

/* The picture from a map, in columns `left` to `right` of the target alone. */
static void draw_part(struct dpl_renderer *renderer, struct frame *frame, const struct lit_map *lit, int left,
                      int right)
{
    const int look = frame->scene->render.look;
    frame->map = lit->shown;
    if (left >= right)
        return;
    renderer->gl->Scissor(left, 0, right - left, renderer->target.height);
    set_wireframe(renderer->gl, frame->scene->render.wireframe);
    scene_looks[look]->draw(renderer->look_states[look], frame);
    set_wireframe(renderer->gl, false);
}

/* The scene's picture; or, where techniques are compared, part of each, or the difference of their maps. */
static bool draw_picture(struct dpl_renderer *renderer, struct frame *frame)
{
    const struct dpl_compare *compare = &renderer->compare;
    const struct lit_map *maps = renderer->lighting.maps;
    const struct camera_view *view = &frame->view;
    int columns = view->columns, split = columns;
    if (compare->mode == DPL_COMPARE_DIFFERENCE) {
        frame->map = maps[LIT_SCENE].shown;
        return difference_draw(&renderer->difference, frame, maps[LIT_OTHER].shown, compare->gain, compare->range);
    }
    if (compare->mode == DPL_COMPARE_SPLIT)
        split = (int)lround(fmin(fmax(compare->place, 0), 1) * view->width) - view->left;
    renderer->gl->Enable(GL_SCISSOR_TEST);
    draw_part(renderer, frame, maps + LIT_SCENE, 0, split < columns ? split : columns);
    draw_part(renderer, frame, maps + LIT_OTHER, split > 0 ? split : 0, columns);
    renderer->gl->Disable(GL_SCISSOR_TEST);
    return true;
}

static bool prepare_look(struct dpl_renderer *renderer, const struct frame *frame)
{
    const int index = frame->scene->render.look;
    const struct scene_look *look = scene_looks[index];
    void **state = renderer->look_states + index;
    if (!*state)
        *state = base_allocate(renderer->log, 1, look->state_size, look->name);
    return *state && look->prepare(*state, frame);
}

/* Surface and light: all that does not depend on which part of the picture is drawn. */
static bool begin_frame(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time, struct frame *frame)
{
    struct dpl_gl *gl = renderer->gl;
    if (!gl)
        return base_fail(renderer->log, DPL_REASON_NO_GL, "a picture needs OpenGL, and there is none");
    timer_frame(&renderer->timer);
    bool compares = renderer->compare.mode != DPL_COMPARE_NOTHING;
    renderer->compared = false;
    if (!lighting_make(&renderer->lighting, scene, time, compares ? renderer->compare.technique : -1, true) ||
        (scene_looks[scene->render.look]->sand && !sand_update(gl, &renderer->sand, scene)))
        return false;
    renderer->compared = compares;
    renderer->camera = renderer->still ? scene->camera : scene_camera_at(scene, time);
    *frame = (struct frame){
        .gl = gl,
        .scene = scene,
        .camera = &renderer->camera,
        .params = scene->look_params[scene->render.look],
        .time = time,
        .setup = &renderer->lighting.setup,
        .surface = &renderer->lighting.surface_gpu,
        .above = lighting_above(&renderer->lighting),
        .windows = renderer->lighting.below.windows,
        .reflected = renderer->lighting.maps[LIT_REFLECTED].shown,
        .reflected_windows = renderer->lighting.above.windows,
        .sand = &renderer->sand.color,
        .timer = &renderer->timer,
        .progress = renderer->lighting.progress,
    };
    renderer->has_sphere = scene->sphere.radius > 0;
    water_sphere_center(water_models[scene->medium.model], &renderer->lighting.setup, renderer->sphere);
    memcpy(frame->sphere, renderer->sphere, sizeof frame->sphere);
    return true;
}

/* Points the frame's view through a place of the pixel, -0.5 to 0.5 each way. */
static void move_view(struct frame *frame, const double place[2])
{
    const struct camera_view *view = &frame->view;
    const double across[2] = {2 * place[0] / view->columns, 2 * place[1] / view->rows};
    frame->rays = camera_rays(frame->camera, view);
    camera_matrix(frame->camera, view, frame->view_projection);
    for (int c = 0; c < 3; c++)
        frame->rays.ahead[c] += across[0] * frame->rays.right[c] + across[1] * frame->rays.up[c];
    for (int column = 0; column < 4; column++)
        for (int a = 0; a < 2; a++)
            frame->view_projection[column * 4 + a] -= (float)across[a] * frame->view_projection[column * 4 + 3];
}

/* A picture of a look with linear light: the mean of its samples, shown by the tone pass. */
static bool draw_linear(struct dpl_renderer *renderer, struct frame *frame)
{
    struct dpl_gl *gl = renderer->gl;
    struct tone *tone = &renderer->tone;
    const double black[3] = {0, 0, 0};
    int samples = frame->scene->render.samples;
    for (int i = 0; i < samples; i++) {
        double place[2];
        tone_place(i, samples, place);
        move_view(frame, place);
        target_begin(gl, &tone->radiance, black);
        if (!draw_picture(renderer, frame))
            return false;
        timer_pass(&renderer->timer, "samples");
        if (samples > 1)
            tone_add(gl, tone, i);
    }
    timer_pass(&renderer->timer, "tone");
    target_begin(gl, &renderer->target, black);
    tone_show(gl, tone, samples, frame->camera, frame->scene->render.tone);
    return true;
}

static bool draw_encoded(struct dpl_renderer *renderer, struct frame *frame)
{
    target_begin(renderer->gl, &renderer->target, frame->scene->render.background);
    bool ok = draw_picture(renderer, frame);
    timer_pass(&renderer->timer, "finish");
    target_resolve(renderer->gl, &renderer->target);
    return ok;
}

/* The look into the renderer's own target. */
static bool draw_view(struct dpl_renderer *renderer, struct frame *frame, const struct camera_view *view)
{
    const struct scene_render *render = &frame->scene->render;
    bool linear = scene_looks[render->look]->linear;
    int columns = view->columns, rows = view->rows;
    frame->view = *view;
    frame->target = linear ? &renderer->tone.radiance : &renderer->target;
    move_view(frame, (const double[2]){0, 0});
    return target_resize(renderer->gl, &renderer->target, GL_RGBA8, columns, rows, linear ? 1 : render->samples) &&
           (!linear || tone_ready(renderer->gl, &renderer->tone, columns, rows, render->samples)) &&
           prepare_look(renderer, frame) && (linear ? draw_linear : draw_encoded)(renderer, frame);
}

bool dpl_renderer_draw(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time, unsigned framebuffer,
                       int width, int height)
{
    bool shown = framebuffer != DPL_NO_FRAMEBUFFER;
    const struct camera_view whole = {width, height, 0, 0, width, height};
    struct frame frame;
    bool ok = begin_frame(renderer, scene, time, &frame) && draw_view(renderer, &frame, &whole) &&
              (!shown || target_copy(renderer->gl, &renderer->target, framebuffer));
    timer_pass(&renderer->timer, NULL);
    if (renderer->gl && !shown)
        renderer->gl->Finish();
    return leave(renderer, shown ? framebuffer : 0) && ok;
}

/* Draws tile by tile. The passes of the first are those that are timed. */
static bool draw_tiles(struct dpl_renderer *renderer, struct frame *frame, const struct picture_tiles *tiles,
                       struct gpu_texture *texture, struct dpl_image *image)
{
    struct picture *picture = &renderer->picture;
    enum dpl_timing timing = renderer->timer.timing;
    int count = tiles->columns * tiles->rows;
    bool ok = true;
    for (int i = 0; ok && i < count; i++) {
        struct camera_view view = picture_view(tiles, i);
        ok = draw_view(renderer, frame, &view) && picture_read(picture, texture, renderer->gl, tiles, i, image);
        timer_pass(&renderer->timer, NULL);
        renderer->timer.timing = DPL_TIMING_OFF;
        if (!ok || !picture->progress || count == 1)
            continue;
        ok = leave(renderer, 0);
        picture->progress(picture->user, i + 1, count);
        gpu_enter(renderer->gl);
    }
    renderer->timer.timing = timing;
    return ok;
}

/* The scene's picture as a new image, from what `texture` of the renderer holds when it is drawn. */
static struct dpl_image *make_picture(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time,
                                      int width, int height, struct gpu_texture *texture)
{
    struct frame frame;
    struct dpl_image *image = dpl_image_create(width, height, renderer->log);
    bool ok = image && begin_frame(renderer, scene, time, &frame);
    if (ok) {
        struct picture_tiles tiles = picture_cut(&renderer->picture, renderer->gl, width, height, scene->render.samples,
                                                 scene_looks[scene->render.look]->margin);
        ok = draw_tiles(renderer, &frame, &tiles, texture, image);
    }
    timer_pass(&renderer->timer, NULL);
    ok = leave(renderer, 0) && ok;
    if (ok)
        return image;
    dpl_image_destroy(image);
    return NULL;
}

struct dpl_image *dpl_renderer_picture(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time,
                                       int width, int height)
{
    return make_picture(renderer, scene, time, width, height, &renderer->target.color);
}

struct dpl_image *dpl_renderer_radiance(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time,
                                        int width, int height)
{
    bool linear = scene_looks[scene->render.look]->linear;
    struct gpu_texture *texture =
        linear ? tone_radiance(&renderer->tone, scene->render.samples) : &renderer->target.color;
    return make_picture(renderer, scene, time, width, height, texture);
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
    return leave(renderer, 0) && ok;
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
