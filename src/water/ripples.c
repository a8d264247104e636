/* Evan Wallace's pool (2011, "Rendering Realtime Caustics in WebGL" and its demo): waves on a square grid between
 * walls, drops that fall in, and a ball that makes room for itself. ripples_tank.c has the water, ripples_ball.c the
 * ball, ripples_prepare.c what happens in time.
 *
 * In Wallace's units the pool is 2 wide: one is half of scene.size. His texels are our vertices: his walls, which stand
 * half a texel outside, stand half a cell outside the tile. His normals come from differences to one side; ours are
 * central, those of grid.c. */
#include "water/ripples.h"
#include "water/grid.h"

#include <stdlib.h>
#include <string.h>

static const char *speed_name(int i)
{
    static const char *const names[] = {"demo", "depth", "given", NULL};
    return names[i];
}

static const char *device_name(int i)
{
    static const char *const names[] = {"cpu", "gpu", NULL};
    return names[i];
}

static const struct dpl_param params[] = {
    PARAM_INT(struct ripples, side, 256, 8, 2048, "", "vertices of the water's grid a side"),
    PARAM_FLOAT(struct ripples, damping, 0.995, 0.9, 1, "",
                "share of its speed that the water keeps a step; with 1, waves end after 14400 to 28800 steps"),
    PARAM_CHOICE(struct ripples, speed, RIPPLES_DEMO, speed_name,
                 "how fast waves go: demo = a fixed 120 steps a second, depth = √(g depth), given = wave_speed"),
    PARAM_FLOAT(struct ripples, wave_speed, 1, 0.001, 100, "m/s", "of waves, where speed = given"),
    PARAM_INT(struct ripples, drops, 20, 0, 1000, "", "drops at the start, up and down in turn"),
    PARAM_FLOAT(struct ripples, drop_radius, 0.03, 0.001, 0.5, "sides", "of these and of rain, in sides of the tile"),
    PARAM_FLOAT(struct ripples, drop_height, 0.01, 0, 1, "half sides", "of these and of rain, in half sides"),
    PARAM_FLOAT(struct ripples, rain, 0, 0, 1000, "1/s", "drops that fall in a second, up and down in turn"),
    PARAM_CHOICE(struct ripples, device, RIPPLES_CPU, device_name,
                 "what moves the water that is shown on a GPU; the CPU moves it too, for whoever asks about points"),
    PARAM_END,
};

static struct water_shape shape(const struct water_setup *setup)
{
    return (struct water_shape){.side = ((const struct ripples *)setup->params)->side};
}

static struct height_grid shown_grid(const struct ripples_state *state, const struct water_setup *setup)
{
    return (struct height_grid){state->tank.side, false, setup->size, state->shown};
}

static void evaluate(void *state, const struct water_setup *setup, double time, struct surface *surface)
{
    (void)time; /* that of prepare() */
    struct height_grid grid = shown_grid(state, setup);
    grid_fill(&grid, surface);
}

static void sample(const void *state, const struct water_setup *setup, double time, struct water_points *points)
{
    (void)time;
    struct height_grid grid = shown_grid(state, setup);
    grid_sample(&grid, points);
}

static void sphere(const void *memory, const struct water_setup *setup, double center[3])
{
    (void)setup;
    const struct ripples_state *state = memory;
    memcpy(center, state->ball.center, sizeof state->ball.center);
}

static void finish(void *memory, struct dpl_gl *gl)
{
    struct ripples_state *state = memory;
    tank_finish(&state->tank);
    tank_finish(&state->next_tank);
    free(state->shown);
    ripples_gpu_finish(&state->gpu, gl);
    *state = (struct ripples_state){0};
}

const struct water_model water_ripples = {
    .name = "ripples",
    .summary = "a pool between walls: drops, a ball in the water; the demo's 256 × 256 grid; does not loop",
    .source = "Wallace 2011",
    .params = params,
    .params_size = sizeof(struct ripples),
    .state_size = sizeof(struct ripples_state),
    .disturbed = true,
    .shape = shape,
    .prepare = ripples_prepare,
    .evaluate = evaluate,
    .sample = sample,
    .sphere = sphere,
    .draw = ripples_draw,
    .finish = finish,
};
