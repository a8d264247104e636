/* Collard & Mundi 2022, "Real-Time Water Caustics", section 3.3.
 *
 * Every texel of the floor looks up at a square of the water above it, at (steps + 1)² places. Each place's normal is
 * bent a little by the direction of sight, and the closer it then is to straight up, where the sun stands, the more of
 * a picture of the sun it adds. Tuned by eye: it has no physical scale, and nothing is refracted by Snell's law.
 *
 * For the sample at offset o (in widths of the map) with the water's normal n, D = depth + depth_bias, S =
 * sun_exponent:
 *   1. direction to the water   a = normalize(o.x, 1/D, ±o.z)
 *   2. weight on the normal     τ = a · n
 *   3. refracted direction      r = normalize(n.x, (1 - τ³²) n.y, n.z)
 *   4. place in the sun map     m = max(½ (r · up)^max(S/D, S), 0)
 *   5. sum                     += R(m) · max(1/D, 1) · base_intensity · (1 - |o|)^falloff
 *   6. the map is              min(sum^(D + 1), 1)
 *
 * Steps 4 and 5 depend on (r · up)² = B² / (n.x² + n.z² + B²), B = (1 - τ³²) n.y, alone: they are one table. Below the
 * dark edge of the sun map the table is black, which leaves a narrow range of cosines that all its entries serve. */
#include "light/multi_sample.h"

#include "base/log.h"

#include <math.h>
#include <string.h>

static const struct dpl_param params[] = {
    PARAM_INT(struct multi_sample, steps, 3, 1, MULTI_SAMPLE_STEPS_MAX, "",
              "samples a side of the square, less one; 1 = a single sample straight above"),
    PARAM_FLOAT(struct multi_sample, sun_exponent, 256, 1, 4096, "", "S: how closely the light gathers round the sun"),
    PARAM_FLOAT(struct multi_sample, base_intensity, 0.6, 0, 5, "", "brightness of the sun map"),
    PARAM_FLOAT(struct multi_sample, half_width, 0.5, 0, 0.5, "map widths", "half the side of the sampled square"),
    PARAM_FLOAT(struct multi_sample, falloff, 4, 0, 16, "", "power of the loss with a sample's distance"),
    PARAM_BOOL(struct multi_sample, faithful, true,
               "true: the paper's program, whose z offset and z normal have opposite signs; false: equal signs"),
    PARAM_TEXT(struct multi_sample, sun_map, "picture of the sun, square; its diagonal is read; empty = a soft disc"),
    PARAM_END,
};

/* Steps 1 and 5: directions and weights of the samples. */
static void plan_rays(struct multi_sample_plan *plan, const struct multi_sample *p, double depth)
{
    plan->lines = p->steps == 1 ? 1 : p->steps + 1;
    for (int k = 0; k < plan->lines; k++)
        plan->offsets[k] = p->steps == 1 ? 0.0f : (float)(p->half_width * (2.0 * k / p->steps - 1));
    for (int l = 0; l < plan->lines; l++) {
        for (int k = 0; k < plan->lines; k++) {
            double x = plan->offsets[k], z = p->faithful ? -plan->offsets[l] : plan->offsets[l];
            double distance = hypot(x, z), length = sqrt(x * x + 1 / (depth * depth) + z * z);
            plan->rays[l * plan->lines + k] =
                (struct multi_sample_ray){{(float)(x / length), (float)(1 / depth / length), (float)(z / length)},
                                          (float)pow(fmax(1 - distance, 0), p->falloff)};
        }
    }
}

/* Steps 4 and 5 as a table over the squared cosine. */
static void plan_table(struct multi_sample_plan *plan, const struct multi_sample *p, double depth,
                       const struct sun_map *sun)
{
    double exponent = fmax(p->sun_exponent / depth, p->sun_exponent) / 2; /* of the squared cosine */
    double start = fmax(sun_map_start(sun), 1e-3);
    plan->table_start = (float)fmin(pow(2 * start, 1 / exponent), 1 - 1e-5); /* leaves the table some width */
    for (int i = 0; i < MULTI_SAMPLE_TABLE; i++) {
        double square = plan->table_start + (1.0 - plan->table_start) * i / (MULTI_SAMPLE_TABLE - 1);
        float m = (float)(0.5 * pow(square, exponent));
        plan->table[i] = (float)(sun_map_at(sun, m) * fmax(1 / depth, 1) * p->base_intensity);
    }
    plan->table[0] = (float)(sun_map_at(sun, 0) * fmax(1 / depth, 1) * p->base_intensity);
}

