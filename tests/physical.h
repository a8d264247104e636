/* tests/physical.h: what the tests of the physical look share: scenes under an even sky of known radiance, pictures in
 * linear light, and where a pixel looks.
 *
 * All expected values are worked out here from the laws of optics, not by the look's shaders; but for the
 * glow of murky water, which is held against the look's own sum (gpu_physical_water.c). */
#ifndef TESTS_PHYSICAL_H
#define TESTS_PHYSICAL_H

#include "support.h"

#include "optics/sky.h"
#include "scene/scene.h"

#define PHYSICAL_IOR 1.333
#define PHYSICAL_DEGREE (M_PI / 180)

struct physical_fixture {
    struct support_log log;
    struct dpl_gl *gl;
    struct dpl_renderer *renderer;
    char folder[64], dark[96], bright[96]; /* pictures of skies of radiance 0 and 1 */
};

static inline void physical_write_sky(const char *path, float radiance)
{
    struct dpl_image *image = dpl_image_create(8, 4, NULL);
    assert_non_null(image);
    for (int i = 0; i < 8 * 4 * 3; i++)
        image->pixels[i] = radiance;
    assert_true(dpl_image_save(image, path, NULL, NULL));
    dpl_image_destroy(image);
}

static inline void physical_start(struct physical_fixture *fixture, bool es)
{
    *fixture = (struct physical_fixture){0};
    const struct dpl_log *log = support_log_start(&fixture->log);
    fixture->gl = support_gl_of_floats(es, log);
    fixture->renderer = dpl_renderer_create(fixture->gl, DPL_DEVICE_AUTO, log);
    support_folder_make(fixture->folder);
    snprintf(fixture->dark, sizeof fixture->dark, "%s/dark.pfm", fixture->folder);
    snprintf(fixture->bright, sizeof fixture->bright, "%s/bright.pfm", fixture->folder);
    physical_write_sky(fixture->dark, 0);
    physical_write_sky(fixture->bright, 1);
}

static inline void physical_finish(struct physical_fixture *fixture)
{
    assert_int_equal(fixture->log.errors, 0);
    assert_int_equal(support_folder_count(fixture->folder, true), 2);
    dpl_renderer_destroy(fixture->renderer);
    dpl_gl_destroy(fixture->gl);
}

/* A scene of the look: flat water over a plain floor, under the sun alone. `text` is set after that, and may say
 * otherwise. The water neither absorbs nor scatters. */
static inline struct dpl_scene *physical_scene(struct physical_fixture *fixture, const char *text)
{
    static const char base[] =
        "[scene]\nsize = 4\ndepth = 1\n[water]\nmodel = sines\nabsorption = 0 0 0\nscattering = 0 0 0\nroughness = 0\n"
        "[sun]\nelevation = 90\nazimuth = 0\nangular_radius = 0.05\n[sky]\nmodel = environment\nground = 0 0 0\n"
        "[caustics]\nmap = 128\nerror = 5\n[floor]\ncolor = 0.2 0.2 0.2\ncontrast = 0\n[render]\nlook = "
        "physical\nquality = low\n";
    char whole[4096];
    assert_true(snprintf(whole, sizeof whole, "%s%s", base, text) < (int)sizeof whole);
    struct dpl_scene *scene = support_scene(whole, &fixture->log.log);
    support_set(scene, "sky.environment", "%s", fixture->dark);
    return scene;
}

/* An even sky of radiance 1 in place of the sun. */
static inline void physical_bright_sky(struct physical_fixture *fixture, struct dpl_scene *scene)
{
    support_set(scene, "sky.environment", "%s", fixture->bright);
    support_set(scene, "sky.sun", "0");
}

static inline void physical_look(struct dpl_scene *scene, const double eye[3], const double target[3], double view)
{
    support_set(scene, "camera.position", "%.17g %.17g %.17g", eye[0], eye[1], eye[2]);
    support_set(scene, "camera.target", "%.17g %.17g %.17g", target[0], target[1], target[2]);
    support_set(scene, "camera.field_of_view", "%.17g", view);
}

