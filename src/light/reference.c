/* The ground truth: a photon tracer, refined pass by pass. See reference/photons.h. */
#include "base/file.h"
#include "light/light.h"
#include "reference/photons.h"

#include <math.h>
#include <string.h>

_Static_assert(LIGHT_SLICES_MAX <= PHOTONS_RECEIVERS_MAX, "a receiver for each slice");

struct reference {
    int photons;
    double noise;
    char file[DPL_PARAM_TEXT_SIZE];
};

static const struct dpl_param params[] = {
    PARAM_INT(struct reference, photons, 400, 1, 1000000, "",
              "photons to send for each texel, about; more is never less exact"),
    PARAM_FLOAT(struct reference, noise, 0, 0, 100, "%", "enough once the noise is at most this; 0 = send all photons"),
    PARAM_TEXT(struct reference, file, "where photons are kept, to go on from in the next run; empty = nowhere"),
    PARAM_END,
};

struct reference_state {
    struct photons photons;
    struct reference params; /* that the count is for */
    bool saved;              /* as it now is */
};

/* Readies the count: as it is where nothing changed, from the file where there is one, or from nothing. */
static bool resume(struct reference_state *state, const struct photons_task *task, const struct reference *p,
                   const struct dpl_log *log)
{
    bool same = state->photons.fingerprint == photons_fingerprint(task) && state->photons.sums &&
                p->photons >= state->params.photons && p->noise == state->params.noise &&
                !strcmp(p->file, state->params.file);
    state->params = *p;
    if (same)
        return true;
    state->saved = false;
    if (photons_begin(&state->photons, task, log)) {
        if (!*p->file || !file_exists(p->file))
            return true;
        state->saved = photons_load(&state->photons, p->file, log);
        if (state->saved)
            return true;
    }
    photons_finish(&state->photons);
    return false;
}

/* The share of the work that is done, 1 when there is no more to do. */
static double share_done(const struct photons *photons, const struct reference *p)
{
    double sent = (double)photons->passes * photons_per_texel(photons);
    double share = fmin(sent / p->photons, 1);
    if (p->noise == 0 || share == 1 || photons->passes == 0)
        return share;
    double noise = photons_noise(photons) * 100;
    return noise <= p->noise ? 1 : fmax(share, pow(p->noise / noise, 2)); /* falls like 1/√photons */
}

static bool save(struct reference_state *state, const struct dpl_log *log)
{
    if (!state->saved && *state->params.file)
        state->saved = photons_save(&state->photons, state->params.file, log);
    return state->saved || !*state->params.file;
}

/* Passes between savings: so many that writing takes little of the time. */
static uint64_t passes_per_save(const struct photons *photons)
{
    double texels = (double)photons->side * photons->side, per_pass = photons_per_texel(photons) * texels;
    return (uint64_t)fmax(fmax(0x1p26, 256 * texels) / per_pass, 1);
}

static bool trace(void *state_, const struct light_input *input, struct light_map *map)
{
    struct reference_state *state = state_;
    struct photons *photons = &state->photons;
    const struct reference *p = input->params;
    struct photons_task task = {
        .model = input->model,
        .setup = input->setup,
        .time = input->time,
        .sun = input->sun,
        .medium = input->medium,
        .receivers = input->receivers,
        .receiver_count = input->slices,
        .windows = input->windows,
        .side = map->side,
    };
    if (!resume(state, &task, p, input->log))
        return false;
    double done = share_done(photons, p);
    for (bool enough = done == 1; !enough;) {
        photons_pass(photons, &task);
        state->saved = false;
        done = share_done(photons, p);
        bool stopped = input->progress.step && !input->progress.step(input->progress.user, done);
        enough = done == 1 || stopped;
        if (!enough && photons->passes % passes_per_save(photons) == 0 && !save(state, input->log))
            return false;
    }
    if (!save(state, input->log))
        return false;
    for (int slice = 0; slice < map->slices; slice++)
        photons_read(photons, slice, light_map_slice(map, slice));
    map->noise = photons_noise(photons);
    return true;
}

static void finish(void *state_, struct dpl_gl *gl)
{
    struct reference_state *state = state_;
    (void)gl;
    photons_finish(&state->photons);
    *state = (struct reference_state){0};
}

const struct light_technique light_reference = {
    .name = "reference",
    .summary = "the ground truth: photons through the exact surface, from the whole sun, refined pass by pass",
    .source = "Arvo 1986; Jensen 1996",
    .params = params,
    .params_size = sizeof(struct reference),
    .state_size = sizeof(struct reference_state),
    .channels = 3,
    .physical = true,
    .reflects = true,
    .refines = true,
    .trace = trace,
    .finish = finish,
};
