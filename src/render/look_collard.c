/* Collard & Mundi 2022, sections 3.5 (ground) and 3.6 (water): the ground first, the water blended over it. */
#include "light/map_texture.h"
#include "render/water_mesh.h"

/* [look.collard] */
struct look {
    /* floor */
    double sand_share;     /* of the sand's colour that shows without caustics */
    double attenuation[3]; /* a / (b g² + c g + 1), at most 1, g the depth */
    double brightest;      /* in units of the sand's colour */
    double floor_tint;     /* of the water's colour, added */
    /* water */
    double water_color[3], lamp_color[3], lamp_position[3];
    double ambient;
    double shininess;
    double threshold; /* mean of the highlight above which it is white */
};

static const struct dpl_param params[] = {
    PARAM_FLOAT(struct look, sand_share, 0.9, 0, 2, "", "floor: share of the sand's colour without caustics"),
    PARAM_FLOATS(struct look, attenuation, 3, 0, 100, "",
                 "floor: a b c of the loss with depth g, min(a / (b g² + c g + 1), 1)", 2, 0.1, 0.1),
    PARAM_FLOAT(struct look, brightest, 1.4, 0, 10, "", "floor: most light, in units of the sand's colour"),
    PARAM_FLOAT(struct look, floor_tint, 0.25, 0, 1, "", "floor: share of the water's colour added"),
    PARAM_COLOR(struct look, water_color, 1, "colour of the water", 0, 112.5 / 255, 1),
    PARAM_COLOR(struct look, lamp_color, 4, "water: colour of the lamp", 0.9922, 0.9843, 0.8275),
    PARAM_FLOATS(struct look, lamp_position, 3, -1000, 1000, "m", "water: place of the lamp", 2.5, 5, -10),
    PARAM_FLOAT(struct look, ambient, 0.1, 0, 1, "", "water: share of the lamp's light from all around"),
    PARAM_FLOAT(struct look, shininess, 256, 1, 4096, "", "water: exponent of the highlights (Phong)"),
    PARAM_FLOAT(struct look, threshold, 0.3, 0, 2, "", "water: mean above which a highlight becomes white"),
    PARAM_END,
};

struct state {
    struct gpu_program ground, water;
    struct water_mesh mesh;
};

static void draw_ground(struct state *state, const struct frame *frame)
{
    struct dpl_gl *gl = frame->gl;
    const struct dpl_scene *scene = frame->scene;
    const struct look *look = frame->params;
    const struct gpu_program *program = &state->ground;
    double depth = scene->settings.depth;
    double loss = look->attenuation[0] / (look->attenuation[1] * depth * depth + look->attenuation[2] * depth + 1);
    program_use(gl, program);
    program_mat4(gl, program, "view_projection", frame->view_projection);
    program_float(gl, program, "size", scene->settings.size);
    program_float(gl, program, "depth", depth);
    program_float(gl, program, "sand_share", look->sand_share);
    program_float(gl, program, "attenuation", loss < 1 ? loss : 1);
    program_float(gl, program, "brightest", look->brightest);
    program_float(gl, program, "floor_tint", look->floor_tint);
    program_vec3(gl, program, "water_color", look->water_color);
    texture_bind(gl, frame->sand, 0);
    map_texture_bind(gl, frame->map, frame->windows, scene->settings.size, program, 1);
    program_int(gl, program, "sand", 0);
    gl->BindVertexArray(gl->empty_array);
    gl->DrawArrays(GL_TRIANGLES, 0, 6);
}

static void draw_water(struct state *state, const struct frame *frame)
{
    struct dpl_gl *gl = frame->gl;
    const struct look *look = frame->params;
    const struct gpu_program *program = &state->water;
    program_use(gl, program);
    program_vec3(gl, program, "eye", frame->camera->position);
    program_vec3(gl, program, "lamp_position", look->lamp_position);
    program_vec3(gl, program, "lamp_color", look->lamp_color);
    program_vec3(gl, program, "water_color", look->water_color);
    program_float(gl, program, "ambient", look->ambient);
    program_float(gl, program, "shininess", look->shininess);
    program_float(gl, program, "threshold", look->threshold);
    gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
    water_mesh_draw(&state->mesh, frame, program, 0, (double[]){0, 0, 0});
    gl->Disable(GL_BLEND);
}

static bool prepare(void *state_, const struct frame *frame)
{
    struct state *state = state_;
    struct dpl_gl *gl = frame->gl;
    return program_ready(gl, &state->ground, "render/collard_ground.glsl", "") &&
           program_ready(gl, &state->water, "render/collard_water.glsl", "") &&
           water_mesh_ready(&state->mesh, frame, 0);
}

static void draw(void *state_, const struct frame *frame)
{
    struct state *state = state_;
    struct dpl_gl *gl = frame->gl;
    gl->Enable(GL_DEPTH_TEST);
    timer_pass(frame->timer, "ground");
    draw_ground(state, frame);
    timer_pass(frame->timer, "water");
    draw_water(state, frame);
    gl->Disable(GL_DEPTH_TEST);
}

static void finish(void *state_, struct dpl_gl *gl)
{
    struct state *state = state_;
    program_finish(gl, &state->ground);
    program_finish(gl, &state->water);
    water_mesh_finish(&state->mesh, gl);
}

const struct scene_look look_collard = {
    .name = "collard",
    .section = "look.collard",
    .summary = "shading as in Collard & Mundi 2022",
    .params = params,
    .params_size = sizeof(struct look),
    .state_size = sizeof(struct state),
    .sand = true,
    .prepare = prepare,
    .draw = draw,
    .finish = finish,
};
