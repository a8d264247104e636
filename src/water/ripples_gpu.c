/* The water of the model `ripples` on the GPU, as Wallace's demo has it: a texture of heights and speeds, and a pass
 * over it for everything that happens. Passes repeat what happened on the CPU since the last frame. Where that was too
 * much, or the last frame was not drawn here, the CPU's water is copied. */
#include "water/ripples.h"

#include "base/log.h"

#include <stdlib.h>

static void set_vec4(struct dpl_gl *gl, const struct gpu_program *program, const char *name, double x, double y,
                     double z, double w)
{
    const float values[4] = {(float)x, (float)y, (float)z, (float)w};
    program_vec4s(gl, program, name, 1, values);
}

static void set_ball(struct dpl_gl *gl, const struct gpu_program *program, const char *name, const struct ball *ball)
{
    set_vec4(gl, program, name, ball->center[0], ball->center[1], ball->center[2], ball->radius);
}

static void draw_event(struct dpl_gl *gl, struct ripples_gpu *gpu, const struct ripples_event *event)
{
    const struct gpu_program *program = &gpu->event;
    struct gpu_texture before = gpu->water[0];
    gpu->water[0] = gpu->water[1];
    gpu->water[1] = before;
    texture_draw_to(gl, gpu->water);
    texture_bind(gl, gpu->water + 1, 0);
    program_int(gl, program, "kind", (int)event->kind);
    if (event->kind == RIPPLES_DROP)
        set_vec4(gl, program, "drop", event->drop.x, event->drop.z, event->drop.radius, event->drop.height);
    if (event->kind == RIPPLES_MOVE) {
        set_ball(gl, program, "from", &event->from);
        set_ball(gl, program, "to", &event->to);
    }
    gpu_draw_screen(gl);
}

static bool repeat_events(struct dpl_gl *gl, struct ripples_state *state)
{
    struct ripples_gpu *gpu = &state->gpu;
    if (!program_ready(gl, &gpu->event, "water/ripples_event.glsl", ""))
        return false;
    program_use(gl, &gpu->event);
    program_int(gl, &gpu->event, "water", 0);
    program_float(gl, &gpu->event, "damping", state->tank.damping);
    program_float(gl, &gpu->event, "spacing", state->tank.spacing);
    program_float(gl, &gpu->event, "half_side", state->tank.pool.half);
    for (int i = 0; i < state->event_count; i++)
        draw_event(gl, gpu, state->events + i);
    return true;
}

static bool copy_water(struct dpl_gl *gl, struct ripples_state *state)
{
    struct ripples_gpu *gpu = &state->gpu;
    const int side = state->tank.side;
    const size_t count = (size_t)side * (size_t)side;
    if (gpu->upload_side != side) {
        free(gpu->upload);
        gpu->upload = base_allocate(gl->log, count * 2, sizeof *gpu->upload, "ripples");
        gpu->upload_side = gpu->upload ? side : 0;
    }
    if (!gpu->upload)
        return false;
    for (size_t i = 0; i < count; i++) {
        gpu->upload[2 * i] = state->tank.heights[i];
        gpu->upload[2 * i + 1] = state->tank.speeds[i];
    }
    for (int i = 0; i < 2; i++)
        texture_resize(gl, gpu->water + i, GL_RG32F, side, side, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_upload(gl, gpu->water, gpu->upload);
    return true;
}

/* Brings the GPU's water to the frame that has been prepared. */
static bool follow(struct dpl_gl *gl, struct ripples_state *state)
{
    struct ripples_gpu *gpu = &state->gpu;
    bool next = gpu->frame > 0 && gpu->frame == state->frame - 1 && state->event_count <= RIPPLES_EVENTS_MAX;
    bool ok = gpu->frame == state->frame || (next ? repeat_events(gl, state) : copy_water(gl, state));
    gpu->frame = ok ? state->frame : 0;
    return ok;
}

bool ripples_draw(void *memory, struct dpl_gl *gl, const struct water_setup *setup, double time,
                  struct gpu_texture *texels, struct gpu_texture *shifts)
{
    (void)time, (void)shifts; /* that of prepare(); the surface is not choppy */
    const struct ripples *ripples = setup->params;
    struct ripples_state *state = memory;
    struct ripples_gpu *gpu = &state->gpu;
    const int side = state->tank.side;
    bool on_gpu = ripples->device == RIPPLES_GPU;
    if (!program_ready(gl, &gpu->surface, "water/ripples_surface.glsl", "") || (on_gpu && !follow(gl, state)))
        return false;
    if (!on_gpu) {
        texture_resize(gl, &gpu->heights, GL_R32F, side, side, TEXTURE_CLAMP, TEXTURE_NEAREST);
        texture_upload(gl, &gpu->heights, state->shown);
    }
    texture_resize(gl, texels, GL_RGBA32F, side, side, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_draw_to(gl, texels);
    program_use(gl, &gpu->surface);
    texture_bind(gl, on_gpu ? gpu->water : &gpu->heights, 0);
    program_int(gl, &gpu->surface, "water", 0);
    program_float(gl, &gpu->surface, "lag", on_gpu ? state->lag : 0);
    program_float(gl, &gpu->surface, "spacing", state->tank.spacing);
    gpu_draw_screen(gl);
    return true;
}

void ripples_gpu_finish(struct ripples_gpu *gpu, struct dpl_gl *gl)
{
    free(gpu->upload);
    gpu->upload = NULL;
    if (!gl)
        return;
    program_finish(gl, &gpu->event);
    program_finish(gl, &gpu->surface);
    texture_finish(gl, gpu->water);
    texture_finish(gl, gpu->water + 1);
    texture_finish(gl, &gpu->heights);
}
