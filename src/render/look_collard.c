/* Collard & Mundi 2022, sections 3.5 (ground) and 3.6 (water): the ground first, the water blended over it. */
#include "render/look_collard.h"

#include "base/log.h"

#include <stdlib.h>

/* Vertex numbers of the two triangles of every cell, row by row from -z to +z. */
static void fill_cells(unsigned *indices, int across, int down)
{
    for (int j = 0; j < down; j++) {
        for (int i = 0; i < across; i++) {
            unsigned corner = (unsigned)(j * (across + 1) + i), below = corner + (unsigned)across + 1;
            const unsigned cell[6] = {corner, below, corner + 1, corner + 1, below, below + 1};
            for (int k = 0; k < 6; k++)
                *indices++ = cell[k];
        }
    }
}

/* Cells along one axis: a periodic surface has one more, back to its first vertex. */
static int cell_count(int vertices, bool periodic)
{
    return periodic ? vertices : vertices - 1;
}

static bool update_cells(struct look_collard_state *state, struct dpl_gl *gl, const struct surface_gpu *surface)
{
    int columns = surface->texels.width, rows = surface->texels.height;
    if (state->columns == columns && state->rows == rows && state->periodic == surface->periodic)
        return true;
    int across = cell_count(columns, surface->periodic), down = cell_count(rows, surface->periodic);
    size_t count = (size_t)across * (size_t)down * 6;
    unsigned *indices = base_allocate(gl->log, count, sizeof *indices, "triangles of the water");
    if (!indices)
        return false;
    fill_cells(indices, across, down);
    if (!state->cells_array) {
        gl->GenVertexArrays(1, &state->cells_array);
        gl->GenBuffers(1, &state->cells_buffer);
    }
    gl->BindVertexArray(state->cells_array);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, state->cells_buffer);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(count * sizeof *indices), indices, GL_STATIC_DRAW);
    free(indices);
    state->columns = columns;
    state->rows = rows;
    state->periodic = surface->periodic;
    return true;
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
    texture_bind(gl, frame->map, 1);
    program_int(gl, program, "sand", 0);
    program_int(gl, program, "light_texels", 1);
    program_int(gl, program, "light_channels", frame->map_channels);
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
    program_int(gl, program, "columns", cell_count(state->columns, state->periodic) + 1);
    program_vec3(gl, program, "eye", frame->scene->camera.position);
    program_vec3(gl, program, "lamp_position", look->lamp_position);
    program_vec3(gl, program, "lamp_color", look->lamp_color);
    program_vec3(gl, program, "water_color", look->water_color);
    program_float(gl, program, "ambient", look->ambient);
    program_float(gl, program, "shininess", look->shininess);
    program_float(gl, program, "threshold", look->threshold);
    gl->BindVertexArray(state->cells_array);
    int indices = cell_count(state->columns, state->periodic) * cell_count(state->rows, state->periodic) * 6;
    /* Depth alone first, so that a crest hides what is behind it whatever the order of the cells. */
    gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl->DrawElements(GL_TRIANGLES, indices, GL_UNSIGNED_INT, NULL);
    gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl->DepthFunc(GL_LEQUAL);
    gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
    gl->DrawElements(GL_TRIANGLES, indices, GL_UNSIGNED_INT, NULL);
    gl->Disable(GL_BLEND);
    gl->DepthFunc(GL_LESS);
}

static void set_wireframe(struct dpl_gl *gl, bool on)
{
    if (gl->PolygonMode)
        gl->PolygonMode(GL_FRONT_AND_BACK, on ? GL_LINE : GL_FILL);
}

bool look_collard_draw(struct look_collard_state *state, const struct frame *frame)
{
    struct dpl_gl *gl = frame->gl;
    bool built = (state->ground.name || program_build(gl, &state->ground, "render/collard_ground.glsl", "")) &&
                 (state->water.name || program_build(gl, &state->water, "render/collard_water.glsl", ""));
    if (!built || !update_cells(state, gl, frame->surface))
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
