/* What is true of every water model, and of the surface's normals between its vertices. */
#include "water.h"
#include "support.h"

#include "scene/scene.h"
#include "water/normal_map.h"

#include <math.h>

/* Settings that every model is held against; each line is one scene. */
static const char *const scenes[] = {
    "[water]\nmodel = sines\n[caustics]\nmesh = 24\n[wave.1]\ncycles = 3 1\namplitude = 0.02\n",
    "[scene]\nsize = 1\ndepth = 0.2\nloop = 3\n[water]\nmodel = sines\n[caustics]\nmesh = 33\n"
    "[wave.1]\ncycles = -2 5\namplitude = 0.01\nphase = 77\n[wave.2]\ncycles = 1 0\nperiod = 0.7\n"
    "[wave.9]\ncycles = 0 -7\namplitude = 0.002\nphase = -200\n",
    ("[scene]\nsize = 100\ndepth = 0\n[water]\nmodel = sines\n[caustics]\nmesh = 2\n"
     "[wave.64]\ncycles = 0 0\nphase = 30\n"),
    "[water]\nmodel = sines\n[caustics]\nmesh = 7\n",
    "[water]\nmodel = collard\n[collard]\nwave = preset-1\n",
    "[water]\nmodel = collard\n[collard]\nwave = preset-2\namplitude = 0.02\nfrequency = 7\n",
    "[water]\nmodel = collard\n[collard]\nwave = preset-3\namplitude = 0.033\nfrequency = 8\ncells = 80\n",
    "[scene]\nsize = 8\n[water]\nmodel = collard\n[collard]\nwave = preset-4\namplitude = 0.2\nspace_unit = 2\n",
    "[scene]\nsize = 3\n[water]\nmodel = collard\n[collard]\nwave = radial\ncells = 2\ntime_unit = 0.5\n",
    "[water]\nmodel = collard\n[collard]\nwave = ripple\namplitude = 0.1\ncells = 31\n",
    "[water]\nmodel = fbm\n[caustics]\nmesh = 40\n",
    "[scene]\nsize = 9\nloop = 2\n[water]\nmodel = fbm\n[fbm]\nterms = 9\nscale = 0.1\n[caustics]\nmesh = 31\n",
};
enum { SCENES = sizeof scenes / sizeof *scenes };

/* A scene, its water at one time, and what its model was asked. */
struct water {
    struct dpl_scene *scene;
    const struct water_model *model;
    struct wave waves[WATER_WAVES_MAX];
    struct water_setup setup;
    struct water_memory memory;
    struct surface surface;
    double time;
};

static void fill(struct water *water, const char *text, double time)
{
    *water = (struct water){.scene = support_scene(text, NULL), .time = time};
    water->model = water_models[water->scene->medium.model];
    water->setup = scene_water_setup(water->scene, water->waves);
    water->setup.memory = &water->memory;
    assert_true(water_prepare(water->model, &water->setup, time, NULL));
    assert_true(water_evaluate(water->model, &water->setup, time, &water->surface, NULL));
}

static void finish(struct water *water)
{
    surface_finish(&water->surface);
    water_memory_finish(&water->memory, NULL);
    dpl_scene_destroy(water->scene);
}

static void every_water(void (*check)(struct water *water))
{
    static const double times[] = {0, 1.3, 250};
    bool met[WATER_MODELS_MAX] = {false};
    for (int i = 0; i < SCENES; i++) {
        for (int k = 0; k < 3; k++) {
            struct water water;
            fill(&water, scenes[i], times[k]);
            met[water.scene->medium.model] = true;
            check(&water);
            finish(&water);
        }
    }
    for (int i = 0; water_models[i]; i++)
        assert_true(met[i]); /* a new model needs a scene above */
}

static const float *vertex(const struct surface *surface, int i, int j)
{
    return surface->texels + ((size_t)j * (size_t)surface->columns + (size_t)i) * 3;
}

static void sample(const struct water *water, double x, double z, double out[3])
{
    sample_water(water->model, &water->setup, water->time, x, z, out);
}

/* The largest height and slope: what tolerances are counted in. */
static void largest(const struct water *water, double of[2])
{
    of[0] = of[1] = 0;
    for (int i = 0; i < water->surface.columns * water->surface.rows; i++) {
        const float *texel = water->surface.texels + (size_t)i * 3;
        of[0] = fmax(of[0], fabs((double)texel[0]));
        of[1] = fmax(of[1], hypot((double)texel[1], (double)texel[2]));
    }
}

static void check_vertices(struct water *water)
{
    const struct surface *surface = &water->surface;
    struct water_shape shape = water->model->shape(&water->setup);
    int vertices = shape.side;
    assert_int_equal(surface->columns, vertices);
    assert_int_equal(surface->rows, vertices);
    assert_int_equal(surface->periodic, shape.periodic);
    double spacing = water->setup.size / (surface->periodic ? vertices : vertices - 1), scale[2];
    assert_true(fabs(surface_spacing(surface) - spacing) < 1e-12 * spacing);
    largest(water, scale);
    for (int j = 0; j < vertices; j += 1 + vertices / 9) {
        for (int i = 0; i < vertices; i++) {
            const float *texel = vertex(surface, i, j);
            double exact[3];
            sample(water, i * spacing - water->setup.size / 2, j * spacing - water->setup.size / 2, exact);
            assert_true(isfinite(texel[0]) && isfinite(texel[1]) && isfinite(texel[2]));
            /* single precision, a rounding for each of a few waves */
            assert_true(fabs((double)texel[0] - exact[0]) <= 5e-7 * scale[0] + 1e-30);
            for (int c = 1; c < 3 && surface->periodic; c++)
                assert_true(fabs((double)texel[c] - exact[c]) <= 5e-7 * scale[1] + 1e-30);
        }
    }
}

