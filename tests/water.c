/* What is true of every water model, and of the surface's normals between its vertices. */
#include "water.h"
#include "support.h"

#include "scene/scene.h"
#include "water/normal_map.h"

#include <math.h>

#define PICTURES "heights-%d.pfm" /* three of them, in the folder that the test runs in */

/* Settings that every model is held against; each line is one scene. */
static const char *const scenes[] = {
    "[water]\nmodel = sines\n[caustics]\nmesh = 24\n[wave.1]\ncycles = 3 1\namplitude = 0.02\n",
    "[scene]\nsize = 1\ndepth = 0.2\nloop = 3\n[water]\nmodel = sines\n[caustics]\nmesh = 33\n"
    "[wave.1]\ncycles = -2 5\namplitude = 0.01\nphase = 77\n[wave.2]\ncycles = 1 0\nperiod = 0.7\n"
    "[wave.9]\ncycles = 0 -7\namplitude = 0.002\nphase = -200\n",
    ("[scene]\nsize = 100\ndepth = 0\n[water]\nmodel = sines\n[caustics]\nmesh = 2\n"
     "[wave.64]\ncycles = 0 0\nphase = 30\n"),
    "[water]\nmodel = sines\n[caustics]\nmesh = 7\n",
    "[water]\nmodel = sines\n[caustics]\nmesh = 40\n[wave.1]\ncycles = 3 1\nsteepness = 0.4\n"
    "[wave.2]\ncycles = -2 5\namplitude = 0.02\nsteepness = 0.3\n[wave.3]\ncycles = 0 0\nsteepness = 1\n"
    "[wave.4]\ncycles = 1 7\namplitude = 0.004\n",
    "[water]\nmodel = collard\n[collard]\nwave = preset-1\n",
    "[water]\nmodel = collard\n[collard]\nwave = preset-2\namplitude = 0.02\nfrequency = 7\n",
    "[water]\nmodel = collard\n[collard]\nwave = preset-3\namplitude = 0.033\nfrequency = 8\ncells = 80\n",
    "[scene]\nsize = 8\n[water]\nmodel = collard\n[collard]\nwave = preset-4\namplitude = 0.2\nspace_unit = 2\n",
    "[scene]\nsize = 3\n[water]\nmodel = collard\n[collard]\nwave = radial\ncells = 2\ntime_unit = 0.5\n",
    "[water]\nmodel = collard\n[collard]\nwave = ripple\namplitude = 0.1\ncells = 31\n",
    "[water]\nmodel = fbm\n[caustics]\nmesh = 40\n",
    "[scene]\nsize = 9\nloop = 2\n[water]\nmodel = fbm\n[fbm]\nterms = 9\nscale = 0.1\n[caustics]\nmesh = 31\n",
    "[water]\nmodel = ocean\n[ocean]\nresolution = 64\ncascades = 1\n",
    "[water]\nmodel = ocean\n[ocean]\nresolution = 64\nchoppiness = 0.7\n",
    "[scene]\nsize = 12\ndepth = 4\nloop = 10\n[water]\nmodel = ocean\n[caustics]\nmesh = 45\n"
    "[ocean]\nspectrum = phillips\nresolution = 32\ncascades = 3\nwind_speed = 3\n",
    "[water]\nmodel = heightfield\n[caustics]\nmesh = 24\n[heightfield]\nfile = " PICTURES "\nscale = 0.1\nrate = 2\n",
    "[scene]\nloop = 7\n[water]\nmodel = heightfield\n[caustics]\nmesh = 37\n"
    "[heightfield]\nfile = " PICTURES "\noffset = -0.05\nperiodic = no\nfirst = 1\n",
    "[water]\nmodel = sum\n[caustics]\nmesh = 40\n[wave.1]\ncycles = 2 1\n[sum]\nfirst = sines\nsecond = ocean\n"
    "[ocean]\nresolution = 32\ncascades = 1\n",
    "[water]\nmodel = sum\n[sum]\nfirst = sines\nsecond = collard\n[caustics]\nmesh = 40\n[wave.1]\ncycles = 2 1\n",
    "[water]\nmodel = sum\n[sum]\nfirst = sines\nsecond = heightfield\n[heightfield]\nfile = " PICTURES
    "\nscale = 0.1\n[caustics]\n"
    "mesh = 32\n[wave.1]\ncycles = 2 1\nsteepness = 0.5\n[wave.2]\ncycles = -4 5\nsteepness = 0.2\n",
    "[water]\nmodel = ripples\n[ripples]\nside = 24\n",
    "[scene]\nsize = 2\ndepth = 0.5\n[water]\nmodel = ripples\n[ripples]\nside = 33\nspeed = depth\nrain = 20\n"
    "[sphere]\nradius = 0.25\nposition = -0.4 0.3 0.2\ngravity = on\n",
};
enum { SCENES = sizeof scenes / sizeof *scenes };

