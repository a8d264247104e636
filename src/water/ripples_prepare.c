/* The water of the model `ripples` in time.
 *
 * Steps are of fixed length, and the surface between two is their mean by time, so that it is the same at any frame
 * rate. To bring the water to a time:
 *
 * 1. Where the scene's numbers have changed, or time has gone back, start again from 0 and come to that time.
 * 2. What others have done since the last frame happens: drops, the ball put elsewhere.
 * 3. Step by step: the ball moves, every 1/60 s; drops of the rain that are due fall; the water moves.
 *
 * A wave is a millionth of itself after its `life`, so water need not be known from the start. Time is cut into lives.
 * In each the water counts that was calm when the life before it began; meanwhile the next one's is begun beside it.
 * So the surface at any time, reached frame by frame or at one leap, is the same, and takes two lives of steps at most.
 *
 * A drop adds the water that it is, as in the demo: those that are thrown in by hand raise the level, for a life or
 * two. Rain and the drops at the start go up and down in turn. */
#include "base/log.h"
#include "base/random.h"
#include "base/vector.h"
#include "water/ripples.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DEMO_GRAVITY 4    /* half sides of the pool / s² */
#define DEMO_RATE 120     /* steps a second */
#define LIFE_MAX 14400    /* steps; with little damping, or on a large grid, waves end before they are spent */
#define SPENT 1e-6        /* of a wave's height */
#define TICKS_MAX 1000000 /* of the ball, which stays where it is after more than four hours */
#define SHALLOWEST 1e-3   /* m, of water that waves go over at √(g depth) */

/* A number of 0 to 1 for each seed, drop and use. */
static double random_unit(const struct water_setup *setup, int64_t drop, int use)
{
    uint64_t z = (uint64_t)setup->seed * 0xd1342543de82ef95u + (uint64_t)drop * 8 + (uint64_t)use + 1;
    return (double)(random_mix(z * 0x9e3779b97f4a7c15u) >> 11) * 0x1p-53;
}

enum { USE_X, USE_Z, USE_RAIN_X, USE_RAIN_Z, USE_RAIN_TIME };

/* The drop falls at least `inside` metres from the walls. */
static struct ripples_event seeded_drop(const struct water_setup *setup, int64_t drop, int use, double inside)
{
    const struct ripples *ripples = setup->params;
    double width = fmax(setup->size - 2 * inside, 0);
    return (struct ripples_event){
        .kind = RIPPLES_DROP,
        .drop = {.x = (random_unit(setup, drop, use) - 0.5) * width,
                 .z = (random_unit(setup, drop, use + 1) - 0.5) * width,
                 .radius = ripples->drop_radius * setup->size,
                 .height = (drop % 2 ? 1 : -1) * ripples->drop_height * setup->size / 2},
    };
}

/* s */
static double rain_time(const struct water_setup *setup, int64_t drop)
{
    const struct ripples *ripples = setup->params;
    return ((double)drop + random_unit(setup, drop, USE_RAIN_TIME)) / ripples->rain;
}

/* The slowest wave's height shrinks by the larger root a step; see ripples_tank.c. */
static int64_t life_of(const struct ripples *ripples)
{
    double d = ripples->damping, middle = (1 + d - d * (1 - cos(M_PI / ripples->side))) / 2;
    double kept = middle * middle < d ? sqrt(d) : middle + sqrt(middle * middle - d);
    return (int64_t)fmin(ceil(log(SPENT) / log(fmin(kept, 1 - 1e-9))), LIFE_MAX);
}

static double rate_of(const struct water_setup *setup)
{
    const struct ripples *ripples = setup->params;
    double spacing = setup->size / (ripples->side - 1);
    if (ripples->speed == RIPPLES_DEMO)
        return DEMO_RATE;
    double speed =
        ripples->speed == RIPPLES_GIVEN ? ripples->wave_speed : sqrt(WATER_GRAVITY * fmax(setup->depth, SHALLOWEST));
    return speed / (spacing * M_SQRT1_2);
}

