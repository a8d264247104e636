/* The waves of Collard & Mundi 2022, "Real-Time Water Caustics": the four presets of their program, the radial wave of
 * their figure 2 and the non-periodic ripple of their figure 3, on their plane of square cells.
 *
 * Two of the presets are noise made by aliasing: terms whose phase turns by hundreds of radians from vertex to vertex,
 * so that what the grid keeps of them is slow noise. They are the picture, so they are evaluated on the vertices of the
 * paper's own grid with angles in double precision, and cannot be sampled between the vertices. */
#include "water/water.h"

#include <math.h>

/* The paper's constants, with the digits that it has them. */
#define P 3.14159
#define PHI 1.618034
#define E 2.7182818
#define NOISE_START 30000.0

enum collard_wave { PRESET_1, PRESET_2, PRESET_3, PRESET_4, RADIAL, RIPPLE };

struct collard {
    int wave;
    double amplitude, frequency;
    int cells;
    double time_unit, space_unit;
};

static const char *wave_name(int i)
{
    static const char *const names[] = {"preset-1", "preset-2", "preset-3", "preset-4", "radial", "ripple", NULL};
    return names[i];
}

static const struct dpl_param params[] = {
    PARAM_CHOICE(struct collard, wave, PRESET_1, wave_name, "which of the paper's wave functions"),
    PARAM_FLOAT(struct collard, amplitude, 0.06125, 0, 4, "space units", "A: overall height"),
    PARAM_FLOAT(struct collard, frequency, 4, 0, 64, "", "f: overall density of waves"),
    PARAM_INT(struct collard, cells, 160, 2, 2048, "", "cells of the plane a side (the paper: 160, or 80)"),
    PARAM_FLOAT(struct collard, time_unit, 1, 0.001, 1000, "s", "what the paper's t counts"),
    PARAM_FLOAT(struct collard, space_unit, 1, 0.001, 1000, "m", "what the paper's x, z and A count"),
    PARAM_END,
};

/* A vertex as a wave function sees it, in the paper's units. */
struct vertex {
    double x, z, distance; /* distance from the middle of the plane */
    int index;             /* its place in the paper's mesh file */
};

/* Where the paper's mesh file lists vertex (column, row), rows from -z to +z: corners, then the four edges, then the
 * inside column by column from +z to -z. */
static int mesh_index(int column, int row, int cells)
{
    int inner = cells - 1;
    bool left = column == 0, right = column == cells, far = row == 0, near = row == cells;
    if ((left || right) && (far || near))
        return (far ? 2 : 0) + (right ? 1 : 0);
    if (near)
        return 4 + (column - 1);
    if (far)
        return 4 + inner + (inner - column);
    if (left)
        return 4 + 2 * inner + (row - 1);
    if (right)
        return 4 + 3 * inner + (inner - row);
    return 4 + 4 * inner + (column - 1) * inner + (inner - row);
}

static double preset_1(const struct collard *w, const struct vertex *v, double t)
{
    double noise = -3.2 * sin(-1.3 * PHI * (1 - v->distance / 2) * (t + NOISE_START) * 4) -
                   1.2 * sin(-1.7 * E * v->z * t) + 1.9 * sin(1.7 * P * v->x * (t + NOISE_START));
    return w->amplitude / 10 * 0.2 * noise + w->amplitude / 50 * sin(-5 * P * v->distance * w->frequency + 2 * t);
}

/* The factor that makes preset 2 irregular: its angle is a product of single-precision numbers from left to right. */
static double vertex_noise(const struct collard *w, const struct vertex *v, double t)
{
    float angle = -(float)P * (float)v->x * (float)w->frequency * (float)(4 * v->index);
    return (sin((double)angle + 2 * t) + 1) / 2;
}

static double crossing_waves(const struct collard *w, const struct vertex *v, double t)
{
    return w->amplitude / 1.5 * sin(-P * v->distance * w->frequency + 2 * t) * sin(-P * v->x * w->frequency + 3 * t) *
           sin(-P * v->z * w->frequency / 2 + 4 * t);
}

static double swell(const struct collard *w, const struct vertex *v, double t)
{
    return w->amplitude * sin(-P * v->x * v->z * w->frequency / 8 + 2 * t) +
           w->amplitude * sin(-P * v->x * w->frequency / 16 + 2 * t);
}

