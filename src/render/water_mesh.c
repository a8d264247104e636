#include "render/water_mesh.h"

#include "base/log.h"

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
bool water_mesh_ready(struct water_mesh *mesh, const struct frame *frame, int cells_max)
{
    struct dpl_gl *gl = frame->gl;
    int surface_cells = cell_count(frame->surface);
    int stride = cells_max > 0 ? (surface_cells + cells_max - 1) / cells_max : 1;
    int cells = (surface_cells + stride - 1) / stride;
    mesh->stride = stride;
    if (mesh->cells == cells)
        return true;
    size_t count = (size_t)cells * (size_t)cells * 6;
    unsigned *indices = base_allocate(gl->log, count * 2, sizeof *indices, "triangles of the water");
    if (!indices)
        return false;
    fill_cells(indices, cells);
    for (size_t i = 0; i < count; i++)
        indices[count + i] = indices[count - 1 - i];
    if (!mesh->cells) {
        gl->GenVertexArrays(1, &mesh->array);
        gl->GenBuffers(1, &mesh->buffer);
    }
    gl->BindVertexArray(mesh->array);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh->buffer);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(count * 2 * sizeof *indices), indices, GL_STATIC_DRAW);
    free(indices);
    mesh->cells = cells;
    return true;
}

/* `along`: the eye's place on the axis that the rows follow each other on, 0 to 1 across the tile. */
static void draw_rows(const struct water_mesh *mesh, struct dpl_gl *gl, double along)
{
    int cells = mesh->cells, first = (int)fmin(fmax(along * cells, 0), cells);
    GLsizei row = cells * 6;
    GLsizeiptr back = (GLsizeiptr)row * (2 * cells - first);
    gl->BindVertexArray(mesh->array);
    gl->DrawElements(GL_TRIANGLES, (cells - first) * row, GL_UNSIGNED_INT,
                     (const void *)((GLsizeiptr)first * row * (GLsizeiptr)sizeof(unsigned)));
    gl->DrawElements(GL_TRIANGLES, first * row, GL_UNSIGNED_INT, (const void *)(back * (GLsizeiptr)sizeof(unsigned)));
}

void water_mesh_draw(const struct water_mesh *mesh, const struct frame *frame, const struct gpu_program *program,
                     int unit, const double tile[3])
{
    /* Rows follow each other along the axis that the eye is farther out on. */
    const double *camera = frame->camera->position, eye[] = {camera[0] - tile[0], 0, camera[2] - tile[2]};
    bool swapped = fabs(eye[0]) > fabs(eye[2]);
    surface_gpu_bind(frame->gl, frame->surface, program, unit);
    program_mat4(frame->gl, program, "view_projection", frame->view_projection);
    program_int(frame->gl, program, "columns", mesh->cells + 1);
    program_int(frame->gl, program, "stride", mesh->stride);
    program_int(frame->gl, program, "swapped", swapped);
    program_vec3(frame->gl, program, "tile", tile);
    draw_rows(mesh, frame->gl, eye[swapped ? 0 : 2] / frame->surface->size + 0.5);
}

void water_mesh_finish(struct water_mesh *mesh, struct dpl_gl *gl)
{
    gl->DeleteVertexArrays(1, &mesh->array);
    gl->DeleteBuffers(1, &mesh->buffer);
    *mesh = (struct water_mesh){0};
}