/* The numbers of the scene that all of the water's past depends on. */
static void read_scene(const struct water_setup *setup, double scene[RIPPLES_NUMBERS])
{
    const struct ripples *r = setup->params;
    const double numbers[RIPPLES_NUMBERS] = {setup->size,    setup->depth,   setup->seed,   r->side,
                                             r->damping,     r->speed,       r->wave_speed, r->drops,
                                             r->drop_radius, r->drop_height, r->rain};
    memcpy(scene, numbers, sizeof numbers);
}

static struct ball scene_ball(const struct water_setup *setup)
{
    const struct water_sphere *sphere = setup->sphere;
    return (struct ball){.center = {sphere->position[0], sphere->position[1], sphere->position[2]},
                         .radius = sphere->radius};
}

static bool same_ball(const struct ball *a, const struct ball *b)
{
    return memcmp(a, b, sizeof *a) == 0;
}

/* Lets it happen, here and, later, on the GPU. */
static void happen(struct ripples_state *state, const struct ripples_event *event)
{
    tank_apply(&state->tank, event);
    if (state->next_started)
        tank_apply(&state->next_tank, event);
    if (state->event_count < RIPPLES_EVENTS_MAX)
        state->events[state->event_count] = *event;
    if (state->event_count <= RIPPLES_EVENTS_MAX)
        state->event_count++;
}

/* Water that drops have fallen into and a ball has been moved in, as it is when that has come to rest. */
static void begin_calm(struct ripples_state *state, struct tank *tank, const struct water_setup *setup)
{
    const struct ripples *ripples = setup->params;
    tank_calm(tank, 0);
    for (int i = 0; i < ripples->drops; i++) {
        struct ripples_event drop = seeded_drop(setup, i, USE_X, 0);
        tank_apply(tank, &drop);
    }
    if (state->steps == 0)
        return;
    struct ripples_event moved = {.kind = RIPPLES_MOVE, .from = state->start, .to = state->ball};
    tank_apply(tank, &moved);
    tank_calm(tank, tank_level(tank));
}

/* Moves the ball to where it is when that step begins. Where its gravity has been switched off it stays where it has
 * come to, at rest, until the water starts again, with the ball where the scene puts it. */
static void move_ball(struct ripples_state *state, const struct water_setup *setup, int64_t step)
{
    int64_t due = (int64_t)fmin(floor((double)step / (state->rate * BALL_TICK) + 1e-6) + 1, TICKS_MAX);
    if (!setup->sphere->gravity)
        memset(state->velocity, 0, sizeof state->velocity);
    for (; state->ticks < due; state->ticks++)
        if (setup->sphere->gravity && state->ball.radius > 0)
            ball_move(&state->ball, &state->tank.pool, state->velocity);
}

/* Starts with calm water at that step, which is 0 or where a life begins. */
static void start(struct ripples_state *state, const struct water_setup *setup, int64_t step)
{
    const struct ripples *ripples = setup->params;
    state->steps = step;
    state->next_change = step + state->life;
    state->next_started = false;
    state->event_count = RIPPLES_EVENTS_MAX + 1;
    state->start = state->ball = state->placed;
    state->ticks = 0;
    memset(state->velocity, 0, sizeof state->velocity);
    if (step > 0)
        move_ball(state, setup, step - 1);
    state->rain = (int64_t)fmax(floor((double)step / state->rate * ripples->rain) - 1, 0);
    while (ripples->rain > 0 && rain_time(setup, state->rain) * state->rate < (double)step)
        state->rain++;
    begin_calm(state, &state->tank, setup);
}

/* Where a life ends, the water that was begun with it takes over. */
static void change_water(struct ripples_state *state, const struct water_setup *setup)
{
    if (state->next_started) {
        struct tank spent = state->tank;
        state->tank = state->next_tank;
        state->next_tank = spent;
        state->event_count = RIPPLES_EVENTS_MAX + 1;
    }
    begin_calm(state, &state->next_tank, setup);
    state->next_started = true;
    state->next_change += state->life;
}

