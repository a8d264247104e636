/* The picture of Sánchez-Crespo, "Inexpensive Underwater Caustics Using Cg", in his three passes:
 *
 *   1. the ocean's floor, a textured square;
 *   2. the caustics on a mesh as fine as that of the waves, added to it;
 *   3. the waves, with the sky in a planar environment map and Fresnel's equations.
 *
 * Water lets 77 to 80 % of the light through a metre, on its way down and on its way to the eye. */
#include "light/map_texture.h"
#include "render/water_mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SKY_SIDE 512 /* texels */
#define TILES_MAX 4
#define CELLS_MAX 192   /* a side of each tile's mesh, that of the waves where it has no more */
#define FLOOR_REACH 101 /* tiles */

/* [look.sanchez-crespo] */
struct look {
    double transmittance; /* of a metre of water */
    double water_color[3];
    double ambient, caustics;
    double zenith[3], horizon[3], clouds;
    int tiles;
};

static const struct dpl_param params[] = {
    PARAM_FLOAT(struct look, transmittance, 0.785, 0, 1, "", "share of the light that a metre of water lets through"),
    PARAM_COLOR(struct look, water_color, 1, "colour of deep water", 0.02, 0.2, 0.3),
    PARAM_FLOAT(struct look, ambient, 0.55, 0, 4, "", "brightness of the floor without caustics"),
    PARAM_FLOAT(struct look, caustics, 0.7, 0, 10, "", "brightness of the caustics that are added to it"),
    PARAM_COLOR(struct look, zenith, 4, "colour of the sky straight above", 0.25, 0.5, 0.85),
    PARAM_COLOR(struct look, horizon, 4, "colour of the sky at the horizon", 0.75, 0.85, 0.92),
    PARAM_FLOAT(struct look, clouds, 0.7, 0, 1, "", "how white the clouds are"),
    PARAM_INT(struct look, tiles, 0, 0, TILES_MAX, "",
              "of periodic water: tiles that are drawn on every side of the middle one"),
    PARAM_END,
};

struct state {
    struct gpu_program sky_program, floor, added, waves;
    struct gpu_texture sky;
    struct look drawn; /* that the sky is of */
    int seed;          /* likewise */
    struct water_mesh mesh;
};

static bool update_sky(struct state *state, const struct frame *frame)
{
    struct dpl_gl *gl = frame->gl;
    const struct look *look = frame->params;
    int seed = frame->scene->settings.seed;
    bool same = state->sky.name && seed == state->seed && state->sky_program.generation == gl->generation &&
                !memcmp(&state->drawn, look, sizeof *look);
    if (same)
        return true;
    if (!program_ready(gl, &state->sky_program, "render/sanchez_crespo_sky.glsl", ""))
        return false;
    texture_resize(gl, &state->sky, GL_RGBA8, SKY_SIDE, SKY_SIDE, TEXTURE_CLAMP, TEXTURE_MIPMAP);
    texture_draw_to(gl, &state->sky);
    program_use(gl, &state->sky_program);
    program_vec3(gl, &state->sky_program, "zenith", look->zenith);
    program_vec3(gl, &state->sky_program, "horizon", look->horizon);
    program_float(gl, &state->sky_program, "clouds", look->clouds);
    program_int(gl, &state->sky_program, "seed", seed);
    gpu_draw_screen(gl);
    texture_make_mipmaps(gl, &state->sky);
    state->drawn = *look;
    state->seed = seed;
    return true;
}

/* What all passes share. */
static void begin_pass(const struct frame *frame, const struct gpu_program *program)
{
    struct dpl_gl *gl = frame->gl;
    const struct look *look = frame->params;
    program_use(gl, program);
    program_mat4(gl, program, "view_projection", frame->view_projection);
    program_vec3(gl, program, "eye", frame->camera->position);
    program_vec3(gl, program, "water_color", look->water_color);
    program_float(gl, program, "transmittance", look->transmittance);
}

static void begin_floor(const struct frame *frame, const struct gpu_program *program)
{
    struct dpl_gl *gl = frame->gl;
    const struct look *look = frame->params;
    begin_pass(frame, program);
    texture_bind(gl, frame->sand, 0);
    map_texture_bind(gl, frame->map, frame->windows, frame->scene->settings.size, program, 1);
    program_int(gl, program, "sand", 0);
    program_float(gl, program, "size", frame->scene->settings.size);
    program_float(gl, program, "depth", frame->scene->settings.depth);
    program_float(gl, program, "ambient", look->ambient);
    program_float(gl, program, "caustics", look->caustics);
}

