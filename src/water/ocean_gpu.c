/* `ocean` on the GPU. The CPU turns the waves on, in double precision; the spectrum goes up, a quarter of the grid; one
 * pass after the other transforms rows and columns (ocean_fft.glsl), and two passes make the surface of the result
 * (ocean_surface.glsl). */
#include "water/ocean.h"

#include "base/log.h"

/* Log₂(side) passes along each axis, from one texture to the other; returns the last. */
static const struct gpu_texture *transform(struct ocean_state *state, struct dpl_gl *gl)
{
    const struct gpu_texture *from = &state->modes_texture;
    const struct gpu_program *program = &state->fft_program;
    int next = 0;
    program_use(gl, program);
    program_int(gl, program, "from", 0);
    program_int(gl, program, "side", state->side);
    for (int axis = 0; axis < 2; axis++) {
        for (int span = 1; span < state->side; span *= 2) {
            struct gpu_texture *to = state->passes + next;
            texture_draw_to(gl, to);
            texture_bind(gl, from, 0);
            program_int(gl, program, "axis", axis);
            program_int(gl, program, "span", span);
            program_int(gl, program, "modes", from == &state->modes_texture);
            gpu_draw_screen(gl);
            from = to;
            next = 1 - next;
        }
    }
    return from;
}

static void draw_surface(const struct ocean_state *state, struct dpl_gl *gl, const struct gpu_program *program,
                         const struct gpu_texture *coefficients, struct gpu_texture *to)
{
    program_use(gl, program);
    texture_draw_to(gl, to);
    texture_bind(gl, coefficients, 0);
    program_int(gl, program, "coefficients", 0);
    program_int(gl, program, "side", state->side);
    program_int(gl, program, "vertices", to->width);
    program_int(gl, program, "cascades", state->cascades);
    program_int(gl, program, "choppy", state->choppiness > 0);
    program_float(gl, program, "size", state->size);
    gpu_draw_screen(gl);
}

bool ocean_gpu_draw(struct ocean_state *state, struct dpl_gl *gl, int side, struct gpu_texture *texels,
                    struct gpu_texture *shifts)
{
    bool choppy = state->choppiness > 0;
    int modes = state->modes, height = state->side * state->tiles;
    if (height > gl->info.texture_max)
        return base_fail(gl->log, DPL_REASON_LIMIT,
                         "ocean: too large for this device: %d rows of a texture (at most %d)", height,
                         gl->info.texture_max);
    if (!program_ready(gl, &state->fft_program, "water/ocean_fft.glsl", "") ||
        !program_ready(gl, &state->texel_program, "water/ocean_surface.glsl", "") ||
        !program_ready(gl, &state->shift_program, "water/ocean_surface.glsl", "#define SHIFTS\n"))
        return false;
    texture_resize(gl, &state->modes_texture, GL_RGBA32F, modes, modes * state->tiles, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_upload(gl, &state->modes_texture, state->spectrum);
    for (int i = 0; i < 2; i++)
        texture_resize(gl, state->passes + i, GL_RGBA32F, state->side, height, TEXTURE_CLAMP, TEXTURE_NEAREST);
    const struct gpu_texture *coefficients = transform(state, gl);
    texture_resize(gl, texels, GL_RGBA32F, side, side, TEXTURE_CLAMP, TEXTURE_NEAREST);
    draw_surface(state, gl, &state->texel_program, coefficients, texels);
    if (choppy) {
        texture_resize(gl, shifts, GL_RG32F, side, side, TEXTURE_CLAMP, TEXTURE_NEAREST);
        draw_surface(state, gl, &state->shift_program, coefficients, shifts);
    }
    return true;
}

void ocean_gpu_finish(struct ocean_state *state, struct dpl_gl *gl)
{
    program_finish(gl, &state->fft_program);
    program_finish(gl, &state->texel_program);
    program_finish(gl, &state->shift_program);
    texture_finish(gl, &state->modes_texture);
    for (int i = 0; i < 2; i++)
        texture_finish(gl, state->passes + i);
}
