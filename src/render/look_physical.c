/* The physical look: one light, that of the caustic maps, on the floor and on everything else, in the water and in the
 * air, and in the water itself; seen through a surface that mirrors and refracts. physical.h has the order of a frame.
 *
 * Radiance throughout; the eye may be above the water or in it. */
#include "render/physical.h"

#include "base/log.h"

#include <math.h>

#define RINGS 240
#define RING_VERTICES 320
#define HORIZON 20000.0 /* m, of the sea's last ring */

static const struct dpl_param params[] = {
    PARAM_BOOL(struct physical_settings, caustics, true,
               "off: the light of flat water, which has the same mean, everywhere"),
    PARAM_BOOL(struct physical_settings, shafts, true, "light shafts in the water, where the eye is in it"),
    PARAM_END,
};

static const struct quality qualities[] = {
    [SCENE_QUALITY_LOW] = {1024, 4, 12, 4, 0.5, 0.5, 128, 1},
    [SCENE_QUALITY_MEDIUM] = {2048, 8, 20, 2, 0.75, 0.5, 256, 1},
    [SCENE_QUALITY_HIGH] = {4096, 12, 32, 2, 1, 1, 512, 2},
    [SCENE_QUALITY_ULTRA] = {4096, 24, 64, 1, 1, 1, 1024, 3},
};

static bool update_layers(struct physical *physical, const struct frame *frame)
{
    const double scales[LAYERS] = {1, physical->quality.through_scale, physical->quality.mirror_scale};
    for (int i = 0; i < LAYERS; i++) {
        int width = (int)ceil(scales[i] * frame->view.columns), height = (int)ceil(scales[i] * frame->view.rows);
        if (!layer_resize(frame->gl, physical->layers + i, GL_RGBA16F, width, height))
            return false;
    }
    return layer_resize(frame->gl, &physical->mesh, 0, frame->view.columns, frame->view.rows);
}

static bool prepare_programs(struct physical *physical, struct dpl_gl *gl)
{
    static const char *const backdrops[2] = {"#define NO_PANE\n", "#define PANE\n"};
    static const char *const seas[SEA_KINDS] = {"#define NO_PANE\n#define ABOVE\n",
                                                "#define NO_PANE\n#define ABOVE\n#define MIRRORED\n",
                                                "#define NO_PANE\n", "#define PANE\n"};
    for (int i = 0; i < 2; i++)
        if (!program_ready(gl, physical->backdrops + i, "render/backdrop.glsl", backdrops[i]))
            return false;
    for (int i = 0; i < SEA_KINDS; i++)
        if (!program_ready(gl, physical->seas + i, "render/sea.glsl", seas[i]))
            return false;
    return program_ready(gl, &physical->sea_mesh, "render/sea_mesh.glsl", "");
}

static bool prepare(void *state, const struct frame *frame)
{
    struct physical *physical = state;
    struct dpl_gl *gl = frame->gl;
    physical->quality = qualities[frame->scene->render.quality];
    if (!optics_sky_make(&physical->sky, &frame->scene->sky, &frame->scene->sun, gl->log) ||
        !sky_texture_update(&physical->sky_texture, gl, &physical->sky) ||
        !world_build(&physical->world, frame->scene, gl->log))
        return false;
    physical->light = physical_light(&physical->sky, frame);
    bool ok = update_layers(physical, frame) && rings_ready(&physical->rings, gl, RINGS, RING_VERTICES) &&
              shadow_prepare(&physical->shadow, frame, physical) && solids_prepare(&physical->solids, gl, physical) &&
              seabed_prepare(&physical->seabed, frame, physical) && ambient_update(physical, frame) &&
              shafts_prepare(&physical->shafts, frame, &physical->quality) && prepare_programs(physical, gl) &&
              waves_update(&physical->waves, frame);
    if (ok) {
        solids_find_dry(&physical->solids, frame, &physical->world, physical->waves.reach);
        timer_pass(frame->timer, "shadow");
        shadow_draw(&physical->shadow, frame, physical);
    }
    return ok;
}

/* What stands on one side of the surface, as a layer shows it. */
static void draw_layer(const struct physical *physical, const struct frame *frame, enum physical_layer layer, bool wet)
{
    struct dpl_gl *gl = frame->gl;
    layer_begin(gl, physical->layers + layer);
    gl->Enable(GL_DEPTH_TEST);
    solids_draw(physical, frame, layer, wet);
    if (wet)
        seabed_draw(physical, frame, layer);
    gl->Disable(GL_DEPTH_TEST);
}

/* Where the water's surface is not. */
static void draw_backdrop(const struct physical *physical, const struct frame *frame)
{
    struct dpl_gl *gl = frame->gl;
    const struct gpu_program *program = physical->backdrops + physical->sight.pane;
    program_use(gl, program);
    physical_bind(physical, frame, program);
    physical_bind_layers(physical, frame, program);
    if (!physical->sight.pane)
        gl->Enable(GL_DEPTH_TEST);
    gpu_draw_screen(gl);
    gl->Disable(GL_DEPTH_TEST);
}

static enum sea_kind sea_kind(const struct physical *physical)
{
    if (physical->sight.side < 0)
        return physical->sight.pane ? SEA_PANE : SEA_BELOW;
    return physical->solids.dry.high[1] > 0 ? SEA_MIRRORING : SEA_ABOVE;
}

