/* The way of a frame: surface → light → look. See dapple/renderer.h. */
#include "dapple/renderer.h"

#include "base/log.h"
#include "light/blur.h"
#include "render/camera.h"
#include "render/look_collard.h"
#include "render/sand.h"
#include "render/thumbnail.h"

#include <stdlib.h>

struct dpl_renderer {
    struct dpl_gl *gl; /* NULL: CPU only */
    enum dpl_device device;
    const struct dpl_log *log;
    struct gpu_timer timer;

    struct wave waves[WATER_WAVES_MAX];
    struct water_setup setup;
    double receivers[LIGHT_SLICES_MAX];
    struct surface surface;
    struct surface_gpu surface_gpu;

    void *technique_states[SCENE_TECHNIQUES_MAX]; /* made when first used */
    struct light_progress progress;
    struct light_map map;
    struct gpu_texture map_texture, blurred_texture;
    const struct gpu_texture *shown_map; /* whichever of the two is finished */
    struct light_blur blur;

    struct sand sand;
    struct look_collard_state look_collard;
    struct gpu_target target;
    struct thumbnails thumbnails;
    unsigned char *pixels; /* a picture on its way back from the GPU */
    size_t pixels_size;
};

struct dpl_renderer *dpl_renderer_create(struct dpl_gl *gl, enum dpl_device device, const struct dpl_log *log)
{
    struct dpl_renderer *renderer = base_allocate(log, 1, sizeof *renderer, "renderer");
    if (!renderer)
        return NULL;
    renderer->gl = gl;
    renderer->device = device;
    renderer->log = log;
    renderer->timer.gl = gl;
    return renderer;
}

void dpl_renderer_destroy(struct dpl_renderer *renderer)
{
    if (!renderer)
        return;
    struct dpl_gl *gl = renderer->gl;
    for (int i = 0; light_techniques[i]; i++) {
        if (renderer->technique_states[i])
            light_techniques[i]->finish(renderer->technique_states[i], gl);
        free(renderer->technique_states[i]);
    }
    timer_finish(&renderer->timer);
    blur_finish(&renderer->blur, gl);
    light_map_finish(&renderer->map);
    surface_finish(&renderer->surface);
    if (gl) {
        surface_gpu_finish(gl, &renderer->surface_gpu);
        texture_finish(gl, &renderer->map_texture);
        texture_finish(gl, &renderer->blurred_texture);
        sand_finish(gl, &renderer->sand);
        look_collard_finish(&renderer->look_collard, gl);
        target_finish(gl, &renderer->target);
        thumbnails_finish(gl, &renderer->thumbnails);
        gpu_leave(gl, 0);
    }
    free(renderer->pixels);
    free(renderer);
}

/* Where the light is computed: on the CPU where asked, where OpenGL cannot, or where OpenGL itself runs there. */
static bool light_on_cpu(const struct dpl_renderer *renderer, const struct light_technique *technique)
{
    const struct dpl_gl *gl = renderer->gl;
    if (!gl || !gl->info.float_render || !technique->draw)
        return true;
    if (renderer->device == DPL_DEVICE_AUTO)
        return gl->info.software && technique->trace;
    return renderer->device == DPL_DEVICE_CPU;
}

static bool surface_on_gpu(const struct dpl_renderer *renderer, const struct dpl_scene *scene)
{
    return renderer->device != DPL_DEVICE_CPU &&
           surface_gpu_can_evaluate(renderer->gl, water_models[scene->medium.model]);
}

static bool check_side(const struct dpl_renderer *renderer, const char *what, int side)
{
    return !renderer->gl || side <= renderer->gl->info.texture_max ||
           base_fail(renderer->log, DPL_REASON_LIMIT, "%s: too large for this device: %d (at most %d a side)", what,
                     side, renderer->gl->info.texture_max);
}

