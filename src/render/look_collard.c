/* Collard & Mundi 2022, sections 3.5 (ground) and 3.6 (water): the ground first, the water blended over it. */
#include "render/look_collard.h"

#include "base/log.h"
#include "light/map_texture.h"

#include <math.h>
#include <stdlib.h>

/* Vertex numbers of the two triangles of every cell, row by row from -z to +z. */
static void fill_cells(unsigned *indices, int cells)
{
    for (int j = 0; j < cells; j++) {
        for (int i = 0; i < cells; i++) {
            unsigned corner = (unsigned)(j * (cells + 1) + i), below = corner + (unsigned)cells + 1;
            const unsigned cell[6] = {corner, below, corner + 1, corner + 1, below, below + 1};
            for (int k = 0; k < 6; k++)
                *indices++ = cell[k];
        }
    }
}

/* Cells a side; a periodic surface has one more than its vertices show, back to its first. */
static int cell_count(const struct surface_gpu *surface)
{
    return surface->texels.width - (surface->periodic ? 0 : 1);
}

/* The buffer holds every triangle twice, from the first row of cells to the last and back. */
static bool update_cells(struct look_collard_state *state, struct dpl_gl *gl, int cells)
{
    if (state->cells == cells)
        return true;
    size_t count = (size_t)cells * (size_t)cells * 6;
    unsigned *indices = base_allocate(gl->log, count * 2, sizeof *indices, "triangles of the water");
    if (!indices)
        return false;
    fill_cells(indices, cells);
    for (size_t i = 0; i < count; i++)
        indices[count + i] = indices[count - 1 - i];
    if (!state->cells_array) {
        gl->GenVertexArrays(1, &state->cells_array);
        gl->GenBuffers(1, &state->cells_buffer);
    }
    gl->BindVertexArray(state->cells_array);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, state->cells_buffer);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(count * 2 * sizeof *indices), indices, GL_STATIC_DRAW);
    free(indices);
    state->cells = cells;
    return true;
}

/* Draws the rows of cells from the eye outwards, so that a crest is drawn before what it hides and is not blended over
 * it. `along`: the eye's place on the axis that the rows follow each other on, 0 to 1 across the tile. */
static void draw_cells(const struct look_collard_state *state, struct dpl_gl *gl, double along)
{
    int cells = state->cells, first = (int)fmin(fmax(along * cells, 0), cells);
    GLsizei row = cells * 6;
    GLsizeiptr back = (GLsizeiptr)row * (2 * cells - first);
    gl->BindVertexArray(state->cells_array);
    gl->DrawElements(GL_TRIANGLES, (cells - first) * row, GL_UNSIGNED_INT,
                     (const void *)((GLsizeiptr)first * row * (GLsizeiptr)sizeof(unsigned)));
    gl->DrawElements(GL_TRIANGLES, first * row, GL_UNSIGNED_INT, (const void *)(back * (GLsizeiptr)sizeof(unsigned)));
}

static void draw_ground(struct look_collard_state *state, const struct frame *frame)
{
    struct dpl_gl *gl = frame->gl;
    const struct dpl_scene *scene = frame->scene;
    const struct look_collard *look = &scene->look_collard;
    const struct gpu_program *program = &state->ground;
    double depth = scene->settings.depth;
    double loss = look->attenuation[0] / (look->attenuation[1] * depth * depth + look->attenuation[2] * depth + 1);
    program_use(gl, program);
    program_mat4(gl, program, "view_projection", frame->view_projection);
    program_float(gl, program, "size", scene->settings.size);
    program_float(gl, program, "depth", depth);
    program_float(gl, program, "sand_share", look->sand_share);
    program_float(gl, program, "attenuation", loss < 1 ? loss : 1);
    program_float(gl, program, "brightest", look->brightest);
    program_float(gl, program, "floor_tint", look->floor_tint);
    program_vec3(gl, program, "water_color", look->water_color);
    texture_bind(gl, frame->sand, 0);
    map_texture_bind(gl, frame->map, frame->windows, scene->settings.size, program, 1);
    program_int(gl, program, "sand", 0);
    gl->BindVertexArray(gl->empty_array);
    gl->DrawArrays(GL_TRIANGLES, 0, 6);
}

static void draw_water(struct look_collard_state *state, const struct frame *frame)
{
    struct dpl_gl *gl = frame->gl;
    const struct look_collard *look = &frame->scene->look_collard;
    const struct gpu_program *program = &state->water;
    program_use(gl, program);
    surface_gpu_bind(gl, frame->surface, program, 0);
    program_mat4(gl, program, "view_projection", frame->view_projection);
    program_int(gl, program, "columns", state->cells + 1);
    program_vec3(gl, program, "eye", frame->scene->camera.position);
    program_vec3(gl, program, "lamp_position", look->lamp_position);
    program_vec3(gl, program, "lamp_color", look->lamp_color);
    program_vec3(gl, program, "water_color", look->water_color);
    program_float(gl, program, "ambient", look->ambient);
    program_float(gl, program, "shininess", look->shininess);
    program_float(gl, program, "threshold", look->threshold);
    /* Rows follow each other along the axis that the eye is farther out on. */
    const double *eye = frame->scene->camera.position;
    bool swapped = fabs(eye[0]) > fabs(eye[2]);
    program_int(gl, program, "swapped", swapped);
    gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
    draw_cells(state, gl, eye[swapped ? 0 : 2] / frame->surface->size + 0.5);
    gl->Disable(GL_BLEND);
}

static void set_wireframe(struct dpl_gl *gl, bool on)
{
    if (gl->PolygonMode)
        gl->PolygonMode(GL_FRONT_AND_BACK, on ? GL_LINE : GL_FILL);
}

bool look_collard_draw(struct look_collard_state *state, const struct frame *frame)
{
    struct dpl_gl *gl = frame->gl;
    bool built = program_ready(gl, &state->ground, "render/collard_ground.glsl", "") &&
                 program_ready(gl, &state->water, "render/collard_water.glsl", "");
    if (!built || !update_cells(state, gl, cell_count(frame->surface)))
        return false;
    gl->Enable(GL_DEPTH_TEST);
    set_wireframe(gl, frame->scene->render.wireframe);
    timer_pass(frame->timer, "ground");
    draw_ground(state, frame);
    timer_pass(frame->timer, "water");
    draw_water(state, frame);
    set_wireframe(gl, false);
    gl->Disable(GL_DEPTH_TEST);
    return true;
}

void look_collard_finish(struct look_collard_state *state, struct dpl_gl *gl)
{
    program_finish(gl, &state->ground);
    program_finish(gl, &state->water);
    gl->DeleteVertexArrays(1, &state->cells_array);
    gl->DeleteBuffers(1, &state->cells_buffer);
    *state = (struct look_collard_state){0};
}
