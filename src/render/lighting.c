#include "render/lighting.h"

#include "base/log.h"

#include <stdlib.h>

/* One set of maps to make. */
struct task {
    const struct dpl_scene *scene;
    double time;
    const struct light_technique *technique;
    struct lit_map *lit;
    const struct lit_receivers *receivers;
    int blur;                  /* texels */
    const char *const *passes; /* names, as enum pass */
    bool texture;
};

enum pass { PASS_LIGHT, PASS_BLUR, PASS_UPLOAD, PASS_MIPMAPS, PASSES };
static const char *const passes[LIT_MAPS][PASSES] = {
    {"light", "blur", "upload", "mipmaps"},
    {"other light", "other blur", "other upload", "other mipmaps"},
    {"reflected light", "reflected blur", "reflected upload", "reflected mipmaps"},
};

bool lighting_drop(struct lighting *lighting, struct water_drop drop)
{
    if (lighting->drop_count == LIGHTING_DROPS_MAX)
        return base_fail(lighting->log, DPL_REASON_LIMIT, "drop: too many wait for the next frame (at most %d)",
                         LIGHTING_DROPS_MAX);
    lighting->drops[lighting->drop_count++] = drop;
    return true;
}

/* Where the light is computed: on the CPU where asked, where OpenGL cannot, or where OpenGL itself runs there. */
static bool light_on_cpu(const struct lighting *lighting, const struct light_technique *technique)
{
    const struct dpl_gl *gl = lighting->gl;
    if (!gl || !gl->info.float_render || !technique->draw)
        return true;
    if (lighting->device == DPL_DEVICE_AUTO)
        return gl->info.software && technique->trace;
    return lighting->device == DPL_DEVICE_CPU;
}

static bool surface_on_gpu(const struct lighting *lighting, const struct dpl_scene *scene)
{
    return lighting->device != DPL_DEVICE_CPU &&
           surface_gpu_can_evaluate(lighting->gl, water_models[scene->medium.model]);
}

static bool check_side(const struct lighting *lighting, const char *what, int side)
{
    return !lighting->gl || side <= lighting->gl->info.texture_max ||
           base_fail(lighting->log, DPL_REASON_LIMIT, "%s: too large for this device: %d (at most %d a side)", what,
                     side, lighting->gl->info.texture_max);
}

static bool ready_water(struct lighting *lighting, const struct dpl_scene *scene, double time)
{
    const struct water_model *model = water_models[scene->medium.model];
    struct water_setup *setup = &lighting->setup;
    *setup = scene_water_setup(scene, lighting->waves);
    setup->memory = &lighting->memory;
    setup->drops = lighting->drops;
    setup->drop_count = lighting->drop_count;
    lighting->drop_count = 0;
    bool periodic = model->shape(setup).periodic;
    struct lit_receivers *below = &lighting->below, *above = &lighting->above;
    below->count = scene_receivers(scene, below->heights);
    above->count = scene_reflected(scene, above->heights);
    scene_windows(scene, periodic, below->heights, below->count, below->windows);
    scene_windows(scene, periodic, above->heights, above->count, above->windows);
    return water_prepare(model, setup, time, lighting->log);
}

static bool make_surface(struct lighting *lighting, const struct dpl_scene *scene, double time, bool on_cpu,
                         bool on_gpu)
{
    const struct water_model *model = water_models[scene->medium.model];
    const struct water_setup *setup = &lighting->setup;
    timer_pass(lighting->timer, "surface");
    if (lighting->gl)
        gpu_enter(lighting->gl);
    if (!ready_water(lighting, scene, time))
        return false;
    if (!on_cpu && !on_gpu)
        return true;
    if (on_gpu && !check_side(lighting, "the water's grid", model->shape(setup).side))
        return false;
    if (on_gpu && !on_cpu && surface_on_gpu(lighting, scene))
        return surface_gpu_evaluate(lighting->gl, &lighting->surface_gpu, model, setup, time);
    if (!water_evaluate(model, setup, time, &lighting->surface, lighting->log))
        return false;
    if (on_gpu)
        surface_gpu_upload(lighting->gl, &lighting->surface_gpu, &lighting->surface);
    return true;
}

bool lighting_make_surface(struct lighting *lighting, const struct dpl_scene *scene, double time)
{
    bool on_gpu = surface_on_gpu(lighting, scene);
    bool ok = make_surface(lighting, scene, time, !on_gpu, on_gpu);
    timer_pass(lighting->timer, NULL);
    return ok && (!on_gpu || surface_gpu_read(lighting->gl, &lighting->surface_gpu, &lighting->surface));
}

