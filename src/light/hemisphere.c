/* Backward Monte Carlo ray tracing over the hemisphere, which Sánchez-Crespo's article starts from.
 *
 *   1. a texel of the receiver sends candidate rays in all directions, or in those of a cone, towards the water
 *   2. each meets the surface, by Newton's method; what leaves a bounded surface, or meets its back, is dropped
 *   3. the inverse of Snell's law bends it into the air; what is reflected totally is dropped
 *   4. only if it ends in the lamp, the sun with its halo, does it count: with the cosine at the receiver, Fresnel's
 *      share, what the water lets through, and n², by which refraction gathers directions
 *
 * The sum is the irradiance but for chance, as long as the cone holds all ways to the lamp. Most candidates are of no
 * use; on the CPU the log says how many are. Candidates follow an additive sequence (Roberts 2018), with a start of its
 * own for each texel (Cranley & Patterson 1976). */
#include "light/tracing_gpu.h"

#include "base/log.h"
#include "optics/refraction.h"

#include <math.h>
#include <string.h>

#define MEETINGS 4        /* places of the surface looked at, at most */
#define NEAR 0.02         /* texels from where a ray meets the surface: near enough */
#define NARROWEST 1e-3    /* degrees, of a lamp: a point is never met */
#define LEVELEST 1e-3     /* vertical part of a direction that still meets the water */
#define FACING_LEAST 0.25 /* of a ray and the surface: a step stays short where they graze each other */

struct hemisphere {
    int candidates;
    double cone, lamp; /* degrees */
};

static const struct dpl_param params[] = {
    PARAM_INT(struct hemisphere, candidates, 256, 1, 1000000, "", "rays for each texel"),
    PARAM_FLOAT(struct hemisphere, cone, 6, 0.1, 90, "degrees",
                "half angle of the cone of candidates around the way of light through flat water; steep waves need a "
                "wider one; 90 = the hemisphere"),
    PARAM_FLOAT(struct hemisphere, lamp, 0.843, 0, 30, "degrees",
                "radius of the sun with its halo, of even brightness; by default ten times the area of the sun alone; "
                "0 = sun.angular_radius"),
    PARAM_END,
};

struct state {
    struct gpu_program program;
    struct tracing_blend blend;
    struct hemisphere told; /* for which the log knows the share of useful candidates */
};

