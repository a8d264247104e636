/* The ground truth of a picture: a path tracer on the CPU (reference/camera.h), which refines its picture from call to
 * call as long as nothing changes. It needs no caustic map: what caustics.technique makes is not in the picture. */
#include "render/frame.h"
#include "render/traced_world.h"

#include "base/hash.h"
#include "base/log.h"
#include "reference/camera.h"

#include <stdlib.h>
#include <string.h>

/* [look.path-traced] */
struct look {
    int passes, bounces, mesh;
    double photons;
    double solid_radius, water_radius; /* m */
};

static const struct dpl_param params[] = {
    PARAM_INT(struct look, passes, 64, 1, 1000000, "", "paths for each pixel; more have less noise"),
    PARAM_INT(struct look, bounces, 6, 1, 1000, "", "most reflections by solids and scatterings in water of a path"),
    PARAM_INT(struct look, mesh, 1024, 2, 8192, "", "vertices of the water's mesh a side of the tile"),
    PARAM_FLOAT(struct look, photons, 1, 0.001, 1000, "",
                "of sunlight that has met water, for each pixel and pass; at most 10 million a pass"),
    PARAM_FLOAT(struct look, solid_radius, 0.002, 1e-5, 10, "m",
                "light of photons on solids is smeared over that, or over a pixel's width where that is more"),
    PARAM_FLOAT(struct look, water_radius, 0.03, 1e-4, 10, "m", "the same in the water"),
    PARAM_END,
};

struct state {
    struct gpu_program copy;
    struct gpu_texture picture;
    struct optics_sky sky;
    struct world solids;
    struct traced_world traced;
    struct surface water;
    struct camera camera;
    uint64_t fingerprint; /* of what the picture shows */
    size_t pixels;        /* that there is room for */
    float *radiance;      /* of the part that is drawn */
};

/* All of the picture, of which parts may be drawn one after the other. */
static struct camera_sight sight_of(const struct frame *frame)
{
    struct camera_sight sight = {.width = frame->view.width, .height = frame->view.height};
    const struct camera_view whole = {sight.width, sight.height, 0, 0, sight.width, sight.height};
    struct camera_rays rays = camera_rays(frame->camera, &whole);
    memcpy(sight.eye, frame->camera->position, sizeof sight.eye);
    memcpy(sight.ahead, rays.ahead, sizeof sight.ahead);
    memcpy(sight.right, rays.right, sizeof sight.right);
    memcpy(sight.up, rays.up, sizeof sight.up);
    return sight;
}

/* A number that differs where a picture does: all values of the scene but how it is exposed. */
static uint64_t fingerprint_of(const struct state *state, const struct frame *frame)
{
    uint64_t value = hash_bytes(state->sky.fingerprint, &state->solids.fingerprint, sizeof state->solids.fingerprint);
    struct look look = *(const struct look *)frame->params;
    look.passes = 0; /* more of them go on from where the picture is */
    value = hash_params(hash_number(value, frame->time), params, &look);
    struct camera_sight sight = sight_of(frame);
    value = water_hash(hash_bytes(value, &sight, sizeof sight), water_models[frame->scene->medium.model], frame->setup,
                       frame->time);
    static const char *const sections[] = {"scene", "water", "sun", "sky", "floor", "current"};
    struct dpl_section section;
    for (int i = 0; (section = dpl_scene_section(frame->scene, i)).name; i++) {
        bool shown = false;
        for (size_t k = 0; k < sizeof sections / sizeof *sections; k++)
            shown = shown || !strcmp(section.name, sections[k]);
        if (shown)
            value = hash_params(value, section.params, section.values);
    }
    return value;
}

static bool read_sand(struct traced_world *traced, const struct frame *frame)
{
    struct gpu_texture sand = *frame->sand;
    traced->sand_side = sand.width;
    traced->sand = base_allocate(frame->gl->log, (size_t)sand.width * (size_t)sand.height, 4, "sand");
    if (!traced->sand)
        return false;
    texture_draw_to(frame->gl, &sand);
    frame->gl->ReadPixels(0, 0, sand.width, sand.height, GL_RGBA, GL_UNSIGNED_BYTE, traced->sand);
    return true;
}