static void make_step(struct ripples_state *state, const struct water_setup *setup)
{
    const struct ripples *ripples = setup->params;
    struct ripples_event moved = {.kind = RIPPLES_MOVE, .from = state->ball};
    if (state->steps == state->next_change)
        change_water(state, setup);
    move_ball(state, setup, state->steps);
    moved.to = state->ball;
    if (!same_ball(&moved.from, &moved.to))
        happen(state, &moved);
    while (ripples->rain > 0 && rain_time(setup, state->rain) * state->rate < (double)state->steps + 1) {
        struct ripples_event drop = seeded_drop(setup, state->rain++, USE_RAIN_X, ripples->drop_radius * setup->size);
        happen(state, &drop);
    }
    happen(state, &(struct ripples_event){.kind = RIPPLES_STEP});
    state->steps++;
}

static void make_steps(struct ripples_state *state, const struct water_setup *setup, int64_t wanted)
{
    while (state->steps < wanted)
        make_step(state, setup);
}

/* What others have done since the last frame. */
static void interact(struct ripples_state *state, const struct water_setup *setup, const struct ball *placed)
{
    if (!same_ball(placed, &state->placed)) {
        happen(state, &(struct ripples_event){.kind = RIPPLES_MOVE, .from = state->ball, .to = *placed});
        state->ball = state->placed = *placed;
        memset(state->velocity, 0, sizeof state->velocity);
    }
    for (int i = 0; i < setup->drop_count; i++)
        happen(state, &(struct ripples_event){.kind = RIPPLES_DROP, .drop = setup->drops[i]});
}

/* Makes room for the scene's water. */
static bool resize(struct ripples_state *state, const struct water_setup *setup, const struct dpl_log *log)
{
    const struct ripples *ripples = setup->params;
    const int side = ripples->side;
    if (!state->shown || state->tank.side != side || state->next_tank.side != side) {
        free(state->shown);
        state->shown = NULL;
        if (!tank_resize(&state->tank, side, log) || !tank_resize(&state->next_tank, side, log))
            return false;
        state->shown = base_allocate(log, (size_t)side * (size_t)side, sizeof(float), "ripples");
        if (!state->shown)
            return false;
    }
    double gravity = ripples->speed == RIPPLES_DEMO ? DEMO_GRAVITY * setup->size / 2 : WATER_GRAVITY;
    for (int i = 0; i < 2; i++) {
        struct tank *tank = i ? &state->next_tank : &state->tank;
        tank->spacing = setup->size / (side - 1);
        tank->damping = ripples->damping;
        tank->pool = (struct ball_pool){setup->size / 2, setup->depth, gravity};
    }
    state->rate = rate_of(setup);
    state->life = life_of(ripples);
    return true;
}

VECTOR_CLONES static void show(size_t count, float lag, const float *restrict heights, const float *restrict speeds,
                               float *restrict shown)
{
    for (size_t i = 0; i < count; i++)
        shown[i] = heights[i] - lag * speeds[i];
}

bool ripples_prepare(void *memory, const struct water_setup *setup, double time, const struct dpl_log *log)
{
    const double longest = 9e15, same = 1e-6; /* steps, of a time; between times that are the same */
    struct ripples_state *state = memory;
    struct ball placed = scene_ball(setup);
    double scene[RIPPLES_NUMBERS], steps = time * rate_of(setup);
    int64_t wanted = (int64_t)fmin(fmax(ceil(steps - same), 0), longest);
    read_scene(setup, scene);
    bool changed = !state->shown || memcmp(scene, state->scene, sizeof scene) != 0;
    if (changed && !resize(state, setup, log))
        return false;
    int64_t calm = wanted / state->life > 0 ? (wanted / state->life - 1) * state->life : 0;
    memcpy(state->scene, scene, sizeof scene);
    state->event_count = 0;
    if (changed || wanted < state->steps || calm > state->steps) {
        state->placed = placed;
        start(state, setup, calm);
        make_steps(state, setup, wanted);
    }
    interact(state, setup, &placed);
    make_steps(state, setup, wanted);
    state->lag = fmin(fmax((double)wanted - steps, 0), 1);
    size_t count = (size_t)state->tank.side * (size_t)state->tank.side;
    show(count, (float)state->lag, state->tank.heights, state->tank.speeds, state->shown);
    state->frame++;
    return true;
}