/* From just below the surface straight down on a square of the floor, `side` metres, whose middle is (x, z); a row is a
 * z, a column an x, both upwards. */
static inline void physical_look_down(struct dpl_scene *scene, double x, double z, double side)
{
    const double below = 0.02, way = scene->settings.depth - below;
    physical_look(scene, (const double[3]){x, -below, z}, (const double[3]){x, -1 - scene->settings.depth, z},
                  2 * atan(side / 2 / way) / PHYSICAL_DEGREE);
    support_set(scene, "camera.near_plane", "0.01");
}

/* The picture in linear light, all of whose values are numbers that light can have. */
static inline struct dpl_image *physical_radiance(struct physical_fixture *fixture, const struct dpl_scene *scene,
                                                  int width, int height)
{
    struct dpl_image *image = dpl_renderer_radiance(fixture->renderer, scene, 0, width, height);
    assert_non_null(image);
    for (int i = 0; i < width * height * 3; i++)
        if (!(image->pixels[i] >= 0 && isfinite(image->pixels[i])))
            fail_msg("value %d of the picture is %g", i, (double)image->pixels[i]);
    return image;
}

static inline double physical_pixel(const struct dpl_image *image, int column, int row, int channel)
{
    return (double)image->pixels[(row * image->width + column) * 3 + channel];
}

static inline double physical_mean(const struct dpl_image *image, int channel)
{
    double sum = 0;
    for (int i = 0; i < image->width * image->height; i++)
        sum += (double)image->pixels[i * 3 + channel];
    return sum / (image->width * image->height);
}

/* Standard deviation of the green, as a share of its mean. */
static inline double physical_contrast(const struct dpl_image *image)
{
    double mean = physical_mean(image, 1), square = 0;
    for (int i = 0; i < image->width * image->height; i++)
        square += pow((double)image->pixels[i * 3 + 1] - mean, 2);
    return sqrt(square / (image->width * image->height)) / fmax(mean, 1e-12);
}

static inline double physical_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void physical_normalize(double a[3])
{
    double length = sqrt(physical_dot(a, a));
    for (int c = 0; c < 3; c++)
        a[c] /= length;
}

