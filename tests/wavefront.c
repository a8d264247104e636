/* The technique `wavefront` on the CPU, and the triangles that it draws. */
#include "support.h"

#include "wavefront.h"

#include "light/triangles.h"
#include "light/wavefront.h"
#include "optics/refraction.h"

extern const struct light_technique light_wavefront;

#define SIZE 2.0 /* m */

struct fixture {
    struct support_log log;
    struct surface surface;
    struct optics_sun sun;
    struct water_medium medium;
    struct wavefront params;
    struct ray_window window;
    double receiver;
    struct light_map map;
    void *state;
};

static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    support_log_start(&fixture->log);
    fixture->sun = (struct optics_sun){.elevation = 60, .azimuth = 30, .angular_radius = 0};
    fixture->medium = (struct water_medium){.ior = 1.333, .dispersion = 0, .absorption = {0.35, 0.07, 0.03}};
    fixture->window = (struct ray_window){-SIZE / 2, -SIZE / 2, SIZE};
    fixture->receiver = -1;
    param_defaults(light_wavefront.params, &fixture->params);
    fixture->state = calloc(1, light_wavefront.state_size);
    *state = fixture;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *fixture = *state;
    int errors = fixture->log.errors;
    light_wavefront.finish(fixture->state, NULL);
    light_map_finish(&fixture->map);
    surface_finish(&fixture->surface);
    free(fixture->state);
    free(fixture);
    return errors;
}

static void trace(struct fixture *fixture, int side)
{
    const struct water_setup water = {.size = SIZE};
    const struct light_input input = {
        .surface = &fixture->surface,
        .setup = &water,
        .receivers = &fixture->receiver,
        .slices = 1,
        .windows = &fixture->window,
        .sun = &fixture->sun,
        .medium = &fixture->medium,
        .params = &fixture->params,
        .log = &fixture->log.log,
    };
    assert_true(light_map_resize(&fixture->map, side, 3, 1, &fixture->log.log));
    assert_true(light_wavefront.trace(fixture->state, &input, &fixture->map));
}

/* Two crossing waves of that steepness, whose points move sideways too where they are choppy. */
static void make_waves(struct fixture *fixture, int columns, bool periodic, double steepness, bool choppy)
{
    struct surface *surface = &fixture->surface;
    assert_true(surface_resize(surface, columns, columns, periodic, choppy, SIZE, &fixture->log.log));
    double spacing = surface_spacing(surface);
    for (int v = 0; v < columns * columns; v++) {
        double x = v % columns * spacing * M_PI, z = v / columns * spacing * M_PI; /* a wave is 2 m long */
        surface->texels[3 * v] = (float)(steepness / M_PI * (cos(x + z) / 2 + sin(2 * x - z) / 3));
        surface->texels[3 * v + 1] = (float)(steepness * (-sin(x + z) / 2 + cos(2 * x - z) * 2 / 3));
        surface->texels[3 * v + 2] = (float)(steepness * (-sin(x + z) / 2 - cos(2 * x - z) / 3));
        for (int k = 0; choppy && k < 2; k++)
            surface->shifts[2 * v + k] = (float)(steepness * 0.2 * sin(x + z + k));
    }
}

/* Every way to draw, at a place of the scene: bits of `k`. */
static void choose(struct wavefront *params, int k)
{
    params->area = k & 1 ? WAVEFRONT_LENGTHS : WAVEFRONT_DETERMINANT;
    params->folds = k & 2 ? WAVEFRONT_OVERWRITE : WAVEFRONT_ADD;
    params->weights = !(k & 4);
    params->most = k & 4 ? 64 : 3;
}