static void fill(struct water *water, const char *text, double time)
{
    *water = (struct water){.scene = support_scene(text, NULL)};
    water_move(water, time);
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
            water_finish(&water);
        }
    }
    for (int i = 0; water_models[i]; i++)
        assert_true(met[i]); /* a new model needs a scene above */
}

static const float *vertex(const struct surface *surface, int i, int j)
{
    return surface->texels + ((size_t)j * (size_t)surface->columns + (size_t)i) * 3;
}

static struct water_point sample(const struct water *water, double x, double z)
{
    return sample_point(water->model, &water->setup, water->time, x, z);
}

/* The largest height, slope and shift: what tolerances are counted in. */
static void largest(const struct water *water, double of[3])
{
    of[0] = of[1] = of[2] = 0;
    for (int i = 0; i < water->surface.columns * water->surface.rows; i++) {
        const float *texel = water->surface.texels + (size_t)i * 3;
        of[0] = fmax(of[0], fabs((double)texel[0]));
        of[1] = fmax(of[1], hypot((double)texel[1], (double)texel[2]));
        for (int c = 0; c < 2 && water->surface.shifts; c++)
            of[2] = fmax(of[2], fabs((double)water->surface.shifts[i * 2 + c]));
    }
}

static void check_vertex(const struct water *water, int i, int j, const double scale[3])
{
    const struct surface *surface = &water->surface;
    const float *texel = vertex(surface, i, j);
    double spacing = surface_spacing(surface), half = water->setup.size / 2;
    struct water_point exact = sample(water, i * spacing - half, j * spacing - half);
    assert_true(isfinite(texel[0]) && isfinite(texel[1]) && isfinite(texel[2]));
    /* single precision, a rounding for each of a few waves */
    assert_true(fabs((double)texel[0] - exact.height) <= 5e-7 * scale[0] + 1e-30);
    for (int c = 0; c < 2 && surface->periodic; c++)
        assert_true(fabs((double)texel[1 + c] - exact.slope[c]) <= 5e-7 * scale[1] + 1e-30);
    for (int c = 0; c < 2; c++) {
        double shift = surface->shifts ? (double)surface->shifts[(j * surface->columns + i) * 2 + c] : 0;
        assert_true(fabs(shift - exact.shift[c]) <= 5e-7 * scale[2]);
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
    assert_int_equal(surface->shifts != NULL, shape.choppy);
    double spacing = water->setup.size / (surface->periodic ? vertices : vertices - 1), scale[3];
    assert_true(fabs(surface_spacing(surface) - spacing) < 1e-12 * spacing);
    largest(water, scale);
    for (int j = 0; j < vertices; j += 1 + vertices / 9)
        for (int i = 0; i < vertices; i++)
            check_vertex(water, i, j, scale);
}

static void vertices_hold_what_the_model_has_there(void **state)
{
    (void)state;
    every_water(check_vertices);
}

/* One axis of the plane at rest: a step along it moves a point by `along`, and up by the slopes where it is now. */
static double check_step(const struct water *water, double x, double z, int axis, double steepest, double along[2])
{
    double step = 1e-5 * surface_spacing(&water->surface);
    double step_x = axis == 0 ? step : 0, step_z = axis == 1 ? step : 0;
    struct water_point here = sample(water, x, z), before = sample(water, x - step_x, z - step_z);
    struct water_point after = sample(water, x + step_x, z + step_z);
    for (int c = 0; c < 2; c++)
        along[c] = (c == axis) + (after.shift[c] - before.shift[c]) / (2 * step);
    double rise = (after.height - before.height) / (2 * step);
    assert_true(fabs(rise - here.slope[0] * along[0] - here.slope[1] * along[1]) <= 1e-6 * steepest + 1e-9);
    return here.area;
}

/* At points inside triangles, so that a surface of triangles has a slope there as well. */
static void check_slopes(struct water *water)
{
    double spacing = surface_spacing(&water->surface), scale[3];
    largest(water, scale);
    for (int i = 0; i < 300; i++) {
        double part = i % 2 ? 1.0 / 3 : 2.0 / 3, along[2][2];
        double x = ((i * 7) % (water->surface.columns - 1) + part) * spacing - water->setup.size / 2;
        double z = ((i * 5) % (water->surface.rows - 1) + part) * spacing - water->setup.size / 2;
        double area = check_step(water, x, z, 0, scale[1], along[0]);
        check_step(water, x, z, 1, scale[1], along[1]);
        assert_true(fabs(area - (along[0][0] * along[1][1] - along[0][1] * along[1][0])) <= 1e-6);
    }
}

static void slopes_are_those_of_the_heights(void **state)
{
    (void)state;
    every_water(check_slopes);
}

static void check_repeats(struct water *water)
{
    double size = water->setup.size, scale[3];
    largest(water, scale);
    for (int i = 0; i < 50 && water->surface.periodic; i++) {
        double x = i * 0.31 * size - 7 * size, z = i * 0.17 * size;
        struct water_point here = sample(water, x, z);
        struct water_point there = sample(water, x + (i % 3 + 1) * size, z - i % 4 * size);
        assert_true(fabs(here.height - there.height) <= 1e-9 * scale[0] + 1e-30);
        for (int c = 0; c < 2; c++) {
            assert_true(fabs(here.slope[c] - there.slope[c]) <= 1e-9 * scale[1] + 1e-30);
            assert_true(fabs(here.shift[c] - there.shift[c]) <= 1e-9 * scale[2]);
        }
    }
    struct surface again = {0};
    assert_true(water_evaluate(water->model, &water->setup, water->time, &again, NULL));
    assert_memory_equal(again.texels, water->surface.texels,
                        (size_t)again.columns * (size_t)again.rows * 3 * sizeof(float));
    if (again.shifts)
        assert_memory_equal(again.shifts, water->surface.shifts,
                            (size_t)again.columns * (size_t)again.rows * 2 * sizeof(float));
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

/* Bumps that join at the edges, and move. */
static int write_pictures(void **state)
{
    static char folder[64];
    *state = folder;
    support_folder_make(folder);
    assert_int_equal(chdir(folder), 0);
    for (int frame = 0; frame < 3; frame++) {
        char name[32];
        struct dpl_image *image = dpl_image_create(24, 24, NULL);
        for (int i = 0; i < 24 * 24; i++)
            image->pixels[i * 3] =
                (float)(0.5 + 0.3 * sin(2 * M_PI * (i % 24) / 24 - frame) * cos(M_PI * (i / 24) / 6));
        snprintf(name, sizeof name, "heights-%d.pfm", frame);
        assert_true(dpl_image_save(image, name, NULL, NULL));
        dpl_image_destroy(image);
    }
    return 0;
}

static int remove_pictures(void **state)
{
    return support_folder_count(*state, true) == 3 ? 0 : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vertices_hold_what_the_model_has_there),
        cmocka_unit_test(slopes_are_those_of_the_heights),
        cmocka_unit_test(water_repeats_beyond_the_tile_and_from_run_to_run),
        cmocka_unit_test(normals_between_vertices_are_blended_over_triangles),
    };
    return cmocka_run_group_tests(tests, write_pictures, remove_pictures);
}
