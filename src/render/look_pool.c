/* The pool of Evan Wallace's "WebGL Water" (2011; the article "Rendering Realtime Caustics in WebGL", 2016, tells of
 * its light): tiled walls, water that mirrors and refracts them ray by ray, a ball, and the sun's light from the
 * caustic map on all of it.
 *
 * 1. The sky, behind everything.
 * 2. The floor, the walls and the ball, as they are seen without water in between (pool_room.glsl, pool_sphere.glsl).
 * 3. The surface, which hides them: for each of its pixels one ray that is thrown back and one that goes through,
 * traced to the ball, the walls or the sky (pool_water.glsl). What all of them ask for, the colour of a place, is
 * pool.glsl.
 *
 * His tiles and his sky are pictures; here both are drawn by a shader. He stores the shadows of the rim and of the ball
 * in the caustic map; here each place has its own. */
#include "light/map_texture.h"
#include "optics/refraction.h"
#include "render/pool_tiles.h"
#include "render/water_mesh.h"

#include <math.h>

#define SPHERE_RINGS 48 /* of triangles, from pole to pole */
#define CELLS_MAX 128   /* of the surface drawn, a side; its slopes are read for each pixel */
#define FLATTEST 1e-3   /* m, of depth */

enum { UNIT_SURFACE, UNIT_MAP, UNIT_TILES };

/* [look.pool] */
struct look {
    double rim;        /* half sides of the pool */
    double sharpening; /* sides */
    double ambient, caustic;
    double reflected_above, reflected_below;
    double tint_above[3], tint_below[3], tint_out[3];
    double wet; /* of tint_below, for what is seen under water without the surface in between */
    double sun_color[3], sun_exponent;
    double sky_zenith[3], sky_horizon[3], ground[3];
    double tile_color[3], tile_contrast;
    int tiles;
    double sphere_color[3];
};

static const struct dpl_param params[] = {
    PARAM_FLOAT(struct look, rim, 1.0 / 6, 0, 2, "", "height of the walls above the water, in half sides of the pool"),
    PARAM_FLOAT(struct look, sharpening, 0.005, 0, 0.1, "",
                "water: how far each of five steps along the normal goes, which peaks the crests; sides of the pool"),
    PARAM_FLOAT(struct look, ambient, 0.5, 0, 4, "", "light from all around, in the middle of the floor"),
    PARAM_FLOAT(struct look, caustic, 0.2, 0, 4, "", "light of the sun, through flat water"),
    PARAM_FLOAT(struct look, reflected_above, 0.25, 0, 1, "", "water: least share of light thrown back, from above"),
    PARAM_FLOAT(struct look, reflected_below, 0.5, 0, 1, "", "water: the same, from below"),
    PARAM_COLOR(struct look, tint_above, 4, "of what is seen in the water from above", 0.25, 1, 1.25),
    PARAM_COLOR(struct look, tint_below, 4, "of what is mirrored from below", 0.4, 0.9, 1),
    PARAM_COLOR(struct look, tint_out, 4, "of what is seen out of the water", 0.8, 1, 1.1),
    PARAM_FLOAT(struct look, wet, 1.2, 0, 4, "", "times tint_below: of what is seen from inside the water"),
    PARAM_COLOR(struct look, sun_color, 100, "of the sun's reflection and of the sun", 10, 8, 6),
    PARAM_FLOAT(struct look, sun_exponent, 5000, 1, 100000, "", "the larger, the smaller is the sun"),
    PARAM_COLOR(struct look, sky_zenith, 4, "sky: overhead", 0.15, 0.38, 0.75),
    PARAM_COLOR(struct look, sky_horizon, 4, "sky: at the horizon", 0.75, 0.86, 0.95),
    PARAM_COLOR(struct look, ground, 4, "below the horizon", 0.23, 0.25, 0.27),
    PARAM_COLOR(struct look, tile_color, 1, "mean colour of the tiles", 0.8, 0.82, 0.84),
    PARAM_FLOAT(struct look, tile_contrast, 1, 0, 4, "", "how much the tiles' brightness varies; 0 = plain"),
    PARAM_INT(struct look, tiles, 16, 1, 256, "", "tiles across the pool"),
    PARAM_COLOR(struct look, sphere_color, 1, "of the ball", 0.5, 0.5, 0.5),
    PARAM_END,
};

struct state {
    struct gpu_program sky, room, sphere, water;
    struct water_mesh mesh;
    struct pool_tiles tiles;
};

static bool prepare(void *state_, const struct frame *frame)
{
    struct state *state = state_;
    struct dpl_gl *gl = frame->gl;
    const struct look *look = frame->params;
    struct pool_tiles_settings settings = {
        .color = {look->tile_color[0], look->tile_color[1], look->tile_color[2]},
        .contrast = look->tile_contrast,
        .count = look->tiles,
        .seed = frame->scene->settings.seed,
    };
    return program_ready(gl, &state->sky, "render/pool_sky.glsl", "") &&
           program_ready(gl, &state->room, "render/pool_room.glsl", "") &&
           program_ready(gl, &state->sphere, "render/pool_sphere.glsl", "") &&
           program_ready(gl, &state->water, "render/pool_water.glsl", "") &&
           water_mesh_ready(&state->mesh, frame, CELLS_MAX) && pool_tiles_update(gl, &state->tiles, &settings);
}