static void vertices_hold_what_the_model_has_there(void **state)
{
    (void)state;
    every_water(check_vertices);
}

/* At points inside triangles, so that a surface of triangles has a slope there as well. */
static void check_slopes(struct water *water)
{
    double spacing = surface_spacing(&water->surface), step = 1e-5 * spacing, scale[2];
    largest(water, scale);
    for (int i = 0; i < 300; i++) {
        double part = i % 2 ? 1.0 / 3 : 2.0 / 3;
        double x = ((i * 7) % (water->surface.columns - 1) + part) * spacing - water->setup.size / 2;
        double z = ((i * 5) % (water->surface.rows - 1) + part) * spacing - water->setup.size / 2;
        double here[3], before[3], after[3];
        sample(water, x, z, here);
        sample(water, x - step, z, before);
        sample(water, x + step, z, after);
        assert_true(fabs((after[0] - before[0]) / (2 * step) - here[1]) <= 1e-6 * scale[1] + 1e-9);
        sample(water, x, z - step, before);
        sample(water, x, z + step, after);
        assert_true(fabs((after[0] - before[0]) / (2 * step) - here[2]) <= 1e-6 * scale[1] + 1e-9);
    }
}

static void slopes_are_those_of_the_heights(void **state)
{
    (void)state;
    every_water(check_slopes);
}

static void check_repeats(struct water *water)
{
    double size = water->setup.size, scale[2];
    largest(water, scale);
    for (int i = 0; i < 50 && water->surface.periodic; i++) {
        double x = i * 0.31 * size - 7 * size, z = i * 0.17 * size, here[3], there[3];
        sample(water, x, z, here);
        sample(water, x + (i % 3 + 1) * size, z - i % 4 * size, there);
        for (int c = 0; c < 3; c++)
            assert_true(fabs(here[c] - there[c]) <= 1e-9 * scale[c > 0] + 1e-30);
    }
    struct surface again = {0};
    assert_true(water_evaluate(water->model, &water->setup, water->time, &again, NULL));
    assert_memory_equal(again.texels, water->surface.texels,
                        (size_t)again.columns * (size_t)again.rows * 3 * sizeof(float));
    surface_finish(&again);
}

static void water_repeats_beyond_the_tile_and_from_run_to_run(void **state)
{
    (void)state;
    every_water(check_repeats);
}

/* The unit normal of a vertex, wrapped round where the surface is periodic. */
static void vertex_normal(const struct surface *surface, int i, int j, double normal[3])
{
    const float *texel = vertex(surface, i % surface->columns, j % surface->rows);
    double length = sqrt(1 + (double)texel[1] * (double)texel[1] + (double)texel[2] * (double)texel[2]);
    normal[0] = -(double)texel[1] / length;
    normal[1] = 1 / length;
    normal[2] = -(double)texel[2] / length;
}

/* Two triangles a cell, cut from (i + 1, j) to (i, j + 1); the normals of the three corners, each by its share. */
static void blended_normal(const struct surface *surface, double place_x, double place_z, double normal[3])
{
    int i = (int)place_x, j = (int)place_z;
    double u = place_x - i, v = place_z - j, corner[3], right[3], below[3], length = 0;
    bool far = u + v > 1;
    vertex_normal(surface, i + far, j + far, corner);
    vertex_normal(surface, i + 1, j, right);
    vertex_normal(surface, i, j + 1, below);
    for (int c = 0; c < 3; c++) {
        normal[c] = far ? corner[c] * (u + v - 1) + right[c] * (1 - v) + below[c] * (1 - u)
                        : corner[c] * (1 - u - v) + right[c] * u + below[c] * v;
        length += normal[c] * normal[c];
    }
    for (int c = 0; c < 3; c++)
        normal[c] /= sqrt(length);
}

static void check_normal_map(struct water *water)
{
    const struct surface *surface = &water->surface;
    int cells = surface->periodic ? surface->columns : surface->columns - 1;
    struct normal_map map = {0};
    for (int side = 1; side < 300; side = side * 3 + side % 2) {
        float *x = malloc((size_t)side * 3 * sizeof *x), *y = x + side, *z = y + side;
        assert_true(normal_map_begin(&map, surface, side, NULL));
        for (int j = 0; j < side; j += 1 + side / 20) {
            normal_map_row(&map, j, x, y, z);
            for (int i = 0; i < side; i++) {
                double wanted[3];
                blended_normal(surface, (i + 0.5) / side * cells, (j + 0.5) / side * cells, wanted);
                assert_true(fabs((double)x[i] - wanted[0]) < 2e-6);
                assert_true(fabs((double)y[i] - wanted[1]) < 2e-6);
                assert_true(fabs((double)z[i] - wanted[2]) < 2e-6);
            }
        }
        free(x);
    }
    normal_map_finish(&map);
}

static void normals_between_vertices_are_blended_over_triangles(void **state)
{
    (void)state;
    every_water(check_normal_map);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vertices_hold_what_the_model_has_there),
        cmocka_unit_test(slopes_are_those_of_the_heights),
        cmocka_unit_test(water_repeats_beyond_the_tile_and_from_run_to_run),
        cmocka_unit_test(normals_between_vertices_are_blended_over_triangles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