static bool make_surface(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time, bool on_cpu,
                         bool on_gpu)
{
    const struct water_model *model = water_models[scene->medium.model];
    struct water_setup setup = scene_water_setup(scene, renderer->waves);
    timer_pass(&renderer->timer, "surface");
    if (renderer->gl)
        gpu_enter(renderer->gl);
    if (on_gpu && !check_side(renderer, "the water's grid", model->grid(&setup)))
        return false;
    if (on_gpu && !on_cpu && surface_on_gpu(renderer, scene))
        return surface_gpu_evaluate(renderer->gl, &renderer->surface_gpu, model, &setup, time);
    if (!water_evaluate(model, &setup, time, &renderer->surface, renderer->log))
        return false;
    if (on_gpu)
        surface_gpu_upload(renderer->gl, &renderer->surface_gpu, &renderer->surface);
    return true;
}

static void *technique_state(struct dpl_renderer *renderer, int index)
{
    void **state = renderer->technique_states + index;
    if (!*state)
        *state = base_allocate(renderer->log, 1, light_techniques[index]->state_size, light_techniques[index]->name);
    return *state;
}

static struct light_input light_input(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time)
{
    renderer->setup = scene_water_setup(scene, renderer->waves);
    return (struct light_input){
        .surface = &renderer->surface,
        .surface_gpu = &renderer->surface_gpu,
        .model = water_models[scene->medium.model],
        .setup = &renderer->setup,
        .time = time,
        .receivers = renderer->receivers,
        .slices = scene_receivers(scene, renderer->receivers),
        .sun = &scene->sun,
        .medium = &scene->medium,
        .settings = &scene->caustics,
        .progress = renderer->progress,
        .params = scene->technique_params[scene->caustics.technique],
        .log = renderer->log,
    };
}

static bool trace_light(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time)
{
    const struct light_technique *technique = light_techniques[scene->caustics.technique];
    if (!technique->trace)
        return base_fail(renderer->log, DPL_REASON_UNSUPPORTED,
                         "%s: has no CPU path (--device gl), or no OpenGL that it can use", technique->name);
    void *state = technique_state(renderer, scene->caustics.technique);
    struct light_input input = light_input(renderer, scene, time);
    if (!state ||
        !light_map_resize(&renderer->map, scene->caustics.map, technique->channels, input.slices, renderer->log))
        return false;
    timer_pass(&renderer->timer, "light");
    if (!technique->trace(state, &input, &renderer->map))
        return false;
    if (scene->caustics.blur)
        timer_pass(&renderer->timer, "blur");
    return blur_map(&renderer->blur, &renderer->map, scene->caustics.blur, renderer->log);
}

/* The format of a map texture: floats as the CPU makes them, halves as the GPU does. Smaller levels, which keep far
 * floor from flickering, need a device that draws to such formats. */
static void resize_map_texture(struct dpl_renderer *renderer, struct gpu_texture *texture, int side, int channels,
                               bool uploaded, bool finished)
{
    const struct dpl_gl_info *info = &renderer->gl->info;
    GLenum drawn = channels == 1 ? GL_R16F : GL_RGBA16F;
    GLenum half = channels == 1 ? GL_R16F : GL_RGB16F, full = channels == 1 ? GL_R32F : GL_RGB32F;
    GLenum format = !uploaded ? drawn : info->es ? half : full;
    bool levels = finished && info->float_render && !(info->es && format == GL_RGB16F);
    texture_resize(renderer->gl, texture, format, side, side, TEXTURE_CLAMP, levels ? TEXTURE_MIPMAP : TEXTURE_LINEAR);
}

static bool draw_light(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time)
{
    const struct light_technique *technique = light_techniques[scene->caustics.technique];
    void *state = technique_state(renderer, scene->caustics.technique);
    struct light_input input = light_input(renderer, scene, time);
    int side = scene->caustics.map;
    renderer->map.noise = 0;
    if (!state)
        return false;
    timer_pass(&renderer->timer, "light");
    resize_map_texture(renderer, &renderer->map_texture, side, technique->channels, false, scene->caustics.blur == 0);
    renderer->shown_map = &renderer->map_texture;
    if (!technique->draw(state, renderer->gl, &input, &renderer->map_texture))
        return false;
    if (scene->caustics.blur == 0)
        return true;
    timer_pass(&renderer->timer, "blur");
    resize_map_texture(renderer, &renderer->blurred_texture, side, technique->channels, false, true);
    renderer->shown_map = &renderer->blurred_texture;
    return blur_draw(&renderer->blur, renderer->gl, &renderer->map_texture, scene->caustics.blur,
                     &renderer->blurred_texture);
}