/* Where the pool, its ball and the sun are, in half sides of the pool. */
static void set_place(const struct frame *frame, const struct gpu_program *program)
{
    static const double up[3] = {0, 1, 0};
    struct dpl_gl *gl = frame->gl;
    const struct dpl_scene *scene = frame->scene;
    double half_side = scene->settings.size / 2, sphere[3], to_sun[3], light_way[3];
    for (int c = 0; c < 3; c++)
        sphere[c] = frame->sphere[c] / half_side;
    optics_sun_direction(&scene->sun, to_sun);
    optics_refract(to_sun, up, scene->medium.ior, light_way);
    program_mat4(gl, program, "view_projection", frame->view_projection);
    program_vec3(gl, program, "eye", frame->camera->position);
    program_float(gl, program, "half_side", half_side);
    program_float(gl, program, "depth", fmax(scene->settings.depth, FLATTEST) / half_side);
    program_vec3(gl, program, "sphere", sphere);
    program_float(gl, program, "sphere_radius", scene->sphere.radius / half_side);
    program_vec3(gl, program, "to_sun", to_sun);
    program_vec3(gl, program, "light_way", light_way);
}

static void set_light(const struct look *look, struct dpl_gl *gl, const struct gpu_program *program)
{
    double wet[3];
    for (int c = 0; c < 3; c++)
        wet[c] = look->wet * look->tint_below[c];
    program_float(gl, program, "rim", look->rim);
    program_float(gl, program, "ambient", look->ambient);
    program_float(gl, program, "caustic", look->caustic);
    program_vec3(gl, program, "wet", wet);
    program_vec3(gl, program, "sphere_color", look->sphere_color);
    program_vec3(gl, program, "sun_color", look->sun_color);
    program_float(gl, program, "sun_exponent", look->sun_exponent);
    program_vec3(gl, program, "sky_zenith", look->sky_zenith);
    program_vec3(gl, program, "sky_horizon", look->sky_horizon);
    program_vec3(gl, program, "ground", look->ground);
}

static void use(const struct state *state, const struct frame *frame, const struct gpu_program *program)
{
    struct dpl_gl *gl = frame->gl;
    program_use(gl, program);
    set_place(frame, program);
    set_light(frame->params, gl, program);
    surface_gpu_bind(gl, frame->surface, program, UNIT_SURFACE);
    map_texture_bind(gl, frame->map, frame->windows, frame->scene->settings.size, program, UNIT_MAP);
    texture_bind(gl, &state->tiles.color, UNIT_TILES);
    program_int(gl, program, "tiles", UNIT_TILES);
    gl->BindVertexArray(gl->empty_array);
}

static void draw_water(struct state *state, const struct frame *frame)
{
    static const double middle[3] = {0, 0, 0};
    struct dpl_gl *gl = frame->gl;
    const struct look *look = frame->params;
    const struct gpu_program *program = &state->water;
    use(state, frame, program);
    program_float(gl, program, "sharpening", look->sharpening);
    program_float(gl, program, "ior", frame->scene->medium.ior);
    program_float(gl, program, "reflected_above", look->reflected_above);
    program_float(gl, program, "reflected_below", look->reflected_below);
    program_vec3(gl, program, "tint_above", look->tint_above);
    program_vec3(gl, program, "tint_below", look->tint_below);
    program_vec3(gl, program, "tint_out", look->tint_out);
    water_mesh_draw(&state->mesh, frame, program, UNIT_SURFACE, middle);
}

/* Rays ask for the water at places, so it is drawn as it is there too. */
static void draw(void *state_, const struct frame *moving)
{
    struct state *state = state_;
    struct frame still = *moving, *frame = &still;
    struct dpl_gl *gl = frame->gl;
    still.surface = moving->above;
    timer_pass(frame->timer, "room");
    use(state, frame, &state->sky);
    gl->DrawArrays(GL_TRIANGLES, 0, 6 * 6);
    gl->Enable(GL_DEPTH_TEST);
    use(state, frame, &state->room);
    gl->DrawArrays(GL_TRIANGLES, 0, 5 * 6);
    if (frame->scene->sphere.radius > 0) {
        use(state, frame, &state->sphere);
        program_int(gl, &state->sphere, "rings", SPHERE_RINGS);
        gl->DrawArrays(GL_TRIANGLES, 0, SPHERE_RINGS * 2 * SPHERE_RINGS * 6);
    }
    timer_pass(frame->timer, "water");
    draw_water(state, frame);
    gl->Disable(GL_DEPTH_TEST);
}

static void finish(void *state_, struct dpl_gl *gl)
{
    struct state *state = state_;
    program_finish(gl, &state->sky);
    program_finish(gl, &state->room);
    program_finish(gl, &state->sphere);
    program_finish(gl, &state->water);
    water_mesh_finish(&state->mesh, gl);
    pool_tiles_finish(gl, &state->tiles);
}

const struct scene_look look_pool = {
    .name = "pool",
    .section = "look.pool",
    .summary = "a tiled pool, traced ray by ray as in Wallace's WebGL Water",
    .params = params,
    .params_size = sizeof(struct look),
    .state_size = sizeof(struct state),
    .prepare = prepare,
    .draw = draw,
    .finish = finish,
};
