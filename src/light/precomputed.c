/* A loop of caustic maps made beforehand and played: Stam 1996, "Random Caustics: Natural Textures and Wave Theory
 * Revisited" (random_caustics.c), or maps in files, of whatever technique (loop_files.c).
 *
 * It is the cheapest light there is, and knows nothing of the scene's water, sun or receivers: all show the same
 * pattern. Frames by wave theory are made when they are first shown. */
#include "base/log.h"
#include "light/loop.h"
#include "light/random_caustics.h"

#include <stdlib.h>
#include <string.h>

struct precomputed {
    char files[DPL_PARAM_TEXT_SIZE];
    double loop;
    int repeat, frames, side;
    double correlation, height, depth, wavelength;
    int colors;
};

static const struct dpl_param params[] = {
    PARAM_TEXT(struct precomputed, files,
               "folder of numbered maps, or their names, as in loop/%04d.exr; empty = maps by wave theory"),
    PARAM_FLOAT(struct precomputed, loop, 4, 0.01, 3600, "s", "all maps are shown in this time; scene.loop, where set"),
    PARAM_INT(struct precomputed, repeat, 1, 1, 64, "", "how often the maps stand side by side in the tile"),
    PARAM_INT(struct precomputed, frames, 120, 1, 480, "", "wave theory: maps to make; between them light fades over"),
    PARAM_INT(struct precomputed, side, 256, 4, 1024, "texels", "wave theory: side of the maps; best a power of 2"),
    PARAM_FLOAT(struct precomputed, correlation, 0.3, 0.001, 1000, "m",
                "wave theory: length over which the correlation of the waves' heights falls to 1/e"),
    PARAM_FLOAT(struct precomputed, height, 0.04, 0, 10, "m", "wave theory: RMS of the waves' heights"),
    PARAM_FLOAT(struct precomputed, depth, 1, 0, 1000, "m", "wave theory: of the floor"),
    PARAM_FLOAT(struct precomputed, wavelength, 0, 0, 1, "m",
                "wave theory: shortest wavelength of the light, whose diffraction widens lines; 0 = the shortest that "
                "the texels hold"),
    PARAM_INT(struct precomputed, colors, 4, 1, 16, "",
              "wave theory: wavelengths that are averaged, over as wide a range as that of the eye; 1 = a laser"),
    PARAM_END,
};

struct precomputed_state {
    bool ready; /* the loop is that of the following */
    char files[DPL_PARAM_TEXT_SIZE];
    struct random_caustics caustics; /* where there are no files */
    struct loop loop;
    bool *made; /* for each frame */
    struct loop_player player;
};

static double loop_length(const struct light_input *input)
{
    const struct precomputed *p = input->params;
    return input->setup->loop > 0 ? input->setup->loop : p->loop;
}

static bool ready_files(struct precomputed_state *state, const struct light_input *input)
{
    const struct precomputed *p = input->params;
    if (state->ready && !strcmp(p->files, state->files))
        return true;
    state->ready = loop_read(&state->loop, p->files, input->log);
    return state->ready;
}

/* Readies what all frames by wave theory share; the frames themselves are yet to be made. */
static bool ready_caustics(struct precomputed_state *state, const struct light_input *input)
{
    const struct precomputed *p = input->params;
    struct random_caustics_recipe recipe = {
        .side = p->side,
        .frames = p->frames,
        .seed = input->seed,
        .colors = p->colors,
        .tile = input->setup->size / p->repeat,
        .loop = loop_length(input),
        .correlation = p->correlation,
        .height = p->height,
        .depth = p->depth,
        .ior = input->medium->ior,
        .wavelength = p->wavelength,
    };
    if (state->ready && !*state->files && !memcmp(&recipe, &state->caustics.recipe, sizeof recipe))
        return true;
    free(state->made);
    state->made = base_allocate(input->log, (size_t)p->frames, sizeof *state->made, "frames of a loop");
    state->ready = state->made && loop_resize(&state->loop, p->frames, p->side, 1, "precomputed.frames", input->log) &&
                   random_caustics_begin(&state->caustics, &recipe, input->log);
    return state->ready;
}

static void make_frame(struct precomputed_state *state, int frame)
{
    if (*state->files || state->made[frame])
        return;
    random_caustics_light(&state->caustics, frame, state->loop.texels + (size_t)frame * loop_frame_size(&state->loop));
    state->made[frame] = true;
}

static bool trace(void *state_, const struct light_input *input, struct light_map *map)
{
    struct precomputed_state *state = state_;
    const struct precomputed *p = input->params;
    if (!(*p->files ? ready_files(state, input) : ready_caustics(state, input)))
        return false;
    memcpy(state->files, p->files, sizeof state->files);
    struct loop_moment moment = loop_moment_at(&state->loop, input->time / loop_length(input));
    make_frame(state, moment.frame);
    make_frame(state, moment.next);
    double size = input->setup->size;
    for (int slice = 0; slice < map->slices; slice++)
        if (!loop_play(&state->player, &state->loop, &moment, input->windows + slice, size, size / p->repeat, map,
                       slice, input->log))
            return false;
    return true;
}

static void finish(void *state_, struct dpl_gl *gl)
{
    struct precomputed_state *state = state_;
    (void)gl;
    random_caustics_finish(&state->caustics);
    loop_finish(&state->loop);
    loop_player_finish(&state->player);
    free(state->made);
    *state = (struct precomputed_state){0};
}

const struct light_technique light_precomputed = {
    .name = "precomputed",
    .summary = "a loop of maps made beforehand by wave theory from random waves of its own, or read from files",
    .source = "Stam 1996",
    .params = params,
    .params_size = sizeof(struct precomputed),
    .state_size = sizeof(struct precomputed_state),
    .channels = 3,
    .trace = trace,
    .finish = finish,
};
