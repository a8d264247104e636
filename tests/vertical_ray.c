/* vertex-ray and pixel-ray on the CPU: against the method written a second time, in angles and in double precision, and
 * against what tilted planes must give. */
#include "support.h"

#include "light/vertical_ray.h"

#include <math.h>

#define IOR 1.333
#define GRID 40

/* The picture of the sun has 256 texels, between which a bend of the brightness is cut. */
#define TOLERANCE (1.5 / 255)

static const double degree = M_PI / 180;
static const struct vertical_ray defaults = {.sun_width = 0.53, .halo = 10, .falloff = 2};

static const struct light_technique *find_technique(const char *name)
{
    int i = 0;
    while (strcmp(light_techniques[i]->name, name))
        i++;
    return light_techniques[i];
}

/* A map of one slice; the caller frees its texels. */
static struct light_map trace(const char *name, const struct vertical_ray *params, const struct surface *surface,
                              const struct ray_window *window, int side, const struct dpl_log *log)
{
    const struct light_technique *technique = find_technique(name);
    const struct water_setup setup = {.size = surface->size, .depth = 1};
    const struct water_medium medium = {.ior = IOR};
    const double receiver = -1;
    const struct light_input input = {.surface = surface,
                                      .setup = &setup,
                                      .receivers = &receiver,
                                      .slices = 1,
                                      .windows = window,
                                      .medium = &medium,
                                      .params = params,
                                      .log = log};
    struct light_map map = {0};
    void *state = calloc(1, technique->state_size);
    assert_true(light_map_resize(&map, side, 1, 1, NULL));
    if (!technique->trace(state, &input, &map))
        light_map_finish(&map);
    technique->finish(state, NULL);
    free(state);
    return map;
}

/* Brightness by the angle between a ray and the vertical. */
static double sun(const struct vertical_ray *p, double angle)
{
    double radius = p->sun_width / 2 * degree, end = radius * p->halo;
    return angle <= radius ? 1 : angle >= end ? 0 : pow((end - angle) / (end - radius), p->falloff);
}

/* Brightness above a slope: the ray comes to the surface at the slope's own angle. */
static double seen(const struct vertical_ray *p, double slope)
{
    double inside = atan(slope), sine = IOR * sin(inside);
    return sine > 1 ? 0 : sun(p, asin(sine) - inside);
}

static void plane(struct surface *surface, double slope_x, double slope_z)
{
    assert_true(surface_resize(surface, 9, 9, false, false, 4, NULL));
    for (int t = 0; t < 81; t++) {
        double x = t % 9 * 0.5 - 2, z = t / 9 * 0.5 - 2;
        surface->texels[t * 3] = (float)(slope_x * x + slope_z * z);
        surface->texels[t * 3 + 1] = (float)slope_x;
        surface->texels[t * 3 + 2] = (float)slope_z;
    }
}

/* Checks that the map of a plane, by either technique and either normals, is one value. */
static void expect_plane(const struct vertical_ray *from, double slope_x, double slope_z, double value)
{
    const struct ray_window tile = {-2, -2, 4};
    struct surface surface = {0};
    plane(&surface, slope_x, slope_z);
    for (int way = 0; way < 4; way++) {
        struct vertical_ray params = *from;
        params.normals = way & 1;
        params.mesh = way == 3 ? 13 : 0;
        struct light_map map = trace(way < 2 ? "pixel-ray" : "vertex-ray", &params, &surface, &tile, 20, NULL);
        for (int t = 0; t < 400; t++)
            if (!(fabs((double)map.texels[t] - value) <= TOLERANCE))
                fail_msg("slope %g %g, way %d: %.6f instead of %.6f", slope_x, slope_z, way, (double)map.texels[t],
                         value);
        light_map_finish(&map);
    }
    surface_finish(&surface);
}

static void planes_darken_by_the_angle(void **state)
{
    (void)state;
    expect_plane(&defaults, 0, 0, 1);
    double azimuth = 0;
    for (double slope = 0.01; slope < 1; slope *= 1.8, azimuth += 75)
        expect_plane(&defaults, slope * cos(azimuth * degree), slope * sin(azimuth * degree), seen(&defaults, slope));
    struct vertical_ray wide = {.sun_width = 10, .halo = 18, .falloff = 0.7}; /* all of the sky */
    for (double slope = 0.1; slope < 1.1; slope += 0.25)
        expect_plane(&wide, slope, 0, seen(&wide, slope));
    assert_true(seen(&wide, 1.1) > 0.3); /* not dark already */
}

