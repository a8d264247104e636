/* The GPU's half of beams.c: the vertices' rays in a texture, then all triangles in one call, added up by blending into
 * a target with a margin, as what is drawn cannot wrap round. */
#include "light/beams.h"

/* Texels of a triangle's image, and four cells of flat water; a wider one is drawn smaller, with the same light: it is
 * too dim to be seen. */
#define WIDEST 64

static void draw_color(struct beams_gpu *gpu, struct dpl_gl *gl, const struct tracing_rays *rays, int widest,
                       int margin)
{
    const struct beams *p = rays->input->params;
    const struct surface_gpu *surface = rays->input->surface_gpu;
    int width = surface->texels.width, height = surface->texels.height, bounded = surface->periodic ? 0 : 1;
    texture_resize(gl, &gpu->ends, GL_RGBA32F, width, height, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_draw_to(gl, &gpu->ends);
    program_use(gl, &gpu->rays_program);
    tracing_rays_bind(gl, rays, &gpu->rays_program);
    gpu_draw_screen(gl);
    tracing_blend_begin(gl, &gpu->blend, rays->view.side, margin, rays->color == 0);
    program_use(gl, &gpu->program);
    tracing_rays_bind(gl, rays, &gpu->program);
    texture_bind(gl, &gpu->ends, 1);
    program_int(gl, &gpu->program, "ends", 1);
    program_int(gl, &gpu->program, "side", rays->view.side);
    program_int(gl, &gpu->program, "margin", margin);
    program_float(gl, &gpu->program, "widest", widest);
    program_float(gl, &gpu->program, "most", p->most);
    gl->DrawArrays(GL_TRIANGLES, 0, 6 * (width - bounded) * (height - bounded));
    tracing_blend_end(gl);
}

bool beams_gpu_draw(struct beams_gpu *gpu, struct dpl_gl *gl, const struct light_input *input, struct gpu_texture *map)
{
    int columns = input->surface_gpu->texels.width;
    if (!program_ready(gl, &gpu->rays_program, "light/beams_rays.glsl", "") ||
        !program_ready(gl, &gpu->program, "light/beams.glsl", "") || !tracing_blend_ready(gl, &gpu->blend))
        return false;
    for (int slice = 0; slice < input->slices; slice++) {
        int widest = WIDEST + (int)(4 * input->setup->size / input->windows[slice].side * map->width / columns);
        int margin = widest / 2 + 2;
        struct tracing_rays rays = tracing_rays_of(input, input->sun, map->width, slice, 0);
        for (; rays.color < 3; rays.color += tracing_colors_together(&rays.medium))
            draw_color(gpu, gl, &rays, widest, margin);
        tracing_blend_draw(gl, &gpu->blend, input->surface_gpu->periodic, margin, map, slice);
    }
    return true;
}

void beams_gpu_finish(struct beams_gpu *gpu, struct dpl_gl *gl)
{
    program_finish(gl, &gpu->rays_program);
    program_finish(gl, &gpu->program);
    texture_finish(gl, &gpu->ends);
    tracing_blend_finish(gl, &gpu->blend);
}