/* What is the same for all rays to one receiver. */
struct task {
    const struct light_input *input;
    struct tracing_surface surface;
    struct tracing_view view;
    double near_square; /* m² */
    double receiver;    /* m */
    enum ray_kind kind;
    struct optics_sun sun; /* the lamp as one, and as a disc */
    struct optics_disc lamp;
    double lamp_cosine;
    struct ray_medium rays;
    double axis[3], across[3], along[3]; /* of the cone */
    double cap;                          /* 1 less the cosine of the cone's half angle: solid angle in units of 2π */
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The cone around the way back of light from flat water to the receiver. */
static void aim(struct task *task)
{
    static const double up[3] = {0, 1, 0};
    const struct hemisphere *p = task->input->params;
    double down[3], sign = task->kind == RAY_REFRACTED ? 1 : -1;
    if (task->kind == RAY_REFRACTED)
        optics_refract(task->lamp.middle, up, task->rays.ior[1], down);
    else
        optics_reflect(task->lamp.middle, up, down);
    if (p->cone == 90)
        memcpy(down, (const double[3]){0, -sign, 0}, sizeof down);
    double level = hypot(down[0], down[2]), x = level > 0 ? down[0] / level : 1, z = level > 0 ? down[2] / level : 0;
    for (int i = 0; i < 3; i++)
        task->axis[i] = -down[i];
    memcpy(task->across, (const double[3]){-z, 0, x}, sizeof task->across);
    memcpy(task->along, (const double[3]){down[1] * x, -level, down[1] * z}, sizeof task->along);
    task->cap = 1 - cos(p->cone * M_PI / 180);
}

static struct task task_of(const struct light_input *input, bool periodic, int side, int slice)
{
    const struct hemisphere *p = input->params;
    struct task task = {
        .input = input,
        .view = tracing_view_of(input, periodic, side, slice),
        .receiver = input->receivers[slice],
        .kind = ray_kind_of(input->receivers[slice]),
        .sun = *input->sun,
    };
    task.sun.angular_radius = fmax(p->lamp > 0 ? p->lamp : input->sun->angular_radius, NARROWEST);
    task.lamp = optics_sun_disc(&task.sun);
    task.lamp_cosine = cos(task.sun.angular_radius * M_PI / 180);
    task.near_square = pow(NEAR / task.view.texels_a_meter, 2);
    ray_medium_start(&task.rays, input->medium, &task.lamp);
    aim(&task);
    return task;
}

/* Step 1: equal areas of the unit square stand for equal solid angles of the cone. */
static void choose_direction(const struct task *task, double u, double v, double out[3])
{
    double place[2], wide = sqrt(task->cap * (2 - u * task->cap));
    optics_disc_spread(u, v, place);
    for (int i = 0; i < 3; i++)
        out[i] = (1 - u * task->cap) * task->axis[i] + wide * (place[0] * task->across[i] + place[1] * task->along[i]);
}

/* Step 2: a ray from `from`, x and z on the receiver. */
static bool meet(const struct task *task, const double from[2], const double direction[3], struct ray_point *point)
{
    const double per_height = 1 / direction[1], run[2] = {direction[0] * per_height, direction[2] * per_height};
    double place[2] = {from[0] - run[0] * task->receiver, from[1] - run[1] * task->receiver}, facing = 1;
    for (int look = 0; look < MEETINGS; look++) {
        if (!tracing_surface_at(&task->surface, place[0], place[1], point))
            return false;
        double rise = point->height - task->receiver;
        double off[2] = {from[0] + run[0] * rise - point->x, from[1] + run[1] * rise - point->z};
        facing = 1 - run[0] * point->slope_x - run[1] * point->slope_z;
        if (off[0] * off[0] + off[1] * off[1] < task->near_square)
            break;
        double higher = off[0] * point->slope_x + off[1] * point->slope_z;
        double reach = higher / (facing > FACING_LEAST ? facing : FACING_LEAST);
        for (int k = 0; k < 2; k++)
            place[k] += off[k] + run[k] * reach;
    }
    return facing > 0;
}

/* Steps 3 and 4: the light of the colours from `color` that share a refractive index; false where there is none. */
static bool find_light(const struct task *task, const struct ray_point *point, const double direction[3], int color,
                       double light[3])
{
    double length = sqrt(1 + point->slope_x * point->slope_x + point->slope_z * point->slope_z), air[3];
    double normal[3] = {-point->slope_x / length, 1 / length, -point->slope_z / length};
    double under[3] = {-normal[0], -normal[1], -normal[2]}, back[3] = {-direction[0], -direction[1], -direction[2]};
    double ior = task->rays.ior[color], cosine = dot(direction, normal);
    bool refracted = task->kind == RAY_REFRACTED;
    if (refracted && 1 / (ior * ior) - 1 + cosine * cosine <= 0)
        return false;
    if (refracted)
        optics_refract(back, under, 1 / ior, air);
    else
        optics_reflect(back, normal, air);
    double towards = dot(air, task->lamp.middle);
    if (towards < task->lamp_cosine || air[1] <= 0)
        return false;
    double reflectance = optics_fresnel_reflectance(fmin(dot(air, normal), 1), ior);
    double share = refracted ? (1 - reflectance) * ior * ior : reflectance;
    double way = fabs(point->height - task->receiver) / fabs(direction[1]);
    for (int c = color; c < color + tracing_colors_together(&task->rays); c++) {
        double longer = way - fabs(task->receiver) * task->rays.flat_way[RAY_REFRACTED][c];
        double left = refracted ? optics_transmittance(task->rays.absorption[c], longer) : 1;
        light[c] += fabs(direction[1]) * share * towards * left;
    }
    return true;
}

/* All candidates of a texel; returns how many are of use. */
static int gather(const struct task *task, int i, int j, double light[3])
{
    const struct hemisphere *p = task->input->params;
    const struct tracing_view *view = &task->view;
    const double from[2] = {view->corner[0] + (i + 0.5) / view->texels_a_meter,
                            view->corner[1] + (j + 0.5) / view->texels_a_meter};
    double numbers[4];
    int useful = 0, together = tracing_colors_together(&task->rays);
    tracing_random((const uint32_t[4]){(uint32_t)i, (uint32_t)j, (uint32_t)task->input->seed, 1}, numbers);
    uint32_t u = (uint32_t)(numbers[0] * 0x1p32), v = (uint32_t)(numbers[1] * 0x1p32);
    for (int k = 0; k < p->candidates; k++, u += 3242174889u, v += 2447445414u) {
        double direction[3];
        struct ray_point point;
        choose_direction(task, (u >> 8) * 0x1p-24, (v >> 8) * 0x1p-24, direction);
        bool towards_water = direction[1] * (task->kind == RAY_REFRACTED ? 1 : -1) > LEVELEST, used = false;
        if (!towards_water || !meet(task, from, direction, &point))
            continue;
        for (int c = 0; c < 3; c += together)
            used = find_light(task, &point, direction, c, light) || used;
        useful += used;
    }
    return useful;
}

/* From a texel's sum to units of flat water. */
static void find_scale(const struct task *task, double scale[3])
{
    const struct hemisphere *p = task->input->params;
    double flat[3], cone = 2 * M_PI * task->cap, lamp = M_PI * task->lamp.radius * task->lamp.radius;
    ray_flat_mean(&task->rays, &task->lamp, task->receiver, flat);
    for (int c = 0; c < 3; c++) {
        double light = flat[c] * task->rays.flat_share[task->kind][c] * task->rays.flat_up * lamp;
        scale[c] = light > 0 ? cone / p->candidates / light : 0;
    }
}

/* Returns how many candidates are of use. */
static uint64_t trace_slice(const struct task *task, struct light_map *map, int slice)
{
    uint64_t useful = 0;
    double scale[3];
    float *texels = light_map_slice(map, slice);
    find_scale(task, scale);
#pragma omp parallel for schedule(static) reduction(+ : useful)
    for (int j = 0; j < map->side; j++) {
        for (int i = 0; i < map->side; i++) {
            double light[3] = {0};
            useful += (uint64_t)gather(task, i, j, light);
            for (int c = 0; c < 3; c++)
                texels[((size_t)j * (size_t)map->side + (size_t)i) * 3 + (size_t)c] = (float)(light[c] * scale[c]);
        }
    }
    return useful;
}

static bool same_candidates(const struct hemisphere *a, const struct hemisphere *b)
{
    return a->candidates == b->candidates && a->cone == b->cone && a->lamp == b->lamp;
}

static bool trace(void *state_, const struct light_input *input, struct light_map *map)
{
    struct state *state = state_;
    const struct hemisphere *p = input->params;
    double useful = 0;
    for (int slice = 0; slice < map->slices; slice++) {
        struct task task = task_of(input, input->surface->periodic, map->side, slice);
        task.surface = tracing_surface_of(input->surface);
        useful += (double)trace_slice(&task, map, slice);
    }
    if (!same_candidates(&state->told, p))
        base_inform(input->log, "hemisphere: %.3g %% of the candidate rays end in the lamp",
                    100 * useful / ((double)map->side * map->side * map->slices * p->candidates));
    state->told = *p;
    return true;
}

static void draw_color(struct state *state, struct dpl_gl *gl, const struct task *task, const struct tracing_rays *rays)
{
    const struct gpu_program *program = &state->program;
    const struct hemisphere *p = task->input->params;
    const double corner[3] = {task->view.corner[0], task->view.corner[1], 0};
    double scale[3];
    find_scale(task, scale);
    tracing_blend_begin(gl, &state->blend, task->view.side, 0, rays->color == 0);
    program_use(gl, program);
    tracing_rays_bind(gl, rays, program);
    program_vec3(gl, program, "corner", corner);
    program_vec3(gl, program, "axis", task->axis);
    program_vec3(gl, program, "across", task->across);
    program_vec3(gl, program, "along", task->along);
    program_vec3(gl, program, "scale", scale);
    program_float(gl, program, "cap", task->cap);
    program_float(gl, program, "lamp_square", 2 * (1 - task->lamp_cosine));
    program_float(gl, program, "near_square", task->near_square);
    program_int(gl, program, "candidates", p->candidates);
    program_int(gl, program, "seed", task->input->seed);
    gpu_draw_screen(gl);
    tracing_blend_end(gl);
}

static bool draw(void *state_, struct dpl_gl *gl, const struct light_input *input, struct gpu_texture *map)
{
    struct state *state = state_;
    bool periodic = input->surface_gpu->periodic;
    if (!program_ready(gl, &state->program, "light/hemisphere.glsl", "") || !tracing_blend_ready(gl, &state->blend))
        return false;
    for (int slice = 0; slice < input->slices; slice++) {
        const struct task task = task_of(input, periodic, map->width, slice);
        struct tracing_rays rays = tracing_rays_of(input, &task.sun, map->width, slice, 0);
        for (; rays.color < 3; rays.color += tracing_colors_together(&rays.medium))
            draw_color(state, gl, &task, &rays);
        tracing_blend_draw(gl, &state->blend, periodic, 0, map, slice);
    }
    return true;
}

static void finish(void *state_, struct dpl_gl *gl)
{
    struct state *state = state_;
    if (gl) {
        program_finish(gl, &state->program);
        tracing_blend_finish(gl, &state->blend);
    }
    *state = (struct state){0};
}

const struct light_technique light_hemisphere = {
    .name = "hemisphere",
    .summary = "rays from each texel back through the water, of which those count that end in the sun; grainy",
    .source = "backward Monte Carlo; Sánchez-Crespo 2003",
    .params = params,
    .params_size = sizeof(struct hemisphere),
    .state_size = sizeof(struct state),
    .channels = 3,
    .physical = true,
    .energy = 0.1, /* of steep water, some of whose ways leave the cone */
    .reflects = true,
    .trace = trace,
    .draw = draw,
    .finish = finish,
};
