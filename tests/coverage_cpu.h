/* tests/coverage_cpu.h: the technique `coverage` on the CPU, called with surfaces made by hand. */
#ifndef TESTS_COVERAGE_CPU_H
#define TESTS_COVERAGE_CPU_H

#include "support.h"

#include "coverage.h"

#include "light/coverage.h"

extern const struct light_technique light_coverage;

#define SIZE 2.0 /* m */
#define SLICES_MAX 4

#define WAVES_MAX 6

/* A wave A cos(k · (x, z) + phase), whose points move sideways too: `choppy` is how far, in units of its height. */
struct plane_wave {
    int cycles[2];
    double amplitude, phase, choppy; /* m, radians */
};

struct fixture {
    struct support_log log;
    struct plane_wave waves[WAVES_MAX];
    int wave_count;
    struct surface surface; /* of these waves */
    struct optics_sun sun;
    struct water_medium medium;
    struct light_settings settings;
    struct coverage params;
    double receivers[SLICES_MAX];
    struct ray_window window; /* that maps show */
    struct light_map map;
    void *state;
};

static inline int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    support_log_start(&fixture->log);
    fixture->sun = (struct optics_sun){.elevation = 60, .azimuth = 30, .angular_radius = 0};
    fixture->medium = (struct water_medium){.ior = 1.333, .dispersion = 0, .absorption = {0.35, 0.07, 0.03}};
    fixture->settings.error = 1;
    fixture->receivers[0] = -1;
    fixture->window = (struct ray_window){-SIZE / 2, -SIZE / 2, SIZE};
    fixture->state = calloc(1, light_coverage.state_size);
    *state = fixture;
    return 0;
}

static inline int teardown(void **state)
{
    struct fixture *fixture = *state;
    int errors = fixture->log.errors;
    light_coverage.finish(fixture->state, NULL);
    light_map_finish(&fixture->map);
    surface_finish(&fixture->surface);
    free(fixture->state);
    free(fixture);
    return errors;
}

/* Slopes of a surface whose points move sideways: by the derivatives along the coordinates at rest. */
static inline void wave_vertex(const struct plane_wave *waves, int count, double x, double z, double out[5])
{
    double along[2] = {0}, moved[2][2] = {{1, 0}, {0, 1}};
    memset(out, 0, 5 * sizeof *out);
    for (int w = 0; w < count; w++) {
        double k[2] = {2 * M_PI * waves[w].cycles[0] / SIZE, 2 * M_PI * waves[w].cycles[1] / SIZE};
        double angle = k[0] * x + k[1] * z + waves[w].phase, length = fmax(hypot(k[0], k[1]), 1e-9);
        out[0] += waves[w].amplitude * cos(angle);
        for (int a = 0; a < 2; a++) {
            along[a] -= waves[w].amplitude * k[a] * sin(angle);
            out[3 + a] -= waves[w].choppy * waves[w].amplitude * k[a] / length * sin(angle);
            for (int b = 0; b < 2; b++)
                moved[a][b] -= waves[w].choppy * waves[w].amplitude * k[a] * k[b] / length * cos(angle);
        }
    }
    double determinant = moved[0][0] * moved[1][1] - moved[0][1] * moved[1][0];
    out[1] = (moved[1][1] * along[0] - moved[1][0] * along[1]) / determinant;
    out[2] = (moved[0][0] * along[1] - moved[0][1] * along[0]) / determinant;
}

static inline void make_waves(struct fixture *fixture, const struct plane_wave *waves, int count, int mesh,
                              bool periodic)
{
    struct surface *surface = &fixture->surface;
    bool choppy = false;
    assert_true(count <= WAVES_MAX);
    if (count > 0)
        memmove(fixture->waves, waves, (size_t)count * sizeof *waves);
    fixture->wave_count = count;
    for (int w = 0; w < count; w++)
        choppy = choppy || waves[w].choppy != 0;
    assert_true(surface_resize(surface, mesh, mesh, periodic, choppy, SIZE, &fixture->log.log));
    double spacing = surface_spacing(surface), vertex[5];
    for (int i = 0; i < mesh * mesh; i++) {
        wave_vertex(waves, count, i % mesh * spacing - SIZE / 2, i / mesh * spacing - SIZE / 2, vertex);
        for (int k = 0; k < 3; k++)
            surface->texels[3 * i + k] = (float)vertex[k];
        for (int k = 0; choppy && k < 2; k++)
            surface->shifts[2 * i + k] = (float)vertex[3 + k];
    }
}

/* Waves of up to `cycles` whole ones, of random heights: slopes are about `steepness`. */
static inline void make_random(struct fixture *fixture, uint64_t seed, int cycles, double steepness, int mesh,
                               bool periodic)
{
    struct plane_wave waves[6];
    for (int w = 0; w < 6; w++) {
        for (int a = 0; a < 2; a++)
            waves[w].cycles[a] = (int)(support_random(&seed) % (unsigned)(2 * cycles + 1)) - cycles;
        double length = hypot(waves[w].cycles[0], waves[w].cycles[1]);
        waves[w].amplitude = length > 0 ? steepness * support_random_unit(&seed) * SIZE / (2 * M_PI * length) : 0;
        waves[w].phase = 2 * M_PI * support_random_unit(&seed);
        waves[w].choppy = 0;
    }
    make_waves(fixture, waves, 6, mesh, periodic);
}

