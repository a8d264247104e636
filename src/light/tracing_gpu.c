#include "light/tracing_gpu.h"

#include <math.h>

struct tracing_rays tracing_rays_of(const struct light_input *input, const struct optics_sun *sun, int side, int slice,
                                    int color)
{
    struct tracing_rays rays = {
        .input = input,
        .view = tracing_view_of(input, input->surface_gpu->periodic, side, slice),
        .disc = optics_sun_disc(sun),
        .receiver = input->receivers[slice],
        .color = color,
    };
    ray_medium_start(&rays.medium, input->medium, &rays.disc);
    return rays;
}

/* Where the map has what flat water sends from the middle of the tile, texels. */
static void find_offset(const struct tracing_rays *rays, const struct ray_hit *hit, float offset[2])
{
    const struct tracing_view *view = &rays->view;
    const double places[2] = {hit->x, hit->z}, outside = 1e7; /* texels: whatever lies there is not seen */
    for (int k = 0; k < 2; k++) {
        double place = (places[k] - view->corner[k]) * view->texels_a_meter;
        if (view->period > 0)
            place = fmod(place, view->period);
        offset[k] = (float)fmin(fmax(place, -outside), outside);
    }
}

void tracing_rays_bind(struct dpl_gl *gl, const struct tracing_rays *rays, const struct gpu_program *program)
{
    const struct ray_medium *medium = &rays->medium;
    struct ray_point point = {.area = 1,
                              .to_light = {rays->disc.middle[0], rays->disc.middle[1], rays->disc.middle[2]}};
    enum ray_kind kind = ray_kind_of(rays->receiver);
    struct ray flat = ray_start(medium, &point, kind, rays->color);
    struct ray_hit hit = {0};
    bool arrives = flat.weight > 0 && ray_meet(&flat, &point, rays->receiver, &hit);
    double share = medium->flat_up * medium->flat_share[kind][rays->color];
    const float water[4] = {(float)(hit.x / rays->receiver), (float)(hit.z / rays->receiver), (float)hit.way,
                            arrives ? (float)(1 / share) : 0};
    float offset[4] = {0};
    double absorption[3] = {0}, channels[3] = {0};
    int together = tracing_colors_together(medium);
    find_offset(rays, &hit, offset);
    for (int c = rays->color; c < rays->color + together; c++) {
        absorption[c] = kind == RAY_REFRACTED ? medium->absorption[c] : 0;
        channels[c] = 1;
    }
    surface_gpu_bind(gl, rays->input->surface_gpu, program, 0);
    program_float(gl, program, "ior", medium->ior[rays->color]);
    program_float(gl, program, "receiver", rays->receiver);
    program_float(gl, program, "texels_a_meter", rays->view.texels_a_meter);
    program_vec4s(gl, program, "flat_water", 1, water);
    program_vec4s(gl, program, "flat_offset", 1, offset);
    program_vec3(gl, program, "absorption", absorption);
    program_vec3(gl, program, "channels", channels);
    program_vec3(gl, program, "sun", rays->disc.middle);
}

bool tracing_blend_ready(struct dpl_gl *gl, struct tracing_blend *blend)
{
    return program_ready(gl, &blend->program, "light/coverage_fold.glsl", "");
}

void tracing_blend_begin(struct dpl_gl *gl, struct tracing_blend *blend, int side, int margin, bool clear)
{
    int whole = side + 2 * margin;
    texture_resize(gl, &blend->light, gl->info.float_blend ? GL_RGBA32F : GL_RGBA16F, whole, whole, TEXTURE_CLAMP,
                   TEXTURE_NEAREST);
    texture_draw_to(gl, &blend->light);
    gl->ClearColor(0, 0, 0, 0);
    if (clear)
        gl->Clear(GL_COLOR_BUFFER_BIT);
    gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    gl->BindVertexArray(gl->empty_array);
}

void tracing_blend_end(struct dpl_gl *gl)
{
    gl->Disable(GL_BLEND);
}

void tracing_blend_draw(struct dpl_gl *gl, struct tracing_blend *blend, bool periodic, int margin,
                        struct gpu_texture *map, int slice)
{
    int side = map->width;
    texture_draw_to_layer(gl, map, slice);
    program_use(gl, &blend->program);
    texture_bind(gl, &blend->light, 0);
    program_int(gl, &blend->program, "blended", 0);
    program_int(gl, &blend->program, "side", side);
    program_int(gl, &blend->program, "margin", margin);
    program_int(gl, &blend->program, "repeats", periodic ? (margin + side - 1) / side : 0);
    gpu_draw_screen(gl);
}

void tracing_blend_finish(struct dpl_gl *gl, struct tracing_blend *blend)
{
    program_finish(gl, &blend->program);
    texture_finish(gl, &blend->light);
}