/* Without a texel left out or drawn twice, however the mesh lies. */
static void still_water_gives_one_everywhere(void **state)
{
    static const double receivers[] = {-1, -0.013, -7, 2}, elevations[] = {90, 60, 20};
    static const int meshes[] = {0, 1, 7, 61};
    struct fixture *fixture = *state;
    make_waves(fixture, 32, true, 0, false);
    for (int k = 0; k < 8 * 4 * 3 * 4; k++) {
        choose(&fixture->params, k % 8);
        fixture->receiver = receivers[k / 8 % 4];
        fixture->sun.elevation = elevations[k / 32 % 3];
        fixture->params.mesh = meshes[k / 96];
        trace(fixture, 33);
        for (int i = 0; i < 33 * 33 * 3; i++)
            assert_true(fabs((double)fixture->map.texels[i] - 1) < 1e-5);
    }
}

/* Of the error in the wanted map's, and the share of texels that are off by more than a thousandth: those whose centre
 * lies on an edge of a triangle, but for rounding. */
static void expect_plain(struct fixture *fixture, int side, double share)
{
    double sun[3], *wanted = calloc((size_t)(side * side), sizeof *wanted);
    int off = 0;
    optics_sun_direction(&fixture->sun, sun);
    struct wavefront_case c = {
        .water = {.columns = fixture->surface.columns,
                  .side = side,
                  .periodic = fixture->surface.periodic,
                  .size = SIZE,
                  .receiver = fixture->receiver,
                  .sun = {sun[0], sun[1], sun[2]},
                  .ior = 1.333,
                  .absorption = 0.35,
                  .surface = fixture->surface.texels,
                  .shifts = fixture->surface.shifts},
        .lengths = fixture->params.area == WAVEFRONT_LENGTHS,
        .overwrite = fixture->params.folds == WAVEFRONT_OVERWRITE,
        .unweighted = !fixture->params.weights,
        .most = fixture->params.most,
    };
    trace(fixture, side);
    wavefront_map(&c, wanted);
    for (int i = 0; i < side * side; i++)
        off += !(fabs((double)fixture->map.texels[3 * i] - wanted[i]) < 1e-3 * fmax(wanted[i], 1));
    if (off > share * side * side)
        fail_msg("%d of %d texels are off", off, side * side);
    free(wanted);
}

static void a_map_is_the_plain_sum(void **state)
{
    static const struct {
        int columns, side;
        bool periodic, choppy;
        double steepness, receiver, elevation;
    } cases[] = {
        {32, 50, true, false, 0.2, -1, 60}, {32, 50, true, false, 0.3, -4, 60}, {32, 50, false, false, 0.3, -2, 60},
        {80, 37, true, false, 0.3, -3, 25}, {32, 50, true, false, 0.1, 3, 50},  {24, 50, true, true, 0.3, -1, 60},
        {24, 50, false, true, 0.15, 2, 80}, {32, 50, true, false, 0.3, -2, 91},
    };
    struct fixture *fixture = *state;
    for (int k = 0; k < 8 * 8; k++) {
        int at = k / 8;
        choose(&fixture->params, k % 8);
        fixture->receiver = cases[at].receiver;
        fixture->sun.elevation = cases[at].elevation;
        make_waves(fixture, cases[at].columns, cases[at].periodic, cases[at].steepness, cases[at].choppy);
        expect_plain(fixture, cases[at].side, 2e-3);
    }
}

/* A mesh of its own has the surface's numbers where their vertices meet, and those in between elsewhere. */
static void a_mesh_of_its_own_lies_on_the_surface(void **state)
{
    struct fixture *fixture = *state;
    for (int bounded = 0; bounded < 2; bounded++) {
        struct surface fine = {0};
        make_waves(fixture, 64 + bounded, !bounded, 0.2, true);
        fixture->params.mesh = 0;
        fine = fixture->surface;
        fixture->surface = (struct surface){0};
        make_waves(fixture, 16 + bounded, !bounded, 0.2, true);
        trace(fixture, 40);
        float *wanted = malloc(sizeof(float) * 40 * 40 * 3);
        memcpy(wanted, fixture->map.texels, sizeof(float) * 40 * 40 * 3);
        surface_finish(&fixture->surface);
        fixture->surface = fine;
        fixture->params.mesh = 16;
        trace(fixture, 40);
        assert_memory_equal(wanted, fixture->map.texels, sizeof(float) * 40 * 40 * 3);
        free(wanted);
    }
}

