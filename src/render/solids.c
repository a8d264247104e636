/* Solids: the world's triangles in the device's memory. */
#include "render/physical.h"

#include "base/log.h"

#include <math.h>
#include <stdlib.h>

enum { ATTRIBUTE_POSITION, ATTRIBUTE_NORMAL, ATTRIBUTE_COLOR, ATTRIBUTE_PLACE, ATTRIBUTE_SWAY, ATTRIBUTE_AMBIENT };

static enum solid_kind wet_kind(const struct physical *physical)
{
    return physical->light.glass > 0 ? SOLID_IN_TANK : SOLID_WET;
}

bool solids_prepare(struct solids *solids, struct dpl_gl *gl, const struct physical *physical)
{
    static const char *const defines[SOLID_KINDS] = {"", "#define WET\n", "#define WET\n#define TANK\n"};
    enum solid_kind wet = wet_kind(physical);
    return program_ready(gl, solids->programs + SOLID_DRY, "render/solid.glsl", defines[SOLID_DRY]) &&
           program_ready(gl, solids->programs + wet, "render/solid.glsl", defines[wet]);
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

static float edge_length(const struct world *world, const unsigned *corners, int k)
{
    const float *a = world->vertices[corners[k]].position, *b = world->vertices[corners[(k + 1) % 3]].position;
    float square = 0;
    for (int c = 0; c < 3; c++)
        square += (a[c] - b[c]) * (a[c] - b[c]);
    return sqrtf(square);
}

static struct part_extent measure_part(const struct world *world, const struct world_part *part)
{
    struct part_extent extent = {INFINITY, -INFINITY, 0};
    for (int i = part->first; i < part->first + part->count; i++) {
        float y = world->vertices[world->indices[i]].position[1];
        extent.low = fminf(extent.low, y);
        extent.high = fmaxf(extent.high, y);
        extent.edge = fmaxf(extent.edge, edge_length(world, world->indices + (i - i % 3), i % 3));
    }
    return extent;
}

static bool measure_parts(struct solids *solids, const struct dpl_log *log, const struct world *world)
{
    free(solids->extents);
    solids->extents = base_allocate(log, (size_t)world->part_count + 1, sizeof *solids->extents, "solids");
    for (int p = 0; solids->extents && p < world->part_count; p++)
        solids->extents[p] = measure_part(world, world->parts + p);
    return solids->extents != NULL;
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

void solids_find_dry(struct solids *solids, const struct frame *frame, const struct world *world, double reach)
{
    const double step = 0.25; /* m; a box too large does no harm */
    double level = -step * ceil(reach / step);
    if (solids->dry.fingerprint == world->fingerprint && solids->dry.level == level)
        return;
    solids->dry.fingerprint = world->fingerprint;
    solids->dry.level = level;
    world_box(world, frame->scene->current.strength, level, solids->dry.low, solids->dry.high);
}

static void draw_part(struct dpl_gl *gl, const struct world_part *part)
{
    gl->DrawElements(GL_TRIANGLES, part->count, GL_UNSIGNED_INT,
                     (const void *)((size_t)part->first * sizeof(unsigned)));
}

static void draw_parts(const struct physical *physical, const struct frame *frame, const struct gpu_program *program,
                       bool wet)
{
    struct dpl_gl *gl = frame->gl;
    const struct world *world = &physical->world;
    const float reach = (float)physical->waves.reach;
    bool endless = waves_extent(frame) == 0;
    for (int i = 0; i < world->part_count; i++) {
        const struct world_part *part = world->parts + i;
        const struct part_extent *extent = physical->solids.extents + i;
        if (wet ? extent->low > reach : endless && extent->high < -reach)
            continue;
        program_float(gl, program, "cut", reach + extent->edge);
        program_int(gl, program, "pattern", part->pattern);
        program_float(gl, program, "pattern_size", part->pattern_size);
        program_vec3(gl, program, "pattern_joint", part->joint);
        program_int(gl, program, "two_sided", part->two_sided);
        draw_part(gl, part);
    }
}

void solids_draw(const struct physical *physical, const struct frame *frame, enum physical_layer layer, bool wet)
{
    struct dpl_gl *gl = frame->gl;
    const struct gpu_program *program = physical->solids.programs + (wet ? wet_kind(physical) : SOLID_DRY);
    const double *mirrors = physical->sight.mirrors;
    if (physical->world.index_count == 0)
        return;
    program_use(gl, program);
    physical_bind(physical, frame, program);
    program_int(gl, program, "layer", (int)layer);
    gl->BindVertexArray(physical->solids.array);
    int x_most = wet && mirrors[0] > 0, z_most = wet && mirrors[1] > 0;
    for (int x = -x_most; x <= x_most; x++) {
        for (int z = -z_most; z <= z_most; z++) {
            program_ivec2(gl, program, "image", x, z);
            draw_parts(physical, frame, program, wet);
        }
    }
}

void solids_cast(const struct solids *solids, struct dpl_gl *gl, const struct world *world,
                 const struct gpu_program *program, bool above)
{
    gl->BindVertexArray(solids->array);
    for (int i = 0; i < world->part_count; i++) {
        const struct part_extent *extent = solids->extents + i;
        if (!world->parts[i].casts || (above ? extent->high <= 0 : extent->low >= 0))
            continue;
        program_float(gl, program, "cut", extent->edge);
        draw_part(gl, world->parts + i);
    }
}

void solids_finish(struct solids *solids, struct dpl_gl *gl)
{
    const GLuint buffers[] = {solids->vertices, solids->ambient, solids->indices};
    for (int i = 0; i < SOLID_KINDS; i++)
        program_finish(gl, solids->programs + i);
    gl->DeleteVertexArrays(1, &solids->array);
    gl->DeleteBuffers(3, buffers);
    free(solids->extents);
    *solids = (struct solids){0};
}