static double preset_2(const struct collard *w, const struct vertex *v, double t)
{
    return crossing_waves(w, v, t) * vertex_noise(w, v, t) + swell(w, v, t) +
           w->amplitude / 10 * sin(-5 * P * v->distance * w->frequency + 2 * t);
}

static double preset_3(const struct collard *w, const struct vertex *v, double t)
{
    return swell(w, v, t) + w->amplitude / 50 * sin(-5 * P * v->distance * w->frequency + 2 * t) +
           crossing_waves(w, v, t);
}

static double preset_4(const struct collard *w, const struct vertex *v, double t)
{
    return w->amplitude / 10 * sin(-P * v->distance * w->frequency + t);
}

static double radial(const struct collard *w, const struct vertex *v, double t)
{
    return w->amplitude * sin(-P * v->distance * w->frequency + t);
}

/* Figure 3 plots (sin 2u + sin πu) / 2, which never repeats; here it runs along x. */
static double ripple(const struct collard *w, const struct vertex *v, double t)
{
    double u = w->frequency * v->x + t;
    return w->amplitude * (sin(2 * u) + sin(M_PI * u)) / 2;
}

typedef double wave_function(const struct collard *w, const struct vertex *v, double t);
static wave_function *const wave_functions[] = {preset_1, preset_2, preset_3, preset_4, radial, ripple};

static struct water_shape shape(const struct water_setup *setup)
{
    return (struct water_shape){.side = ((const struct collard *)setup->params)->cells + 1};
}

/* Height in metres at vertex (column, row). */
static double height_at(const struct water_setup *setup, double time, int column, int row)
{
    const struct collard *w = setup->params;
    double spacing = setup->size / w->cells / w->space_unit, half = setup->size / 2 / w->space_unit;
    double x = column * spacing - half, z = row * spacing - half;
    struct vertex v = {x, z, hypot(x, z), mesh_index(column, row, w->cells)};
    return wave_functions[w->wave](w, &v, time / w->time_unit) * w->space_unit;
}

static void evaluate(void *state, const struct water_setup *setup, double time, struct surface *surface)
{
    (void)state;
#pragma omp parallel for
    for (int j = 0; j < surface->rows; j++)
        for (int i = 0; i < surface->columns; i++)
            surface->texels[((size_t)j * (size_t)surface->columns + (size_t)i) * 3] =
                (float)height_at(setup, time, i, j);
    surface_slopes_from_faces(surface);
}

/* The model lives on its vertices: between them the surface is the mesh's triangles. */
static void sample_point(const struct water_setup *setup, double time, double x, double z, double out[3])
{
    const struct collard *w = setup->params;
    double u = (x / setup->size + 0.5) * w->cells, v = (z / setup->size + 0.5) * w->cells;
    int i = (int)fmin(fmax(floor(u), 0), w->cells - 1), j = (int)fmin(fmax(floor(v), 0), w->cells - 1);
    bool second = u - i + (v - j) > 1;
    double right = height_at(setup, time, i + 1, j), below = height_at(setup, time, i, j + 1);
    double corner = height_at(setup, time, i + second, j + second);
    double per_spacing = w->cells / setup->size;
    out[1] = (second ? corner - below : right - corner) * per_spacing;
    out[2] = (second ? corner - right : below - corner) * per_spacing;
    double from_x = (u - i - second) / per_spacing, from_z = (v - j - second) / per_spacing;
    out[0] = corner + out[1] * from_x + out[2] * from_z;
}

static void sample(const void *state, const struct water_setup *setup, double time, struct water_points *points)
{
    (void)state;
    for (int i = 0; i < points->count; i++) {
        double out[3];
        sample_point(setup, time, points->x[i], points->z[i], out);
        points->height[i] = out[0];
        points->slope_x[i] = out[1];
        points->slope_z[i] = out[2];
    }
}

const struct water_model water_collard = {
    .name = "collard",
    .summary = "the wave presets of the 2022 paper on a plane of 160 × 160 cells, normals from its triangles",
    .source = "Collard & Mundi 2022",
    .params = params,
    .params_size = sizeof(struct collard),
    .shape = shape,
    .evaluate = evaluate,
    .sample = sample,
};
