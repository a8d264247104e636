/* Water from pictures: heights that something else has made, in one picture or in numbered ones.
 *
 * 1. Between two pictures the heights go over in a straight line.
 * 2. Between pixels they are bicubic (water/grid.h): slopes are continuous, and central differences at the pixels.
 *
 * A pixel is a vertex as in water/surface.h: on a grid of the picture's side, which caustics.mesh has to ask for, what
 * `dapple surface` writes is read back as it was. */
#include "water/frames.h"
#include "water/grid.h"
#include "water/water.h"

#include "base/log.h"

#include <math.h>
#include <stdlib.h>

#define SIDE 512 /* vertices of the surface where caustics.mesh does not say */

struct heightfield {
    char file[DPL_PARAM_TEXT_SIZE];
    double scale, offset;
    bool periodic;
    double rate;
    int first;
    bool loop;
};

static const struct dpl_param params[] = {
    PARAM_TEXT(struct heightfield, file,
               "picture of the heights, .png .exr .pfm, square; with %04d in its name: numbered pictures; set "
               "caustics.mesh to its side for its own vertices"),
    PARAM_FLOAT(struct heightfield, scale, 1, -1000, 1000, "m",
                "height that the value 1 of the red channel stands for"),
    PARAM_FLOAT(struct heightfield, offset, 0, -1000, 1000, "m", "height of the value 0"),
    PARAM_BOOL(struct heightfield, periodic, true, "the picture's edges join; no: it shows both edges of the water"),
    PARAM_FLOAT(struct heightfield, rate, 30, 0.01, 1000, "1/s", "pictures a second"),
    PARAM_INT(struct heightfield, first, 0, 0, 1000000, "", "number of the first picture, at time 0"),
    PARAM_BOOL(struct heightfield, loop, false,
               "the last picture goes over into the first, as always where the scene loops; no: it stays"),
    PARAM_END,
};

/* What the heights are made of, the pictures apart. */
struct blend {
    int frames[2]; /* those around the time */
    double share;  /* of the second */
    double scale, offset;
};

struct state {
    struct frames frames;
    struct height_grid grid; /* now */
    float *heights;          /* of the grid */
    int side;                /* that there is room for */
    bool blended;            /* the heights are those of: */
    struct blend blend;
};

static struct water_shape shape(const struct water_setup *setup)
{
    const struct heightfield *p = setup->params;
    return (struct water_shape){.side = setup->mesh > 0 ? setup->mesh : SIDE, .periodic = p->periodic};
}

static struct blend blend_at(const struct water_setup *setup, int count, double time)
{
    const struct heightfield *p = setup->params;
    bool loops = p->loop || setup->loop > 0;
    double place = fmin(fmax(time * p->rate, 0), count - 1);
    if (loops) {
        double period = count / p->rate;
        if (setup->loop > 0)
            period = setup->loop / fmax(1, round(setup->loop / period));
        place = (time / period - floor(time / period)) * count;
    }
    int frame = (int)fmin(floor(place), count - 1), next = frame + 1 < count ? frame + 1 : loops ? 0 : frame;
    return (struct blend){{frame, next}, place - frame, p->scale, p->offset};
}

static bool make_room(struct state *state, const struct dpl_log *log)
{
    int side = state->frames.side;
    if (state->side == side)
        return true;
    free(state->heights);
    state->heights = base_allocate(log, (size_t)side * (size_t)side, sizeof *state->heights, "heights");
    state->side = state->heights ? side : 0;
    return state->heights;
}

static bool add_frame(struct state *state, int frame, double scale, const struct dpl_log *log)
{
    const float *values = frames_get(&state->frames, frame, log);
    for (size_t i = 0; i < (size_t)state->side * (size_t)state->side && values; i++)
        state->heights[i] += (float)scale * values[i];
    return values;
}

static bool same_blend(const struct blend *a, const struct blend *b)
{
    return a->frames[0] == b->frames[0] && a->frames[1] == b->frames[1] && a->share == b->share &&
           a->scale == b->scale && a->offset == b->offset;
}

static bool make_heights(struct state *state, const struct blend *blend, const struct dpl_log *log)
{
    for (size_t i = 0; i < (size_t)state->side * (size_t)state->side; i++)
        state->heights[i] = (float)blend->offset;
    return add_frame(state, blend->frames[0], blend->scale * (1 - blend->share), log) &&
           (!(blend->share > 0) || add_frame(state, blend->frames[1], blend->scale * blend->share, log));
}

static bool prepare(void *state_, const struct water_setup *setup, double time, const struct dpl_log *outer)
{
    struct base_named_log named = {.name = "heightfield.file", .outer = outer};
    const struct dpl_log *log = base_name_log(&named);
    struct state *state = state_;
    const struct heightfield *p = setup->params;
    bool kept = state->blended && frames_are_open(&state->frames, p->file, p->first);
    state->blended = false;
    if (!frames_open(&state->frames, p->file, p->first, log) || !make_room(state, log))
        return false;
    struct blend blend = blend_at(setup, state->frames.count, time);
    state->grid = (struct height_grid){state->side, p->periodic, setup->size, state->heights};
    state->blended = (kept && same_blend(&blend, &state->blend)) || make_heights(state, &blend, log);
    state->blend = blend;
    return state->blended;
}

static void evaluate(void *state_, const struct water_setup *setup, double time, struct surface *surface)
{
    (void)setup, (void)time; /* those of prepare() */
    const struct state *state = state_;
    grid_fill(&state->grid, surface);
}

static void sample(const void *state_, const struct water_setup *setup, double time, struct water_points *points)
{
    (void)setup, (void)time;
    const struct state *state = state_;
    grid_sample(&state->grid, points);
}

static void finish(void *state_, struct dpl_gl *gl)
{
    (void)gl;
    struct state *state = state_;
    frames_close(&state->frames);
    free(state->heights);
    *state = (struct state){0};
}

const struct water_model water_heightfield = {
    .name = "heightfield",
    .summary = "heights from a picture or numbered pictures on disk, in between smooth",
    .source = "dapple",
    .params = params,
    .params_size = sizeof(struct heightfield),
    .state_size = sizeof(struct state),
    .shape = shape,
    .prepare = prepare,
    .evaluate = evaluate,
    .sample = sample,
    .finish = finish,
};