static inline void physical_cross(const double a[3], const double b[3], double out[3])
{
    for (int c = 0; c < 3; c++)
        out[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
}

/* Ahead, to the right and up, unit vectors; up is -z in a picture that looks straight up or down. */
static inline void physical_axes(const struct dpl_scene *scene, double axes[3][3])
{
    double *ahead = axes[0], *right = axes[1], *up = axes[2];
    for (int c = 0; c < 3; c++)
        ahead[c] = scene->camera.target[c] - scene->camera.position[c];
    physical_normalize(ahead);
    bool steep = fabs(ahead[1]) > 0.9999;
    physical_cross(ahead, (const double[3]){0, !steep, -steep}, right);
    physical_normalize(right);
    physical_cross(right, ahead, up);
}

/* The unit vector along which a place of the picture, in pixels from its left upper corner, is seen. */
static inline void physical_ray(const struct dpl_scene *scene, const struct dpl_image *image, double x, double y,
                                double ray[3])
{
    double axes[3][3], high = tan(scene->camera.field_of_view / 2 * PHYSICAL_DEGREE);
    double across = (2 * x - image->width) / image->height * high, upwards = (1 - 2 * y / image->height) * high;
    physical_axes(scene, axes);
    for (int c = 0; c < 3; c++)
        ray[c] = axes[0][c] + across * axes[1][c] + upwards * axes[2][c];
    physical_normalize(ray);
}

/* The other way: the place of the picture where a point is seen straight. */
static inline void physical_place(const struct dpl_scene *scene, const struct dpl_image *image, const double point[3],
                                  double *x, double *y)
{
    double axes[3][3], away[3], high = tan(scene->camera.field_of_view / 2 * PHYSICAL_DEGREE);
    physical_axes(scene, axes);
    for (int c = 0; c < 3; c++)
        away[c] = point[c] - scene->camera.position[c];
    double ahead = physical_dot(away, axes[0]) * high;
    *x = (image->width + physical_dot(away, axes[1]) / ahead * image->height) / 2;
    *y = (1 - physical_dot(away, axes[2]) / ahead) * image->height / 2;
}

/* Degrees between two unit vectors. */
static inline double physical_angle(const double a[3], const double b[3])
{
    double across[3];
    physical_cross(a, b, across);
    return atan2(sqrt(physical_dot(across, across)), physical_dot(a, b)) / PHYSICAL_DEGREE;
}

/* Where light passes from one medium to another on its way between two points on opposite sides of a plane, in m along
 * the plane from the foot of the first: by Snell's law, whose two sides are brought together by halving. `before` and
 * `beyond` are the points' distances from the plane, `level` that of their feet; `index` that beyond to that before. */
static inline double physical_crossing(double before, double beyond, double level, double index)
{
    double low = 0, high = level;
    for (int i = 0; i < 60; i++) {
        double s = (low + high) / 2;
        bool beside = s / hypot(s, before) > index * (level - s) / hypot(level - s, beyond);
        *(beside ? &high : &low) = s;
    }
    return (low + high) / 2;
}

/* Where two pictures differ in green: the number of pixels, and their middle in pixels. */
struct physical_spot {
    int count;
    double x, y;
};

/* Fresnel's reflectance of unpolarised light, by the angles on both sides. */
static inline double physical_reflectance(double outside, double inside)
{
    if (outside < 1e-6)
        return pow((PHYSICAL_IOR - 1) / (PHYSICAL_IOR + 1), 2);
    double across = sin(outside - inside) / sin(outside + inside),
           along = tan(outside - inside) / tan(outside + inside);
    return (across * across + along * along) / 2;
}

/* The angle from the vertical that light has in the water. */
static inline double physical_inside(double outside)
{
    return asin(sin(outside) / PHYSICAL_IOR);
}

/* The sun's irradiance across its rays in the air. */
static inline void physical_sun(const struct dpl_scene *scene, double irradiance[3])
{
    struct optics_sky sky = {0};
    assert_true(optics_sky_make(&sky, &scene->sky, &scene->sun, NULL));
    memcpy(irradiance, sky.sun, sizeof sky.sun);
    optics_sky_finish(&sky);
}

/* The share of what a flat floor sends up evenly that flat water throws back onto it, after `thickness`, depth times
 * absorption: over all angles, by Fresnel's law, and all beyond the critical one. */
static inline double physical_thrown_back(double thickness)
{
    enum { STEPS = 2000 };
    double sum = 0;
    for (int i = 0; i < STEPS; i++) {
        double cosine = (i + 0.5) / STEPS, sine = PHYSICAL_IOR * sqrt(1 - cosine * cosine);
        double share = sine >= 1 ? 1 : physical_reflectance(asin(sine), acos(cosine));
        sum += 2 * cosine * share * exp(-2 * thickness / cosine) / STEPS;
    }
    return sum;
}

/* Radiance of the flat floor under flat water and the sun alone, without a way to the eye. */
static inline double physical_floor(const struct dpl_scene *scene, int channel)
{
    double sun[3], outside = (90 - scene->sun.elevation) * PHYSICAL_DEGREE, inside = physical_inside(outside);
    double absorption = scene->medium.absorption[channel], depth = scene->settings.depth;
    double color = scene->floor.color[channel];
    physical_sun(scene, sun);
    double straight = sun[channel] * cos(outside) * (1 - physical_reflectance(outside, inside)) *
                      exp(-absorption * depth / cos(inside));
    return color / M_PI * straight / (1 - color * physical_thrown_back(absorption * depth));
}

#endif