/* A white picture of the sun shows where light leaves at all; a half black one, on which side it is seen. */
static void a_picture_is_seen_where_light_leaves(void **state)
{
    struct vertical_ray params = {.sun_width = 60, .halo = 3};
    struct dpl_image *image = dpl_image_create(64, 64, NULL);
    char folder[64];
    const double critical = tan(asin(1 / IOR));
    (void)state;
    support_folder_make(folder);
    snprintf(params.sun_map, sizeof params.sun_map, "%s/sun.png", folder);
    for (int i = 0; i < 64 * 64 * 3; i++)
        image->pixels[i] = 1;
    assert_true(dpl_image_save(image, params.sun_map, NULL, NULL));
    expect_plane(&params, 0, 0, 1);
    expect_plane(&params, 0, critical - 1e-3, 1);
    expect_plane(&params, critical + 1e-3, 0, 0);
    expect_plane(&params, 3, -40, 0);
    for (int i = 0; i < 64 * 64 * 3; i++)
        image->pixels[i] = i / 3 % 64 < 32 || i / 3 / 64 < 24; /* the left, and at the top what is above 22.5° */
    assert_true(dpl_image_save(image, params.sun_map, NULL, NULL));
    expect_plane(&params, -0.1, 0, 1); /* a slope down along x turns the ray towards -x, the picture's left */
    expect_plane(&params, 0.1, 0, 0);
    expect_plane(&params, 0.1, 1.1, 0);
    expect_plane(&params, 0.1, -1.1, 1); /* 33° towards -z */
    expect_plane(&params, 0.1, -0.5, 0); /* 10° */
    dpl_image_destroy(image);
    support_folder_count(folder, true);
}

static void a_picture_of_no_brightness_is_an_error(void **state)
{
    static const float values[] = {NAN, INFINITY, -1, 65505};
    static const char *const names[] = {"multi-sample", "pixel-ray", "vertex-ray"};
    struct dpl_image *image = dpl_image_create(8, 8, NULL);
    struct support_log log;
    char folder[64], path[96];
    (void)state;
    support_folder_make(folder);
    snprintf(path, sizeof path, "%s/sun.pfm", folder);
    for (int i = 0; i < 12; i++) {
        image->pixels[(2 * 8 + 2) * 3] = values[i % 4];
        assert_true(dpl_image_save(image, path, NULL, NULL));
        struct dpl_renderer *renderer = dpl_renderer_create(NULL, DPL_DEVICE_CPU, support_log_start(&log));
        struct dpl_scene *scene = support_scene("[caustics]\nmap = 8\nmesh = 8\n", &log.log);
        char key[32];
        snprintf(key, sizeof key, "%s.sun_map", names[i / 4]);
        support_set(scene, "caustics.technique", "%s", names[i / 4]);
        support_set(scene, key, "%s", path);
        assert_null(dpl_renderer_map(renderer, scene, 0));
        EXPECT_ERROR(&log, DPL_REASON_FILE_FORMAT, path, "column 2, row 2", "accepted: 0 to 65504");
        dpl_scene_destroy(scene);
        dpl_renderer_destroy(renderer);
    }
    dpl_image_destroy(image);
    support_folder_count(folder, true);
}

static void a_missing_picture_is_an_error(void **state)
{
    struct vertical_ray params = defaults;
    const struct ray_window tile = {-2, -2, 4};
    struct surface surface = {0};
    struct support_log log;
    (void)state;
    plane(&surface, 0, 0);
    strcpy(params.sun_map, "nowhere.png");
    assert_null(trace("pixel-ray", &params, &surface, &tile, 4, support_log_start(&log)).texels);
    EXPECT_ERROR(&log, DPL_REASON_FILE_READ, "nowhere.png");
    assert_null(trace("vertex-ray", &params, &surface, &tile, 4, &log.log).texels);
    EXPECT_ERROR(&log, DPL_REASON_FILE_READ, "nowhere.png");
    surface_finish(&surface);
}

/* Waves up to so steep that light is kept inside in places. */
static void waves(struct surface *surface, bool periodic, double amplitude)
{
    const double k = 2 * M_PI / 4;
    assert_true(surface_resize(surface, GRID, GRID, periodic, false, 4, NULL));
    for (int t = 0; t < GRID * GRID; t++) {
        double x = t % GRID * surface_spacing(surface) - 2, z = t / GRID * surface_spacing(surface) - 2;
        float *texel = surface->texels + t * 3;
        texel[0] = (float)(amplitude * (sin(2 * k * x + 1) * cos(k * z) + 0.3 * cos(5 * k * z + k * x)));
        texel[1] = (float)(amplitude * k * (2 * cos(2 * k * x + 1) * cos(k * z) - 0.3 * sin(5 * k * z + k * x)));
        texel[2] = (float)(amplitude * k * (-sin(2 * k * x + 1) * sin(k * z) - 1.5 * sin(5 * k * z + k * x)));
    }
}

