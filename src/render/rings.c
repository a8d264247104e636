#include "render/rings.h"

#include "base/log.h"

#include <math.h>
#include <stdlib.h>

#define NEAREST 0.02 /* radius of the first ring, in heights of the eye */

bool rings_ready(struct rings *rings, struct dpl_gl *gl, int count, int around)
{
    if (rings->count == count && rings->around == around)
        return true;
    size_t cells = (size_t)(count - 1) * (size_t)(around - 1);
    unsigned *indices = base_allocate(gl->log, cells * 6, sizeof *indices, "rings"), *next = indices;
    if (!indices)
        return false;
    for (int ring = 0; ring + 1 < count; ring++) {
        for (int i = 0; i + 1 < around; i++) {
            unsigned inner = (unsigned)(ring * around + i), outer = inner + (unsigned)around;
            const unsigned cell[6] = {inner, outer, inner + 1, inner + 1, outer, outer + 1};
            for (int k = 0; k < 6; k++)
                *next++ = cell[k];
        }
    }
    if (!rings->count) {
        gl->GenVertexArrays(1, &rings->array);
        gl->GenBuffers(1, &rings->buffer);
    }
    gl->BindVertexArray(rings->array);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, rings->buffer);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(cells * 6 * sizeof *indices), indices, GL_STATIC_DRAW);
    free(indices);
    rings->count = count;
    rings->around = around;
    return true;
}

/* The directions round the eye that the picture shows: half the angle, to each side of the middle. */
static double half_angle(const struct camera_rays *rays, double *middle)
{
    double widest = 0, level = hypot(rays->ahead[0], rays->ahead[2]);
    *middle = atan2(rays->ahead[2], rays->ahead[0]);
    if (level < 0.2)
        return M_PI;
    for (int corner = 0; corner < 4; corner++) {
        double x = corner & 1 ? 1 : -1, y = corner & 2 ? 1 : -1, ray[3];
        for (int c = 0; c < 3; c++)
            ray[c] = rays->ahead[c] + x * rays->right[c] + y * rays->up[c];
        double along = (ray[0] * rays->ahead[0] + ray[2] * rays->ahead[2]) / level;
        double across = (ray[2] * rays->ahead[0] - ray[0] * rays->ahead[2]) / level;
        if (along <= 0.1 * level)
            return M_PI; /* the picture holds, or nearly, what is straight above or below the eye */
        widest = fmax(widest, fabs(atan2(across, along)));
    }
    return fmin(1.05 * widest + 0.02, M_PI);
}

void rings_draw(const struct rings *rings, const struct frame *frame, const struct gpu_program *program, double height,
                double farthest, double extent)
{
    struct dpl_gl *gl = frame->gl;
    const double *eye = frame->camera->position;
    /* by the whole picture, so that its tiles have the same vertices */
    const struct camera_view whole = {frame->view.width, frame->view.height, 0, 0,
                                      frame->view.width, frame->view.height};
    const struct camera_rays rays = camera_rays(frame->camera, &whole);
    double middle, half = half_angle(&rays, &middle), nearest = NEAREST * fmax(fabs(height), 0.05);
    const float radii[2] = {(float)nearest, (float)fmax(farthest, 2 * nearest)};
    const float angles[2] = {(float)(middle - half), (float)(2 * half / (rings->around - 1))};
    const float place[2] = {(float)eye[0], (float)eye[2]};
    program_ivec2(gl, program, "rings_count", rings->count, rings->around);
    program_vec2(gl, program, "rings_radii", radii[0], radii[1]);
    program_vec2(gl, program, "rings_angles", angles[0], angles[1]);
    program_vec2(gl, program, "rings_middle", place[0], place[1]);
    program_float(gl, program, "rings_extent", extent);
    gl->BindVertexArray(rings->array);
    gl->DrawElements(GL_TRIANGLES, (rings->count - 1) * (rings->around - 1) * 6, GL_UNSIGNED_INT, NULL);
}

void rings_finish(struct rings *rings, struct dpl_gl *gl)
{
    gl->DeleteVertexArrays(1, &rings->array);
    gl->DeleteBuffers(1, &rings->buffer);
    *rings = (struct rings){0};
}