/* Surface and light. `textures`: the GPU needs both, to draw a picture with. */
static bool make_light(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time, bool textures)
{
    const struct light_technique *technique = light_techniques[scene->caustics.technique];
    bool on_cpu = light_on_cpu(renderer, technique);
    if (!check_side(renderer, "caustics.map", scene->caustics.map) ||
        !make_surface(renderer, scene, time, on_cpu, textures || !on_cpu))
        return false;
    if (on_cpu ? !trace_light(renderer, scene, time) : !draw_light(renderer, scene, time))
        return false;
    if (textures && on_cpu) {
        timer_pass(&renderer->timer, "upload");
        resize_map_texture(renderer, &renderer->map_texture, renderer->map.side, renderer->map.channels, true, true);
        texture_upload(renderer->gl, &renderer->map_texture, renderer->map.texels);
        renderer->shown_map = &renderer->map_texture;
    }
    if (textures && renderer->shown_map->filter == TEXTURE_MIPMAP) {
        timer_pass(&renderer->timer, "mipmaps");
        texture_make_mipmaps(renderer->gl, renderer->shown_map);
    }
    return true;
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
    bool on_gpu = surface_on_gpu(renderer, scene);
    timer_frame(&renderer->timer);
    bool ok = make_surface(renderer, scene, time, !on_gpu, on_gpu);
    timer_pass(&renderer->timer, NULL);
    if (ok && on_gpu)
        ok = surface_gpu_read(renderer->gl, &renderer->surface_gpu, &renderer->surface);
    ok = leave(renderer, 0) && ok;
    if (!ok)
        return NULL;
    const struct surface *surface = &renderer->surface;
    struct dpl_image *image = dpl_image_create(surface->columns, surface->rows, renderer->log);
    for (size_t i = 0; image && i < (size_t)surface->columns * (size_t)surface->rows * 3; i++)
        image->pixels[i] = surface->texels[i];
    return image;
}

/* The finished map as an image of three channels. */
static struct dpl_image *map_image(struct dpl_renderer *renderer, int channels)
{
    const struct light_map *map = &renderer->map;
    struct dpl_image *image = dpl_image_create(map->side, map->side, renderer->log);
    for (size_t i = 0; image && i < (size_t)map->side * (size_t)map->side; i++)
        for (size_t c = 0; c < 3; c++)
            image->pixels[i * 3 + c] = map->texels[channels == 1 ? i : i * 3 + c];
    return image;
}

static struct dpl_image *read_map(struct dpl_renderer *renderer, int channels)
{
    struct dpl_gl *gl = renderer->gl;
    int side = renderer->shown_map->width;
    struct dpl_image *image = dpl_image_create(side, side, renderer->log);
    float *texels = image ? base_allocate(renderer->log, (size_t)side * (size_t)side * 4, sizeof *texels, "map") : NULL;
    if (!texels) {
        dpl_image_destroy(image);
        return NULL;
    }
    gl->BindFramebuffer(GL_FRAMEBUFFER, renderer->shown_map->framebuffer);
    gl->ReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, texels);
    for (size_t i = 0; i < (size_t)side * (size_t)side; i++)
        for (size_t c = 0; c < 3; c++)
            image->pixels[i * 3 + c] = texels[i * 4 + (channels == 1 ? 0 : c)];
    free(texels);
    return image;
}