/* A number of the surface's between its vertices. */
static double surface_at(const struct surface *surface, double x, double z, int channel)
{
    double place[2] = {(x + 2) / surface_spacing(surface), (z + 2) / surface_spacing(surface)}, sum = 0;
    int corner[2] = {(int)floor(place[0]), (int)floor(place[1])};
    for (int k = 0; k < 4; k++) {
        int i = corner[0] + k % 2, j = corner[1] + k / 2;
        double share = (1 - fabs(place[0] - i)) * (1 - fabs(place[1] - j));
        if (surface->periodic) {
            i = (i + 100 * GRID) % GRID;
            j = (j + 100 * GRID) % GRID;
        } else if (share == 0) {
            continue; /* past the edge */
        }
        sum += share * (double)surface->texels[(j * GRID + i) * 3 + channel];
    }
    return sum;
}

/* What is seen above a point of the water, with heights taken `apart`, 0 for the surface's own slopes. */
static double plain_ray(const struct vertical_ray *p, const struct surface *surface, double x, double z, double apart)
{
    const double end = surface->periodic ? INFINITY : 2;
    double left = fmax(x - apart, -end), right = fmin(x + apart, end);
    double near = fmax(z - apart, -end), far = fmin(z + apart, end);
    double slope_x = (surface_at(surface, right, z, 0) - surface_at(surface, left, z, 0)) / (right - left);
    double slope_z = (surface_at(surface, x, far, 0) - surface_at(surface, x, near, 0)) / (far - near);
    return apart > 0 ? seen(p, hypot(slope_x, slope_z))
                     : seen(p, hypot(surface_at(surface, x, z, 1), surface_at(surface, x, z, 2)));
}

/* The mesh at a point: three vertices of the triangle there. */
static double plain_mesh(const struct vertical_ray *p, const struct surface *surface, double x, double z)
{
    int vertices = p->mesh ? p->mesh : GRID, cells = surface->periodic ? vertices : vertices - 1;
    double step = 4.0 / cells, u = (x + 2) / step, v = (z + 2) / step, at[4];
    int i = (int)floor(u), j = (int)floor(v);
    for (int k = 0; k < 4; k++) {
        double vertex[2] = {(i + k % 2) * step - 2, (j + k / 2) * step - 2};
        at[k] = plain_ray(p, surface, vertex[0], vertex[1], step);
    }
    u -= i;
    v -= j;
    return u + v < 1 ? at[0] * (1 - u - v) + at[1] * u + at[2] * v
                     : at[3] * (u + v - 1) + at[1] * (1 - v) + at[2] * (1 - u);
}

static void expect_waves(bool mesh, const struct vertical_ray *p, const struct surface *surface,
                         const struct ray_window *window, int side)
{
    struct light_map map = trace(mesh ? "vertex-ray" : "pixel-ray", p, surface, window, side, NULL);
    double apart = p->normals == VERTICAL_SLOPES ? 0 : surface_spacing(surface), most = 0, least = 1, brightest = 0;
    for (int t = 0; t < side * side; t++) {
        double x = window->x + (t % side + 0.5) * window->side / side;
        double z = window->z + (t / side + 0.5) * window->side / side, value = (double)map.texels[t], wanted = 0;
        if (surface->periodic || (fabs(x) <= 2 && fabs(z) <= 2))
            wanted = mesh ? plain_mesh(p, surface, x, z) : plain_ray(p, surface, x, z, apart);
        most = fmax(most, fabs(value - wanted));
        least = fmin(least, value);
        brightest = fmax(brightest, value);
    }
    if (!(most <= TOLERANCE))
        fail_msg("%s, mesh %d, normals %d, periodic %d, map %d: off by %.5f", mesh ? "vertex-ray" : "pixel-ray",
                 p->mesh, p->normals, surface->periodic, side, most);
    assert_true(side < 40 || p->mesh == 2 || window->side != 4 || (least < 0.1 && brightest > 0.6));
    light_map_finish(&map);
}

static void waves_are_the_plain_method(void **state)
{
    static const struct ray_window windows[] = {{-2, -2, 4}, {0.31, -1.77, 1.3}, {-5.3, 1.2, 9}};
    static const int sides[] = {1, 2, 40, 67}, meshes[] = {0, 2, 23, 97};
    struct surface surface = {0};
    (void)state;
    for (int k = 0; k < 12; k++) {
        bool periodic = k % 2;
        const struct ray_window *window = windows + k % 3;
        waves(&surface, periodic, k % 5 == 4 ? 0.6 : 0.05);
        for (int way = 0; way < 4; way++) {
            struct vertical_ray params = defaults;
            params.mesh = meshes[way];
            expect_waves(true, &params, &surface, window, sides[k / 2 % 4]);
            params.normals = way % 2;
            expect_waves(false, &params, &surface, window, sides[k / 2 % 4]);
        }
    }
    surface_finish(&surface);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planes_darken_by_the_angle),    cmocka_unit_test(a_picture_is_seen_where_light_leaves),
        cmocka_unit_test(a_missing_picture_is_an_error), cmocka_unit_test(a_picture_of_no_brightness_is_an_error),
        cmocka_unit_test(waves_are_the_plain_method),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
