/* Solids: the world's triangles in the device's memory. */
#include "render/physical.h"

#include "base/log.h"

#include <math.h>
#include <stdlib.h>

enum { ATTRIBUTE_POSITION, ATTRIBUTE_NORMAL, ATTRIBUTE_COLOR, ATTRIBUTE_PLACE, ATTRIBUTE_SWAY, ATTRIBUTE_AMBIENT };

bool solids_prepare(struct solids *solids, struct dpl_gl *gl)
{
    return program_ready(gl, solids->programs, "render/solid.glsl", "") &&
           program_ready(gl, solids->programs + 1, "render/solid.glsl", "#define WET\n");
}

static void attribute(struct dpl_gl *gl, GLuint index, int channels, size_t stride, size_t offset)
{
    gl->EnableVertexAttribArray(index);
    gl->VertexAttribPointer(index, channels, GL_FLOAT, GL_FALSE, (GLsizei)stride, (const void *)offset);
}

static void make_buffers(struct solids *solids, struct dpl_gl *gl)
{
    const size_t stride = sizeof(struct world_vertex);
    GLuint buffers[3];
    gl->GenVertexArrays(1, &solids->array);
    gl->GenBuffers(3, buffers);
    solids->vertices = buffers[0];
    solids->ambient = buffers[1];
    solids->indices = buffers[2];
    gl->BindVertexArray(solids->array);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, solids->indices);
    gl->BindBuffer(GL_ARRAY_BUFFER, solids->vertices);
    attribute(gl, ATTRIBUTE_POSITION, 3, stride, offsetof(struct world_vertex, position));
    attribute(gl, ATTRIBUTE_NORMAL, 3, stride, offsetof(struct world_vertex, normal));
    attribute(gl, ATTRIBUTE_COLOR, 3, stride, offsetof(struct world_vertex, color));
    attribute(gl, ATTRIBUTE_PLACE, 2, stride, offsetof(struct world_vertex, place));
    attribute(gl, ATTRIBUTE_SWAY, 1, stride, offsetof(struct world_vertex, sway));
    gl->BindBuffer(GL_ARRAY_BUFFER, solids->ambient);
    attribute(gl, ATTRIBUTE_AMBIENT, 3, 3 * sizeof(float), 0);
}

/* The heights that each part lies between. */
static bool measure_parts(struct solids *solids, const struct dpl_log *log, const struct world *world)
{
    free(solids->heights);
    solids->heights = base_allocate(log, (size_t)world->part_count + 1, sizeof *solids->heights, "solids");
    for (int p = 0; solids->heights && p < world->part_count; p++) {
        float *heights = solids->heights[p];
        heights[0] = INFINITY;
        heights[1] = -INFINITY;
        for (int i = world->parts[p].first; i < world->parts[p].first + world->parts[p].count; i++) {
            float y = world->vertices[world->indices[i]].position[1];
            heights[0] = fminf(heights[0], y);
            heights[1] = fmaxf(heights[1], y);
        }
    }
    return solids->heights != NULL;
}

bool solids_upload(struct solids *solids, struct dpl_gl *gl, const struct world *world, const float *ambient)
{
    if (!solids->array)
        make_buffers(solids, gl);
    gl->BindVertexArray(solids->array);
    if (solids->fingerprint != world->fingerprint) {
        gl->BindBuffer(GL_ARRAY_BUFFER, solids->vertices);
        gl->BufferData(GL_ARRAY_BUFFER, world->vertex_count * (GLsizeiptr)sizeof *world->vertices, world->vertices,
                       GL_STATIC_DRAW);
        gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, world->index_count * (GLsizeiptr)sizeof *world->indices, world->indices,
                       GL_STATIC_DRAW);
        if (!measure_parts(solids, gl->log, world))
            return false;
        solids->fingerprint = world->fingerprint;
    }
    gl->BindBuffer(GL_ARRAY_BUFFER, solids->ambient);
    gl->BufferData(GL_ARRAY_BUFFER, world->vertex_count * (GLsizeiptr)(3 * sizeof *ambient), ambient, GL_STATIC_DRAW);
    return true;
}

static void draw_part(struct dpl_gl *gl, const struct world_part *part)
{
    gl->DrawElements(GL_TRIANGLES, part->count, GL_UNSIGNED_INT,
                     (const void *)((size_t)part->first * sizeof(unsigned)));
}

void solids_draw(const struct physical *physical, const struct frame *frame, enum physical_layer layer, bool wet)
{
    struct dpl_gl *gl = frame->gl;
    const struct gpu_program *program = physical->solids.programs + wet;
    const struct world *world = &physical->world;
    if (world->index_count == 0)
        return;
    program_use(gl, program);
    physical_bind(physical, frame, program);
    program_int(gl, program, "layer", (int)layer);
    const float reach = (float)waves_reach(frame);
    gl->BindVertexArray(physical->solids.array);
    for (int i = 0; i < world->part_count; i++) {
        const struct world_part *part = world->parts + i;
        const float *heights = physical->solids.heights[i];
        if (wet ? heights[0] > reach : heights[1] < -reach)
            continue;
        program_int(gl, program, "pattern", part->pattern);
        program_float(gl, program, "pattern_size", part->pattern_size);
        program_vec3(gl, program, "pattern_joint", part->joint);
        program_int(gl, program, "two_sided", part->two_sided);
        draw_part(gl, part);
    }
}

void solids_cast(const struct solids *solids, struct dpl_gl *gl, const struct world *world)
{
    gl->BindVertexArray(solids->array);
    for (int i = 0; i < world->part_count; i++)
        if (world->parts[i].casts)
            draw_part(gl, world->parts + i);
}

void solids_finish(struct solids *solids, struct dpl_gl *gl)
{
    const GLuint buffers[] = {solids->vertices, solids->ambient, solids->indices};
    program_finish(gl, solids->programs);
    program_finish(gl, solids->programs + 1);
    gl->DeleteVertexArrays(1, &solids->array);
    gl->DeleteBuffers(3, buffers);
    free(solids->heights);
    *solids = (struct solids){0};
}