bool multi_sample_prepare(struct multi_sample_state *state, const struct light_input *input, int slice)
{
    const struct multi_sample *p = input->params;
    double depth =
        fmax(-input->receivers[slice] + input->settings->depth_bias, 1e-3); /* m; the formulas divide by it */
    if (state->planned && depth == state->depth && !memcmp(p, &state->params, sizeof *p))
        return true;
    if (*p->sun_map == '\0')
        sun_map_disc(&state->sun);
    else if (!sun_map_read(&state->sun, p->sun_map, input->log))
        return false;
    plan_rays(&state->plan, p, depth);
    plan_table(&state->plan, p, depth, &state->sun);
    state->plan.normal_keep = p->steps == 1 ? 0.0f : 1.0f;
    state->plan.power = (float)(depth + 1);
    for (int i = 0; i < MULTI_SAMPLE_TABLE + 2; i++)
        state->plan.powers[i] = (float)fmin(pow((double)i / MULTI_SAMPLE_TABLE, depth + 1), 1);
    state->params = *p;
    state->depth = depth;
    state->planned = true;
    return true;
}

static bool build_programs(struct multi_sample_state *state, struct dpl_gl *gl)
{
    return program_ready(gl, &state->normal_program, "light/normals.glsl", "") &&
           program_ready(gl, &state->map_program, "light/multi_sample.glsl", "");
}

/* The normals seen from above, at the map's resolution. */
static void draw_normals(struct multi_sample_state *state, struct dpl_gl *gl, const struct light_input *input, int side)
{
    texture_resize(gl, &state->normals, GL_RGBA16F, side, side, TEXTURE_CLAMP, TEXTURE_LINEAR);
    texture_draw_to(gl, &state->normals);
    program_use(gl, &state->normal_program);
    surface_gpu_bind(gl, input->surface_gpu, &state->normal_program, 0);
    gpu_draw_screen(gl);
}

static void draw_slice(struct multi_sample_state *state, struct dpl_gl *gl, struct gpu_texture *map, int slice)
{
    const struct multi_sample_plan *plan = &state->plan;
    texture_resize(gl, &state->table, GL_R32F, MULTI_SAMPLE_TABLE, 1, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_upload(gl, &state->table, plan->table);
    texture_draw_to_layer(gl, map, slice);
    program_use(gl, &state->map_program);
    texture_bind(gl, &state->normals, 0);
    texture_bind(gl, &state->table, 1);
    program_int(gl, &state->map_program, "normals", 0);
    program_int(gl, &state->map_program, "table", 1);
    program_int(gl, &state->map_program, "lines", plan->lines);
    program_float(gl, &state->map_program, "first_offset", plan->offsets[0]);
    program_float(gl, &state->map_program, "offset_step", plan->lines > 1 ? plan->offsets[1] - plan->offsets[0] : 0);
    program_vec4s(gl, &state->map_program, "rays", plan->lines * plan->lines, plan->rays[0].direction);
    program_float(gl, &state->map_program, "normal_keep", plan->normal_keep);
    program_float(gl, &state->map_program, "power", plan->power);
    program_float(gl, &state->map_program, "table_start", plan->table_start);
    gpu_draw_screen(gl);
}

static bool draw(void *state_, struct dpl_gl *gl, const struct light_input *input, struct gpu_texture *map)
{
    struct multi_sample_state *state = state_;
    if (!build_programs(state, gl))
        return false;
    draw_normals(state, gl, input, map->width);
    for (int slice = 0; slice < input->slices; slice++) {
        if (!multi_sample_prepare(state, input, slice))
            return false;
        draw_slice(state, gl, map, slice);
    }
    return true;
}

static void finish(void *state_, struct dpl_gl *gl)
{
    struct multi_sample_state *state = state_;
    if (gl) {
        program_finish(gl, &state->normal_program);
        program_finish(gl, &state->map_program);
        texture_finish(gl, &state->normals);
        texture_finish(gl, &state->table);
    }
    multi_sample_free_buffers(state);
    *state = (struct multi_sample_state){0};
}

const struct light_technique light_multi_sample = {
    .name = "multi-sample",
    .summary = "many refracted looks up at the water from each texel, by a sun map; tuned by eye, no physical scale",
    .source = "Collard & Mundi 2022, section 3.3",
    .params = params,
    .params_size = sizeof(struct multi_sample),
    .state_size = sizeof(struct multi_sample_state),
    .channels = 1,
    .vertical = true,
    .trace = multi_sample_trace,
    .draw = draw,
    .finish = finish,
};