static void *technique_state(struct lighting *lighting, const struct task *task)
{
    bool above = task->receivers == &lighting->above;
    void **state = lighting->technique_states[above] + task->lit->technique;
    if (!*state)
        *state = base_allocate(lighting->log, 1, task->technique->state_size, task->technique->name);
    return *state;
}

static struct light_input light_input(struct lighting *lighting, const struct task *task)
{
    const struct dpl_scene *scene = task->scene;
    const struct water_model *model = water_models[scene->medium.model];
    bool flat = task->technique->vertical && model->shape(&lighting->setup).choppy;
    return (struct light_input){
        .surface = flat ? &lighting->flat : &lighting->surface,
        .surface_gpu = flat ? &lighting->flat_gpu : &lighting->surface_gpu,
        .model = model,
        .setup = &lighting->setup,
        .time = task->time,
        .receivers = task->receivers->heights,
        .slices = task->receivers->count,
        .windows = task->receivers->windows,
        .sun = &scene->sun,
        .medium = &scene->medium,
        .settings = &scene->caustics,
        .seed = scene->settings.seed,
        .progress = lighting->progress,
        .params = scene->technique_params[task->lit->technique],
        .log = lighting->log,
    };
}

static bool trace_light(struct lighting *lighting, const struct task *task)
{
    const struct light_technique *technique = task->technique;
    if (!technique->trace)
        return base_fail(lighting->log, DPL_REASON_UNSUPPORTED,
                         "%s: has no CPU path (--device gl), or no OpenGL that it can use", technique->name);
    void *state = technique_state(lighting, task);
    struct light_input input = light_input(lighting, task);
    struct light_map *map = &task->lit->map;
    if (!state || !light_map_resize(map, task->scene->caustics.map, technique->channels, input.slices, lighting->log))
        return false;
    timer_pass(lighting->timer, task->passes[PASS_LIGHT]);
    if (!technique->trace(state, &input, map))
        return false;
    if (task->blur)
        timer_pass(lighting->timer, task->passes[PASS_BLUR]);
    return blur_map(&lighting->blur, map, task->blur, lighting->log);
}

static void resize_texture(struct lighting *lighting, const struct task *task, struct gpu_texture *texture,
                           enum map_origin origin, bool finished)
{
    const struct dpl_scene *scene = task->scene;
    bool periodic = water_models[scene->medium.model]->shape(&lighting->setup).periodic;
    map_texture_resize(lighting->gl, texture, scene->caustics.map, task->technique->channels, task->receivers->count,
                       origin, finished, periodic);
}

static bool draw_light(struct lighting *lighting, const struct task *task)
{
    struct lit_map *lit = task->lit;
    void *state = technique_state(lighting, task);
    struct light_input input = light_input(lighting, task);
    lit->map.noise = 0;
    if (!state)
        return false;
    timer_pass(lighting->timer, task->passes[PASS_LIGHT]);
    resize_texture(lighting, task, &lit->texture, MAP_DRAWN, task->blur == 0 && task->texture);
    lit->shown = &lit->texture;
    if (!task->technique->draw(state, lighting->gl, &input, &lit->texture))
        return false;
    if (task->blur == 0)
        return true;
    timer_pass(lighting->timer, task->passes[PASS_BLUR]);
    resize_texture(lighting, task, &lit->blurred, MAP_DRAWN, task->texture);
    lit->shown = &lit->blurred;
    return blur_draw(&lighting->blur, lighting->gl, &lit->texture, task->blur, &lit->blurred);
}

static bool make_map(struct lighting *lighting, const struct task *task)
{
    struct lit_map *lit = task->lit;
    if (lit->on_cpu ? !trace_light(lighting, task) : !draw_light(lighting, task))
        return false;
    if (task->texture && lit->on_cpu) {
        timer_pass(lighting->timer, task->passes[PASS_UPLOAD]);
        resize_texture(lighting, task, &lit->texture, MAP_UPLOADED, true);
        if (!map_texture_upload(lighting->gl, &lit->texture, &lit->map, &lit->room))
            return false;
        lit->shown = &lit->texture;
    }
    if (task->texture && lit->shown->filter == TEXTURE_MIPMAP) {
        timer_pass(lighting->timer, task->passes[PASS_MIPMAPS]);
        texture_make_mipmaps(lighting->gl, lit->shown);
    }
    return true;
}

static bool check_technique(const struct lighting *lighting, const struct dpl_scene *scene,
                            const struct light_technique *technique)
{
    return scene->caustics.ceiling == 0 || technique->reflects ||
           base_fail(lighting->log, DPL_REASON_UNSUPPORTED,
                     "caustics.ceiling: %s maps no reflected light: \"%g\" (accepted: 0)", technique->name,
                     scene->caustics.ceiling);
}