/* The tiles' places, from the one that the eye is over outwards, so that near waves are drawn before far ones. */
static int tile_order(const struct frame *frame, double places[][3])
{
    int tiles = frame->surface->periodic ? ((const struct look *)frame->params)->tiles : 0, count = 0;
    const double *eye = frame->camera->position, size = frame->surface->size;
    for (int ring = 0; ring <= 2 * tiles; ring++) {
        for (int k = 0; k < (2 * tiles + 1) * (2 * tiles + 1); k++) {
            int i = k % (2 * tiles + 1) - tiles, j = k / (2 * tiles + 1) - tiles;
            int from_x = (int)fmin(fmax(round(eye[0] / size), -tiles), tiles);
            int from_z = (int)fmin(fmax(round(eye[2] / size), -tiles), tiles);
            int away = abs(i - from_x) > abs(j - from_z) ? abs(i - from_x) : abs(j - from_z);
            if (away == ring)
                memcpy(places[count++], (double[]){i * size, 0, j * size}, sizeof *places);
        }
    }
    return count;
}

/* `count` of tiles; where there are several, the floor goes on into the distance. */
static void draw_floor(const struct state *state, const struct frame *frame, int count)
{
    struct dpl_gl *gl = frame->gl;
    timer_pass(frame->timer, "floor");
    begin_floor(frame, &state->floor);
    program_float(gl, &state->floor, "reach", count > 1 ? FLOOR_REACH : 1);
    program_vec3(gl, &state->floor, "tile", (double[]){0, 0, 0});
    gl->BindVertexArray(gl->empty_array);
    gl->DrawArrays(GL_TRIANGLES, 0, 6);
}

static void draw_caustics(const struct state *state, const struct frame *frame, double (*places)[3], int count)
{
    struct dpl_gl *gl = frame->gl;
    timer_pass(frame->timer, "caustics");
    begin_floor(frame, &state->added);
    program_int(gl, &state->added, "cells", state->mesh.cells);
    gl->Disable(GL_DEPTH_TEST); /* both passes lie in one plane, and there is nothing else yet */
    gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    for (int k = 0; k < count; k++)
        water_mesh_draw(&state->mesh, frame, &state->added, 2, places[k]);
    gl->Disable(GL_BLEND);
    gl->Enable(GL_DEPTH_TEST);
}

static void draw_waves(const struct state *state, const struct frame *frame, double (*places)[3], int count)
{
    struct dpl_gl *gl = frame->gl;
    timer_pass(frame->timer, "waves");
    begin_pass(frame, &state->waves);
    texture_bind(gl, &state->sky, 0);
    program_int(gl, &state->waves, "sky", 0);
    program_float(gl, &state->waves, "ior", frame->scene->medium.ior);
    gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
    for (int k = 0; k < count; k++)
        water_mesh_draw(&state->mesh, frame, &state->waves, 1, places[k]);
    gl->Disable(GL_BLEND);
}

static bool prepare(void *state_, const struct frame *frame)
{
    struct state *state = state_;
    struct dpl_gl *gl = frame->gl;
    return update_sky(state, frame) && program_ready(gl, &state->floor, "render/sanchez_crespo_floor.glsl", "") &&
           program_ready(gl, &state->added, "render/sanchez_crespo_floor.glsl", "#define ADDED\n") &&
           program_ready(gl, &state->waves, "render/sanchez_crespo_waves.glsl", "") &&
           water_mesh_ready(&state->mesh, frame, CELLS_MAX);
}

static void draw(void *state_, const struct frame *frame)
{
    struct state *state = state_;
    double places[(2 * TILES_MAX + 1) * (2 * TILES_MAX + 1)][3];
    int count = tile_order(frame, places);
    frame->gl->Enable(GL_DEPTH_TEST);
    draw_floor(state, frame, count);
    draw_caustics(state, frame, places, count);
    draw_waves(state, frame, places, count);
    frame->gl->Disable(GL_DEPTH_TEST);
}

static void finish(void *state_, struct dpl_gl *gl)
{
    struct state *state = state_;
    program_finish(gl, &state->sky_program);
    program_finish(gl, &state->floor);
    program_finish(gl, &state->added);
    program_finish(gl, &state->waves);
    texture_finish(gl, &state->sky);
    water_mesh_finish(&state->mesh, gl);
}

const struct scene_look look_sanchez_crespo = {
    .name = "sanchez-crespo",
    .section = "look.sanchez-crespo",
    .summary = "floor, added caustics, waves that mirror the sky (Sánchez-Crespo, GPU Gems)",
    .params = params,
    .params_size = sizeof(struct look),
    .state_size = sizeof(struct state),
    .sand = true,
    .prepare = prepare,
    .draw = draw,
    .finish = finish,
};
