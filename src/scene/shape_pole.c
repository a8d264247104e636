/* A pole: a cylinder with a rounded top; size: its width, its height and its depth. */
#include "scene/shape.h"
#include "scene/world_builder.h"

#include <math.h>

#define SEGMENTS 32
#define CAP 8 /* steps of the rounded top */
#define STEPS_MAX 256

static bool build(struct world_builder *builder, const struct scene_object *object, int seed)
{
    (void)seed; /* all poles are alike */
    double radius = object->size[0] / 2, cap = fmin(radius, object->size[1] / 2), side = object->size[1] - cap;
    double profile[STEPS_MAX + CAP + 3][2] = {{0, 0}, {radius, 0}};
    int steps = (int)fmin(fmax(ceil(side / builder_cell(object->size[1])), 1), STEPS_MAX), points = 2;
    for (int i = 0; i <= steps; i++, points++) { /* its first point is given twice: an edge */
        profile[points][0] = radius;
        profile[points][1] = side * i / steps;
    }
    for (int i = 1; i <= CAP; i++, points++) {
        double angle = M_PI / 2 * i / CAP;
        profile[points][0] = i < CAP ? radius * cos(angle) : 0;
        profile[points][1] = side + cap * sin(angle);
    }
    int first = builder->vertex_count;
    builder_revolve(builder, (const double(*)[2])profile, points, SEGMENTS, object->color);
    double flatten = object->size[2] / object->size[0];
    for (int v = first; v < builder->vertex_count && builder_ok(builder); v++) {
        struct world_vertex *vertex = builder->vertices + v;
        double x = vertex->normal[0], y = vertex->normal[1], z = (double)vertex->normal[2] / flatten;
        double length = sqrt(x * x + y * y + z * z);
        vertex->position[2] *= (float)flatten;
        vertex->normal[0] = (float)(x / length);
        vertex->normal[1] = (float)(y / length);
        vertex->normal[2] = (float)(z / length);
    }
    return builder_ok(builder);
}

const struct scene_shape shape_pole = {
    .name = "pole",
    .summary = "an upright pole with a rounded top",
    .color = {{0.3, 0.24, 0.18}, {0.3, 0.24, 0.18}},
    .build = build,
};