/* The waves at any point. Areas are not needed. */
static inline void sample_waves(const void *state, const struct water_setup *setup, double time,
                                struct water_points *points)
{
    (void)state;
    const struct fixture *fixture = setup->params;
    (void)time;
    for (int i = 0; i < points->count; i++) {
        double out[5];
        wave_vertex(fixture->waves, fixture->wave_count, points->x[i], points->z[i], out);
        points->height[i] = out[0];
        points->slope_x[i] = out[1];
        points->slope_z[i] = out[2];
    }
}

static inline struct water_shape wave_shape(const struct water_setup *setup)
{
    const struct fixture *fixture = setup->params;
    return (struct water_shape){.periodic = fixture->surface.periodic};
}

/* Traces the first `slices` receivers; every texel is finite and not negative. */
static inline void trace(struct fixture *fixture, int side, int slices)
{
    const struct water_model model = {.name = "waves", .shape = wave_shape, .sample = sample_waves};
    const struct water_setup setup = {.size = SIZE, .params = fixture};
    struct ray_window windows[LIGHT_SLICES_MAX];
    for (int k = 0; k < slices; k++)
        windows[k] = fixture->window;
    const struct light_input input = {
        .surface = &fixture->surface,
        .model = &model,
        .setup = &setup,
        .receivers = fixture->receivers,
        .slices = slices,
        .windows = windows,
        .sun = &fixture->sun,
        .medium = &fixture->medium,
        .settings = &fixture->settings,
        .params = &fixture->params,
        .log = &fixture->log.log,
    };
    assert_true(light_map_resize(&fixture->map, side, 3, slices, &fixture->log.log));
    memset(fixture->map.texels, 0xff, sizeof(float[3]) * (size_t)(side * side * slices)); /* NaN */
    assert_true(light_coverage.trace(fixture->state, &input, &fixture->map));
    for (int i = 0; i < side * side * slices * 3; i++)
        if (!(isfinite(fixture->map.texels[i]) && fixture->map.texels[i] >= 0))
            fail_msg("%g in texel %d of %d a side", (double)fixture->map.texels[i], i, side);
}

/* What tests/coverage.h needs to know to make one colour of the same map, for the middle of the sun. */
static inline struct coverage_case plain_case(const struct fixture *fixture, int slice, int color)
{
    struct coverage_case c = {
        .columns = fixture->surface.columns,
        .side = fixture->map.side,
        .periodic = fixture->surface.periodic,
        .size = fixture->surface.size,
        .receiver = fixture->receivers[slice],
        .ior = fixture->medium.ior + (color - 1) * fixture->medium.dispersion / 2,
        .absorption = fixture->medium.absorption[color],
        .surface = fixture->surface.texels,
        .shifts = fixture->surface.shifts,
        .balanced = true,
    };
    double e = fixture->sun.elevation * M_PI / 180, a = fixture->sun.azimuth * M_PI / 180;
    c.sun[0] = cos(e) * cos(a);
    c.sun[1] = sin(e);
    c.sun[2] = cos(e) * sin(a);
    return c;
}

static inline double *empty_map(int side)
{
    double *map = calloc((size_t)(side * side), sizeof *map);
    assert_non_null(map);
    return map;
}

/* RMS of the difference of a colour of the map from `wanted`, in units of the latter's own. */
static inline double error_of(const struct fixture *fixture, int slice, int color, const double *wanted)
{
    int side = fixture->map.side;
    const float *texels = light_map_slice(&fixture->map, slice);
    double errors = 0, squares = 0;
    for (int i = 0; i < side * side; i++) {
        errors += pow((double)texels[3 * i + color] - wanted[i], 2);
        squares += wanted[i] * wanted[i];
    }
    return sqrt(errors / squares);
}

/* The same against the plain sum. */
static inline double error_of_sum(const struct fixture *fixture, int slice, int color)
{
    double *wanted = empty_map(fixture->map.side);
    const struct coverage_case c = plain_case(fixture, slice, color);
    coverage_map(&c, 1, wanted);
    double error = error_of(fixture, slice, color, wanted);
    free(wanted);
    return error;
}

static inline double mean_of(const struct fixture *fixture, int slice, int color)
{
    int texels = fixture->map.side * fixture->map.side;
    double sum = 0;
    for (int i = 0; i < texels; i++)
        sum += (double)light_map_slice(&fixture->map, slice)[3 * i + color];
    return sum / texels;
}

/* A copy of the map's numbers; the caller frees it. */
static inline float *copy_of(const struct fixture *fixture)
{
    size_t bytes = sizeof(float[3]) * (size_t)(fixture->map.side * fixture->map.side * fixture->map.slices);
    float *copy = malloc(bytes);
    assert_non_null(copy);
    memcpy(copy, fixture->map.texels, bytes);
    return copy;
}

#endif