struct dpl_image *dpl_renderer_map(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time)
{
    const struct light_technique *technique = light_techniques[scene->caustics.technique];
    timer_frame(&renderer->timer);
    bool ok = make_light(renderer, scene, time, false);
    timer_pass(&renderer->timer, NULL);
    struct dpl_image *image = NULL;
    if (ok && light_on_cpu(renderer, technique))
        image = map_image(renderer, technique->channels);
    else if (ok)
        image = read_map(renderer, technique->channels);
    return leave_with_image(renderer, image);
}

/* Surface, light and look into the renderer's own target. */
static bool draw_frame(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time, int width, int height)
{
    struct dpl_gl *gl = renderer->gl;
    if (!gl)
        return base_fail(renderer->log, DPL_REASON_NO_GL, "a picture needs OpenGL, and there is none");
    timer_frame(&renderer->timer);
    if (!make_light(renderer, scene, time, true) || !sand_update(gl, &renderer->sand, scene) ||
        !target_resize(gl, &renderer->target, width, height, scene->render.samples))
        return false;
    struct frame frame = {
        .gl = gl,
        .scene = scene,
        .surface = &renderer->surface_gpu,
        .map = renderer->shown_map,
        .map_channels = light_techniques[scene->caustics.technique]->channels,
        .sand = &renderer->sand.color,
        .timer = &renderer->timer,
    };
    camera_matrix(&scene->camera, width, height, frame.view_projection);
    target_begin(gl, &renderer->target, scene->render.background);
    bool ok = look_collard_draw(&renderer->look_collard, &frame);
    timer_pass(&renderer->timer, "finish");
    target_resolve(gl, &renderer->target);
    return ok;
}

bool dpl_renderer_draw(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time, unsigned framebuffer,
                       int width, int height)
{
    bool shown = framebuffer != DPL_NO_FRAMEBUFFER;
    bool ok = draw_frame(renderer, scene, time, width, height) &&
              (!shown || target_copy(renderer->gl, &renderer->target, framebuffer));
    timer_pass(&renderer->timer, NULL);
    if (renderer->gl && !shown)
        renderer->gl->Finish();
    return leave(renderer, shown ? framebuffer : 0) && ok;
}

static struct dpl_image *read_picture(struct dpl_renderer *renderer)
{
    int width = renderer->target.width, height = renderer->target.height;
    size_t size = (size_t)width * (size_t)height * 4;
    if (renderer->pixels_size < size) {
        free(renderer->pixels);
        renderer->pixels = base_allocate(renderer->log, size, 1, "picture");
        renderer->pixels_size = renderer->pixels ? size : 0;
    }
    struct dpl_image *image = renderer->pixels ? dpl_image_create(width, height, renderer->log) : NULL;
    if (!image)
        return NULL;
    target_read(renderer->gl, &renderer->target, renderer->pixels, image);
    return image;
}

struct dpl_image *dpl_renderer_picture(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time,
                                       int width, int height)
{
    bool ok = draw_frame(renderer, scene, time, width, height);
    timer_pass(&renderer->timer, NULL);
    return leave_with_image(renderer, ok ? read_picture(renderer) : NULL);
}

void dpl_renderer_progress(struct dpl_renderer *renderer, bool (*step)(void *user, double done), void *user)
{
    renderer->progress = (struct light_progress){step, user};
}

double dpl_renderer_noise(const struct dpl_renderer *renderer)
{
    return renderer->map.noise;
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
    const struct dpl_pass_time *times = renderer->timer.times;
    for (int i = 0; i < index && times[i].name; i++)
        if (!times[i + 1].name)
            return (struct dpl_pass_time){0};
    return times[index];
}

struct dpl_thumbnail dpl_renderer_thumbnail(struct dpl_renderer *renderer, int index)
{
    if (!renderer->gl || !renderer->shown_map)
        return (struct dpl_thumbnail){0};
    gpu_enter(renderer->gl);
    struct dpl_thumbnail thumbnail =
        thumbnails_draw(renderer->gl, &renderer->thumbnails, index, &renderer->surface_gpu, renderer->shown_map);
    gpu_leave(renderer->gl, 0);
    return thumbnail;
}