/* Slopes that grow linearly along x and z, and are small, throw (x, z) to M (x, z), M = 1 + (1 - 1/ior) depth × slopes'
 * growth: light is 1/|det M|, by lengths the product of those of the columns of M's inverse. */
static void linear_slopes_have_a_closed_form(void **state)
{
    static const double growths[][4] = {{0, 1, 0, 0}, {0, 0, 2, 0}, {0.5, 0, 0, -0.4}, {0.3, 1, -1, 0.1}};
    struct fixture *fixture = *state;
    const double steep = 0.004, depth = 1 / (steep * (1 - 1 / 1.333)); /* so that M = 1 + growth */
    fixture->sun.elevation = 90;
    fixture->receiver = -depth;
    fixture->params.weights = false;
    for (int k = 0; k < 4; k++) {
        const double *g = growths[k], m[4] = {1 + g[0], g[1], g[2], 1 + g[3]};
        double determinant = fabs(m[0] * m[3] - m[1] * m[2]);
        double lengths = hypot(m[3], m[2]) * hypot(m[1], m[0]) / (determinant * determinant);
        make_waves(fixture, 17, false, 0, false);
        for (int v = 0; v < 17 * 17; v++) {
            double x = v % 17 / 8.0 - 1, z = v / 17 / 8.0 - 1;
            fixture->surface.texels[3 * v + 1] = (float)(steep * (g[0] * x + g[1] * z));
            fixture->surface.texels[3 * v + 2] = (float)(steep * (g[2] * x + g[3] * z));
        }
        for (int area = 0; area < 2; area++) {
            fixture->params.area = area;
            trace(fixture, 64);
            double light = (double)fixture->map.texels[(32 * 64 + 32) * 3], corner = (double)fixture->map.texels[0];
            assert_true(fabs(light / (area ? lengths : 1 / determinant) - 1) < 1e-3);
            /* at x = z = -1 the image has light where what it came from lies on the surface */
            double from_x = (-m[3] + m[1]) / (m[0] * m[3] - m[1] * m[2]);
            double from_z = (m[2] - m[0]) / (m[0] * m[3] - m[1] * m[2]);
            double outside = fmax(fabs(from_x), fabs(from_z)) - 1;
            if (fabs(outside) > 0.05)
                assert_true(outside > 0 ? corner == 0 : fabs(corner / light - 1) < 1e-3);
        }
    }
}

/* Where x of the surface lands on the ceiling under a sun straight above a wave of that height: slope s turns light by
 * 2 atan s. */
static double ceiling_place(double x, double height, double ceiling)
{
    double slope = -height * M_PI * sin(M_PI * x);
    return x - 2 * slope / (1 - slope * slope) * (ceiling - height * cos(M_PI * x));
}

static void a_ceiling_has_the_light_of_a_plane_wave(void **state)
{
    const double height = 0.01, ceiling = 2.5; /* m: light does not cross */
    struct fixture *fixture = *state;
    struct surface *surface = &fixture->surface;
    make_waves(fixture, 512, true, 0, false); /* a triangle has one brightness */
    for (int v = 0; v < 512 * 512; v++) {
        double x = v % 512 / 256.0 - 1;
        surface->texels[3 * v] = (float)(height * cos(M_PI * x));
        surface->texels[3 * v + 1] = (float)(-height * M_PI * sin(M_PI * x));
    }
    fixture->sun.elevation = 90;
    fixture->receiver = ceiling;
    trace(fixture, 64);
    for (int i = 0; i < 64; i++) {
        double place = (i + 0.5) / 32 - 1, low = -1.5, high = 1.5, step = 1e-5;
        for (int k = 0; k < 50; k++) {
            double middle = (low + high) / 2;
            *(ceiling_place(middle, height, ceiling) < place ? &low : &high) = middle;
        }
        double stretch = ceiling_place(low + step, height, ceiling) - ceiling_place(low - step, height, ceiling);
        double slope = height * M_PI * sin(M_PI * low), cosine = 1 / sqrt(1 + slope * slope);
        double share = optics_fresnel_reflectance(cosine, 1.333) / optics_fresnel_reflectance(1, 1.333);
        double wanted = share * 2 * step / stretch; /* the patch seen from the sun is that at rest */
        for (int j = 0; j < 64; j += 21)
            assert_true(fabs((double)fixture->map.texels[(j * 64 + i) * 3] / wanted - 1) < 5e-3);
    }
}

