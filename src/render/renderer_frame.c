/* The way of a picture: surface → light → look, the look into the renderer's own target, and from there to the caller.
 */
#include "base/log.h"
#include "render/renderer_state.h"

#include <math.h>
#include <string.h>

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
    set_wireframe(renderer->gl, frame->scene->render.wireframe && !scene_looks[look]->linear);
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

/* A look's radiance is drawn sample by sample, and then shown; but the colours of a difference are what the screen
 * shows.
 */
static bool is_linear(const struct dpl_renderer *renderer, const struct dpl_scene *scene)
{
    return scene_looks[scene->render.look]->linear && renderer->compare.mode != DPL_COMPARE_DIFFERENCE;
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
    tone_show(tone, frame);
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
    bool linear = is_linear(renderer, frame->scene);
    int columns = view->columns, rows = view->rows;
    frame->view = *view;
    frame->target = linear ? &renderer->tone.radiance : &renderer->target;
    move_view(frame, (const double[2]){0, 0});
    if (linear && !renderer->gl->info.float_render)
        return base_fail(renderer->log, DPL_REASON_UNSUPPORTED, "look %s: this device cannot draw to floats",
                         scene_looks[render->look]->name);
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
    return renderer_leave(renderer, shown ? framebuffer : 0) && ok;
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
        ok = renderer_leave(renderer, 0);
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
        int samples = is_linear(renderer, scene) ? 1 : scene->render.samples; /* at once */
        struct picture_tiles tiles = picture_cut(&renderer->picture, renderer->gl, width, height, samples,
                                                 scene_looks[scene->render.look]->margin);
        ok = draw_tiles(renderer, &frame, &tiles, texture, image);
    }
    timer_pass(&renderer->timer, NULL);
    ok = renderer_leave(renderer, 0) && ok;
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
    const struct dpl_compare compare = renderer->compare; /* that is for pictures */
    renderer->compare = (struct dpl_compare){0};
    struct gpu_texture *texture =
        is_linear(renderer, scene) ? tone_radiance(&renderer->tone, scene->render.samples) : &renderer->target.color;
    struct dpl_image *image = make_picture(renderer, scene, time, width, height, texture);
    renderer->compare = compare;
    return image;
}