/* Choppy water as who looks straight up sees it. */
static bool flatten(struct lighting *lighting, const struct dpl_scene *scene, bool on_cpu, bool on_gpu)
{
    if (!water_models[scene->medium.model]->shape(&lighting->setup).choppy)
        return true;
    return (!on_cpu || surface_flatten(&lighting->surface, &lighting->flat, lighting->log)) &&
           (!on_gpu || surface_gpu_flatten(lighting->gl, &lighting->surface_gpu, &lighting->flat_gpu));
}

const struct surface_gpu *lighting_above(const struct lighting *lighting)
{
    return lighting->surface_gpu.choppy ? &lighting->flat_gpu : &lighting->surface_gpu;
}

/* The maps to make; returns how many. */
static int plan(struct lighting *lighting, const struct dpl_scene *scene, double time, int other, bool textures,
                struct task tasks[LIT_MAPS])
{
    const int techniques[LIT_MAPS] = {scene->caustics.technique, other, scene->caustics.technique};
    const bool wanted[LIT_MAPS] = {true, other >= 0,
                                   textures && scene->caustics.reflected_slices > 0 &&
                                       light_techniques[scene->caustics.technique]->reflects};
    int count = 0;
    for (int i = 0; i < LIT_MAPS; i++) {
        struct lit_map *lit = lighting->maps + i;
        lit->shown = NULL;
        if (!wanted[i])
            continue;
        const struct light_technique *technique = light_techniques[techniques[i]];
        /* What a technique is measured against is the truth, and the truth is not blurred. */
        int blur = i == LIT_OTHER && technique->refines ? 0 : scene->caustics.blur;
        const struct lit_receivers *receivers = i == LIT_REFLECTED ? &lighting->above : &lighting->below;
        lit->technique = techniques[i];
        lit->on_cpu = light_on_cpu(lighting, technique);
        tasks[count++] = (struct task){scene, time, technique, lit, receivers, blur, passes[i], textures};
    }
    return count;
}

bool lighting_make(struct lighting *lighting, const struct dpl_scene *scene, double time, int other, bool textures)
{
    struct task tasks[LIT_MAPS];
    int count = plan(lighting, scene, time, other, textures, tasks);
    bool cpu_surface = false, gpu_surface = textures, cpu_flat = false, gpu_flat = textures;
    bool ok = check_side(lighting, "caustics.map", scene->caustics.map);
    for (int i = 0; i < count; i++) {
        const struct light_technique *technique = tasks[i].technique;
        bool on_cpu = tasks[i].lit->on_cpu;
        cpu_surface = cpu_surface || (on_cpu && !technique->refines);
        gpu_surface = gpu_surface || !on_cpu;
        cpu_flat = cpu_flat || (technique->vertical && on_cpu);
        gpu_flat = gpu_flat || (technique->vertical && !on_cpu);
        ok = ok && check_technique(lighting, scene, technique);
    }
    ok = ok && make_surface(lighting, scene, time, cpu_surface, gpu_surface) &&
         flatten(lighting, scene, cpu_flat, gpu_flat);
    for (int i = 0; i < count; i++)
        ok = ok && make_map(lighting, tasks + i);
    return ok;
}

struct dpl_image *lighting_image(struct lighting *lighting, struct lit_map *lit, int slice)
{
    return lit->on_cpu ? light_map_image(&lit->map, slice, lighting->log)
                       : map_texture_read(lighting->gl, lit->shown, slice);
}

void lighting_finish(struct lighting *lighting)
{
    struct dpl_gl *gl = lighting->gl;
    for (int i = 0; light_techniques[i]; i++) {
        for (int above = 0; above < 2; above++) {
            void *state = lighting->technique_states[above][i];
            if (state)
                light_techniques[i]->finish(state, gl);
            free(state);
        }
    }
    blur_finish(&lighting->blur, gl);
    surface_finish(&lighting->surface);
    surface_finish(&lighting->flat);
    water_memory_finish(&lighting->memory, gl);
    if (gl) {
        surface_gpu_finish(gl, &lighting->surface_gpu);
        surface_gpu_finish(gl, &lighting->flat_gpu);
    }
    for (int i = 0; i < LIT_MAPS; i++) {
        light_map_finish(&lighting->maps[i].map);
        free(lighting->maps[i].room.texels);
        if (gl) {
            texture_finish(gl, &lighting->maps[i].texture);
            texture_finish(gl, &lighting->maps[i].blurred);
        }
    }
}