static void draw_sea_mesh(const struct physical *physical, const struct frame *frame, int width, int height)
{
    struct dpl_gl *gl = frame->gl;
    const struct gpu_program *program = &physical->sea_mesh;
    physical_begin_mesh(physical, gl, width, height);
    program_use(gl, program);
    physical_bind(physical, frame, program);
    gl->Enable(GL_DEPTH_TEST);
    rings_draw(&physical->rings, frame, program, frame->camera->position[1], HORIZON, waves_extent(frame));
    gl->Disable(GL_DEPTH_TEST);
}

/* The surface where its mesh is seen, into what is drawn to. */
static void draw_sea(const struct physical *physical, const struct frame *frame)
{
    struct dpl_gl *gl = frame->gl;
    const struct gpu_program *program = physical->seas + sea_kind(physical);
    program_use(gl, program);
    physical_bind(physical, frame, program);
    physical_bind_layers(physical, frame, program);
    program_int(gl, program, "look_ups", physical->quality.look_ups);
    program_vec3(gl, program, "dry_low", physical->solids.dry.low);
    program_vec3(gl, program, "dry_high", physical->solids.dry.high);
    texture_bind(gl, &physical->mesh.depth, UNIT_SEA_DEPTH);
    program_int(gl, program, "mesh_depth", UNIT_SEA_DEPTH);
    gl->Enable(GL_DEPTH_TEST);
    gpu_draw_screen(gl);
    gl->Disable(GL_DEPTH_TEST);
}

/* The surface as part of a layer. */
static void draw_sea_behind_pane(const struct physical *physical, const struct frame *frame)
{
    const struct gpu_layer *through = physical->layers + LAYER_THROUGH;
    draw_sea_mesh(physical, frame, through->depth.width, through->depth.height);
    layer_resume(frame->gl, through);
    draw_sea(physical, frame);
}

/* The three layers, as they are seen from the air and from the water. */
static void draw_layers(const struct physical *physical, const struct frame *frame)
{
    bool pane = physical->sight.pane, in_water = physical->sight.side < 0;
    timer_pass(frame->timer, "straight");
    draw_layer(physical, frame, LAYER_DIRECT, in_water && !pane);
    timer_pass(frame->timer, "mirrored");
    draw_layer(physical, frame, LAYER_MIRROR, in_water);
    timer_pass(frame->timer, "through");
    draw_layer(physical, frame, LAYER_THROUGH, !in_water || pane);
    if (pane)
        draw_sea_behind_pane(physical, frame);
}

static void draw_sight(struct physical *physical, const struct frame *frame)
{
    struct dpl_gl *gl = frame->gl;
    const struct physical_settings *settings = frame->params;
    draw_layers(physical, frame);
    physical->has_shafts = physical->sight.side < 0 && settings->shafts && settings->caustics;
    if (physical->has_shafts) {
        timer_pass(frame->timer, "shafts");
        shafts_draw(physical, frame);
    }
    timer_pass(frame->timer, "sea");
    if (!physical->sight.pane)
        draw_sea_mesh(physical, frame, frame->view.columns, frame->view.rows);
    gl->BindFramebuffer(GL_FRAMEBUFFER, frame->target->framebuffer);
    gl->Viewport(0, 0, frame->view.columns, frame->view.rows);
    gl->Enable(GL_SCISSOR_TEST);
    if (!physical->sight.pane)
        draw_sea(physical, frame);
    timer_pass(frame->timer, "backdrop");
    draw_backdrop(physical, frame);
    gl->Disable(GL_SCISSOR_TEST);
}

static void draw(void *state, const struct frame *frame)
{
    struct physical *physical = state;
    struct sight sights[SIGHTS_MAX];
    int count = sight_find(frame, sights);
    frame->gl->Disable(GL_SCISSOR_TEST);
    for (int i = 0; i < count; i++) {
        physical->sight = sights[i];
        draw_sight(physical, frame);
    }
    frame->gl->Enable(GL_SCISSOR_TEST);
}

static void finish(void *state, struct dpl_gl *gl)
{
    struct physical *physical = state;
    optics_sky_finish(&physical->sky);
    world_finish(&physical->world);
    texture_finish(gl, &physical->sky_texture.texels);
    waves_finish(&physical->waves, gl);
    rings_finish(&physical->rings, gl);
    shadow_finish(&physical->shadow, gl);
    solids_finish(&physical->solids, gl);
    seabed_finish(&physical->seabed, gl);
    shafts_finish(&physical->shafts, gl);
    for (int i = 0; i < LAYERS; i++)
        layer_finish(gl, physical->layers + i);
    layer_finish(gl, &physical->mesh);
    for (int i = 0; i < 2; i++)
        program_finish(gl, physical->backdrops + i);
    program_finish(gl, &physical->sea_mesh);
    for (int i = 0; i < SEA_KINDS; i++)
        program_finish(gl, physical->seas + i);
}

const struct scene_look look_physical = {
    .name = "physical",
    .section = "look.physical",
    .summary = "sun, sky, water, solids and light shafts in one light, from above or from in the water",
    .params = params,
    .params_size = sizeof(struct physical_settings),
    .state_size = sizeof(struct physical),
    .sand = true,
    .linear = true,
    .margin = 256, /* as far as waves look beside themselves for what they show */
    .prepare = prepare,
    .draw = draw,
    .finish = finish,
};