/* The mean of a sum of sheets is that of their rays' weights as far as texels' centres are a fair sample; the last
 * sheet alone has less. */
static void folds_add_up_or_hide_each_other(void **state)
{
    struct fixture *fixture = *state;
    double means[2];
    make_waves(fixture, 128, true, 0.3, false);
    fixture->receiver = -4;
    for (int folds = 0; folds < 2; folds++) {
        double sum = 0;
        fixture->params.folds = folds;
        trace(fixture, 256);
        for (int i = 0; i < 256 * 256; i++)
            sum += (double)fixture->map.texels[3 * i + 2];
        means[folds] = sum / (256 * 256);
    }
    assert_true(fabs(means[0] - 1) < 0.02);
    assert_true(means[1] < 0.8 * means[0]);
}

/* A mesh whose corners lie on centres of texels, and one of random corners: every texel belongs to one triangle. */
static void triangles_that_share_edges_share_no_texel(void **state)
{
    enum { SIDE = 24, CELLS = 6 };
    static float texels[SIDE * SIDE * 3];
    struct triangle_corner corners[CELLS + 1][CELLS + 1];
    uint64_t random = 5;
    (void)state;
    for (int run = 0; run < 200; run++) {
        double grain = run % 2 ? 2 : 1e6;
        memset(texels, 0, sizeof texels);
        for (int j = 0; j <= CELLS; j++) {
            for (int i = 0; i <= CELLS; i++) {
                struct triangle_corner *corner = corners[j] + i;
                *corner = corners[j % CELLS][i % CELLS];
                corner->x += i / CELLS * SIDE; /* the repeated edge */
                corner->z += j / CELLS * SIDE;
                if (i == CELLS || j == CELLS)
                    continue;
                corner->x = round((i * 4 + run - 90 + 1.9 * support_random_unit(&random)) * grain) / grain;
                corner->z = round((j * 4 - run + 1.9 * support_random_unit(&random)) * grain) / grain;
                for (int c = 0; c < 3; c++)
                    corner->light[c] = 1;
            }
        }
        for (int first = 0; first < SIDE; first += 7) {
            struct triangle_band band = {texels, SIDE, first, first + 7 < SIDE ? first + 7 : SIDE, true, false};
            for (int k = 0; k < CELLS * CELLS; k++) {
                const struct triangle_corner *row = corners[k / CELLS] + k % CELLS, *next = row + CELLS + 1;
                triangle_draw(&band, (struct triangle_corner[3]){row[0], row[1], next[0]});
                triangle_draw(&band, (struct triangle_corner[3]){row[1], next[1], next[0]});
            }
        }
        for (int i = 0; i < SIDE * SIDE * 3; i++)
            assert_true(fabs((double)texels[i] - 1) < 1e-6);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(still_water_gives_one_everywhere, setup, teardown),
        cmocka_unit_test_setup_teardown(a_map_is_the_plain_sum, setup, teardown),
        cmocka_unit_test_setup_teardown(a_mesh_of_its_own_lies_on_the_surface, setup, teardown),
        cmocka_unit_test_setup_teardown(linear_slopes_have_a_closed_form, setup, teardown),
        cmocka_unit_test_setup_teardown(a_ceiling_has_the_light_of_a_plane_wave, setup, teardown),
        cmocka_unit_test_setup_teardown(folds_add_up_or_hide_each_other, setup, teardown),
        cmocka_unit_test(triangles_that_share_edges_share_no_texel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
