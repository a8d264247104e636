/* The picture of a blog post on the caustics of GPU Gems: floor, water and light in one fragment shader. Each pixel of
 * the floor looks straight up, refracts at the waves above and samples a lamp in the zenith. It needs no caustic map:
 * what caustics.technique makes is not in the picture. With the water model `fbm` the waves are the post's series,
 * evaluated per pixel; with others the surface's grid. */
#include "render/frame.h"

#include <math.h>

/* [look.fourier] */
struct look {
    double lamp_radius, lamp_softness; /* degrees, share */
    double lamp_brightness, ambient;
};

static const struct dpl_param params[] = {
    PARAM_FLOAT(struct look, lamp_radius, 10, 0.1, 90, "degrees", "the lamp's, seen from the water, round the zenith"),
    PARAM_FLOAT(struct look, lamp_softness, 0.8, 0, 1, "",
                "how far from its edge inwards it fades: 0 = a sharp edge, 1 = to its middle"),
    PARAM_FLOAT(struct look, lamp_brightness, 1.3, 0, 10, "", "light of the lamp on the floor"),
    PARAM_FLOAT(struct look, ambient, 0.35, 0, 4, "", "light from all around on the floor"),
    PARAM_END,
};

struct state {
    struct gpu_program program, series_program;
};

extern const struct water_model water_fbm;

static bool is_series(const struct frame *frame)
{
    return water_models[frame->scene->medium.model] == &water_fbm;
}

static bool prepare(void *state_, const struct frame *frame)
{
    struct state *state = state_;
    return is_series(frame)
               ? program_ready(frame->gl, &state->series_program, "render/fourier.glsl", "#define SERIES\n")
               : program_ready(frame->gl, &state->program, "render/fourier.glsl", "");
}

static void draw(void *state_, const struct frame *frame)
{
    const struct state *state = state_;
    struct dpl_gl *gl = frame->gl;
    const struct look *look = frame->params;
    const struct dpl_scene *scene = frame->scene;
    const struct gpu_program *program = is_series(frame) ? &state->series_program : &state->program;
    double radius = look->lamp_radius * M_PI / 180;
    timer_pass(frame->timer, "picture");
    program_use(gl, program);
    if (is_series(frame)) {
        float constants[WATER_CONSTANTS_MAX][4];
        program_vec4s(gl, program, "series", water_fbm.constants(frame->setup, frame->time, constants), constants[0]);
    } else {
        surface_gpu_bind(gl, frame->above, program, 0);
    }
    texture_bind(gl, frame->sand, 1);
    program_int(gl, program, "sand", 1);
    program_vec3(gl, program, "eye", frame->camera->position);
    program_vec3(gl, program, "ahead", frame->rays.ahead);
    program_vec3(gl, program, "right", frame->rays.right);
    program_vec3(gl, program, "up", frame->rays.up);
    program_vec3(gl, program, "background", scene->render.background);
    program_float(gl, program, "size", scene->settings.size);
    program_float(gl, program, "depth", scene->settings.depth);
    program_float(gl, program, "ior", scene->medium.ior);
    program_float(gl, program, "lamp_inner", radius * (1 - look->lamp_softness));
    program_float(gl, program, "lamp_outer", radius + 1e-4); /* not the same as the inner one */
    program_float(gl, program, "lamp_brightness", look->lamp_brightness);
    program_float(gl, program, "ambient", look->ambient);
    gpu_draw_screen(gl);
}

static void finish(void *state_, struct dpl_gl *gl)
{
    struct state *state = state_;
    program_finish(gl, &state->program);
    program_finish(gl, &state->series_program);
}

const struct scene_look look_fourier = {
    .name = "fourier",
    .section = "look.fourier",
    .summary = "floor, water and light in one fragment shader, without a map (blog on GPU Gems, chapter 2)",
    .params = params,
    .params_size = sizeof(struct look),
    .state_size = sizeof(struct state),
    .sand = true,
    .prepare = prepare,
    .draw = draw,
    .finish = finish,
};