static bool make_water(struct state *state, const struct frame *frame)
{
    const struct water_model *model = water_models[frame->scene->medium.model];
    const struct look *look = frame->params;
    struct water_shape shape = model->shape(frame->setup);
    if (!surface_resize(&state->water, look->mesh, look->mesh, shape.periodic, shape.choppy, frame->setup->size,
                        frame->gl->log))
        return false;
    water_fill(model, frame->setup, frame->time, &state->water);
    state->traced.camera.water.surface = &state->water;
    return true;
}

/* Starts a picture of what now is to be seen. */
static bool begin(struct state *state, const struct frame *frame)
{
    const struct dpl_log *log = frame->gl->log;
    const struct look *look = frame->params;
    const struct camera_settings settings = {look->bounces, look->photons, look->solid_radius, look->water_radius};
    const struct camera_sight sight = sight_of(frame);
    camera_finish(&state->camera);
    traced_world_finish(&state->traced);
    return traced_world_make(&state->traced, frame->scene, &state->solids, &state->sky, NULL, frame->above->periodic,
                             frame->time, log) &&
           read_sand(&state->traced, frame) && make_water(state, frame) &&
           camera_begin(&state->camera, &state->traced.camera, &sight, &settings, log);
}

/* For the radiance of the part of the picture that is drawn. */
static bool make_room(struct state *state, const struct frame *frame)
{
    size_t pixels = (size_t)frame->view.columns * (size_t)frame->view.rows;
    if (state->radiance && pixels <= state->pixels)
        return true;
    free(state->radiance);
    state->radiance = base_allocate(frame->gl->log, pixels * 4, sizeof *state->radiance, "picture");
    state->pixels = state->radiance ? pixels : 0;
    return state->radiance != NULL;
}

static bool prepare(void *state_, const struct frame *frame)
{
    struct state *state = state_;
    struct dpl_gl *gl = frame->gl;
    if (!program_ready(gl, &state->copy, "gpu/copy.glsl", "") ||
        !optics_sky_make(&state->sky, &frame->scene->sky, &frame->scene->sun, gl->log) ||
        !world_build(&state->solids, frame->scene, gl->log))
        return false;
    if (!make_room(state, frame))
        return false;
    uint64_t fingerprint = fingerprint_of(state, frame);
    if (state->camera.sums && state->fingerprint == fingerprint)
        return true;
    state->fingerprint = fingerprint;
    return begin(state, frame);
}

/* Passes until there are enough, or until the caller wants no more of them now. */
static void refine(struct state *state, const struct frame *frame)
{
    const struct look *look = frame->params;
    const struct light_progress *progress = &frame->progress;
    bool stopped = state->camera.passes >= look->passes;
    while (!stopped) {
        camera_pass(&state->camera);
        double done = (double)state->camera.passes / look->passes;
        stopped = state->camera.passes >= look->passes || (progress->step && !progress->step(progress->user, done));
    }
}

static void draw(void *state_, const struct frame *frame)
{
    struct state *state = state_;
    struct dpl_gl *gl = frame->gl;
    timer_pass(frame->timer, "paths");
    refine(state, frame);
    const struct camera_view *view = &frame->view;
    camera_read(&state->camera, view->left, view->bottom, view->columns, view->rows, state->radiance);
    timer_pass(frame->timer, "picture");
    texture_resize(gl, &state->picture, GL_RGBA32F, view->columns, view->rows, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_upload(gl, &state->picture, state->radiance);
    program_use(gl, &state->copy);
    texture_bind(gl, &state->picture, 0);
    program_int(gl, &state->copy, "picture", 0);
    gpu_draw_screen(gl);
}

static void finish(void *state_, struct dpl_gl *gl)
{
    struct state *state = state_;
    program_finish(gl, &state->copy);
    texture_finish(gl, &state->picture);
    camera_finish(&state->camera);
    traced_world_finish(&state->traced);
    surface_finish(&state->water);
    world_finish(&state->solids);
    optics_sky_finish(&state->sky);
    free(state->radiance);
}

const struct scene_look look_path_traced = {
    .name = "path-traced",
    .section = "look.path-traced",
    .summary = "the ground truth: paths of light on the CPU, refined pass by pass (Kajiya 1986, Jensen 1996)",
    .params = params,
    .params_size = sizeof(struct look),
    .state_size = sizeof(struct state),
    .sand = true,
    .linear = true,
    .prepare = prepare,
    .draw = draw,
    .finish = finish,
};
