/* How high solids stand in the sun's way, for each place where its light passes the rest surface; and how low in the
 * way of what the water throws up there. */
#include "render/physical.h"

#include <math.h>

/* The square of places that light to any part of the world passes, by its way above the rest surface and below it:
 * vectors along it, up or down; NULL: there is none below. */
static void frame_square(const struct world *world, const double above[3], const double *below, double square[4])
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int corner = 0; corner < 8; corner++) {
        double y = corner & 1 ? world->high[1] : below ? world->low[1] : fmax(world->low[1], 0);
        const double *way = y > 0 || !below ? above : below;
        for (int a = 0; a < 2; a++) {
            double edge = corner & (2 << a) ? world->high[2 * a] : world->low[2 * a];
            double place = edge - y / way[1] * way[2 * a];
            low[a] = fmin(low[a], place);
            high[a] = fmax(high[a], place);
        }
    }
    for (int a = 0; a < 2; a++) {
        double margin = 0.02 * (high[a] - low[a]) + 0.05;
        square[a] = low[a] - margin;
        square[2 + a] = high[a] - low[a] + 2 * margin;
    }
}

/* Upwards, along what flat water throws back of the sun. */
static void find_thrown(const struct physical *physical, double way[3])
{
    const double *to_sun = physical->light.to_sun;
    way[0] = -to_sun[0];
    way[1] = to_sun[1];
    way[2] = -to_sun[2];
}

bool shadow_prepare(struct shadow *shadow, const struct frame *frame, const struct physical *physical)
{
    const struct world *world = &physical->world;
    bool casts = world->vertex_count > 0;
    shadow->span[1] = 0;
    if (casts) {
        double thrown[3];
        find_thrown(physical, thrown);
        frame_square(world, physical->light.to_sun, physical->light.sun_way, shadow->square);
        frame_square(world, thrown, NULL, shadow->thrown_square);
        /* where nothing casts the map has its lowest height, which nothing that is lit lies below */
        double lowest = fmin(world->low[1], -frame->scene->settings.depth) - 2;
        shadow->span[0] = lowest;
        shadow->span[1] = world->high[1] - lowest + 0.01;
    }
    int most = frame->gl->info.texture_max, side = casts ? physical->quality.shadow_side : 1;
    side = side < most ? side : most;
    /* without caustics in it, what the water throws up lights little */
    int thrown_side = world->high[1] <= 0 ? 1 : frame->reflected ? side : (side + 3) / 4;
    return program_ready(frame->gl, &shadow->cast, "render/shadow_cast.glsl", "") &&
           layer_resize(frame->gl, &shadow->map, 0, side, side) &&
           layer_resize(frame->gl, &shadow->thrown, 0, thrown_side, thrown_side);
}

/* Draws what stands above the rest surface, or below it, along its light's way; `thrown`: up from the water. */
static void cast(const struct shadow *shadow, const struct frame *frame, const struct physical *physical,
                 const double way[3], bool above, bool thrown)
{
    struct dpl_gl *gl = frame->gl;
    program_vec2(gl, &shadow->cast, "slant", way[0] / way[1], way[2] / way[1]);
    program_float(gl, &shadow->cast, "above", above ? 1 : -1);
    program_int(gl, &shadow->cast, "thrown", thrown);
    solids_cast(&physical->solids, gl, &physical->world, &shadow->cast, above);
}

void shadow_draw(struct shadow *shadow, const struct frame *frame, const struct physical *physical)
{
    struct dpl_gl *gl = frame->gl;
    double thrown[3];
    find_thrown(physical, thrown);
    layer_begin(gl, &shadow->map);
    if (shadow->span[1] > 0) {
        gl->Enable(GL_DEPTH_TEST);
        program_use(gl, &shadow->cast);
        physical_bind_cast(physical, frame, &shadow->cast);
        cast(shadow, frame, physical, physical->light.sun_way, false, false);
        cast(shadow, frame, physical, physical->light.to_sun, true, false);
    }
    layer_begin(gl, &shadow->thrown);
    if (shadow->span[1] > 0 && physical->world.high[1] > 0)
        cast(shadow, frame, physical, thrown, true, true);
    gl->Disable(GL_DEPTH_TEST);
}

void shadow_finish(struct shadow *shadow, struct dpl_gl *gl)
{
    program_finish(gl, &shadow->cast);
    layer_finish(gl, &shadow->map);
    layer_finish(gl, &shadow->thrown);
}
