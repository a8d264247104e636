/* How high solids stand in the sun's way, for each place where its light passes the rest surface. */
#include "render/physical.h"

#include <math.h>

/* The square of places that light to any part of the world passes, and the heights of what casts. */
static void frame_world(struct shadow *shadow, const struct physical *physical, double depth)
{
    const struct world *world = &physical->world;
    const double *to_sun = physical->light.to_sun, *sun_way = physical->light.sun_way;
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    shadow->span[1] = 0;
    if (world->vertex_count == 0)
        return;
    for (int corner = 0; corner < 8; corner++) {
        double y = corner & 1 ? world->high[1] : world->low[1];
        double slant = y / (y > 0 ? to_sun[1] : sun_way[1]);
        for (int a = 0; a < 2; a++) {
            double edge = corner & (2 << a) ? world->high[2 * a] : world->low[2 * a];
            double place = edge - slant * (y > 0 ? to_sun : sun_way)[2 * a];
            low[a] = fmin(low[a], place);
            high[a] = fmax(high[a], place);
        }
    }
    for (int a = 0; a < 2; a++) {
        double margin = 0.02 * (high[a] - low[a]) + 0.05;
        shadow->square[a] = low[a] - margin;
        shadow->square[2 + a] = high[a] - low[a] + 2 * margin;
    }
    /* where nothing casts the map has its lowest height, which nothing that is lit lies below */
    double lowest = fmin(world->low[1], -depth) - 2;
    shadow->span[0] = lowest;
    shadow->span[1] = world->high[1] - lowest + 0.01;
}

bool shadow_prepare(struct shadow *shadow, const struct frame *frame, const struct physical *physical)
{
    frame_world(shadow, physical, frame->scene->settings.depth);
    int side = shadow->span[1] > 0 ? physical->quality.shadow_side : 1;
    return program_ready(frame->gl, &shadow->cast, "render/shadow_cast.glsl", "") &&
           layer_resize(frame->gl, &shadow->map, 0, side, side);
}

/* What is above the rest surface, then what is below it, each along its light's slant. */
void shadow_draw(struct shadow *shadow, const struct frame *frame, const struct physical *physical)
{
    struct dpl_gl *gl = frame->gl;
    layer_begin(gl, &shadow->map);
    if (shadow->span[1] == 0)
        return;
    gl->Enable(GL_DEPTH_TEST);
    program_use(gl, &shadow->cast);
    physical_bind_cast(physical, frame, &shadow->cast);
    for (int above = 0; above < 2; above++) {
        const double *way = above ? physical->light.to_sun : physical->light.sun_way;
        program_vec2(gl, &shadow->cast, "slant", way[0] / way[1], way[2] / way[1]);
        program_float(gl, &shadow->cast, "above", above ? 1 : -1);
        solids_cast(&physical->solids, gl, &physical->world, above);
    }
    gl->Disable(GL_DEPTH_TEST);
}

void shadow_finish(struct shadow *shadow, struct dpl_gl *gl)
{
    program_finish(gl, &shadow->cast);
    layer_finish(gl, &shadow->map);
}
