/* Single rays and the sun, against the laws in angles and the figures of textbooks. */
#include "support.h"

#include "optics/refraction.h"
#include "optics/sun.h"

#include <math.h>

static const double degree = M_PI / 180;

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void expect_near(double value, double wanted, double tolerance)
{
    if (!(fabs(value - wanted) <= tolerance))
        fail_msg("%.12g instead of %.12g", value, wanted);
}

/* Shares of unpolarised light thrown back by glass and by water, to four digits: 4 % and 2 % of what comes straight. */
static void fresnel_is_that_of_the_tables(void **state)
{
    static const double table[][3] = {/* index, degrees, reflectance */
                                      {1.5, 0, 0.0400},    {1.5, 30, 0.0415},  {1.5, 45, 0.0502},   {1.5, 60, 0.0892},
                                      {1.5, 80, 0.3877},   {1.333, 0, 0.0204}, {1.333, 40, 0.0245}, {1.333, 60, 0.0597},
                                      {1.333, 80, 0.3479}, {1, 50, 0},         {1.333, 90, 1}};
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        expect_near(optics_fresnel_reflectance(cos(table[i][1] * degree), table[i][0]), table[i][2], 6e-5);
}

/* In sines and tangents of the angles, as Fresnel wrote it. */
static void fresnel_is_that_of_the_angles(void **state)
{
    (void)state;
    for (double ior = 1.1; ior < 3; ior += 0.3) {
        for (double angle = 1; angle < 90; angle += 1) {
            double in = angle * degree, out = asin(sin(in) / ior);
            double across = sin(in - out) / sin(in + out), along = tan(in - out) / tan(in + out);
            expect_near(optics_fresnel_reflectance(cos(in), ior), (across * across + along * along) / 2, 1e-12);
        }
        /* at Brewster's angle, tan = index, only light across the plane is thrown back */
        double across = (ior * ior - 1) / (ior * ior + 1);
        expect_near(optics_fresnel_reflectance(cos(atan(ior)), ior), across * across / 2, 1e-12);
    }
    assert_true(isfinite(optics_fresnel_reflectance(0, 1)));
}

static void snell_is_that_of_the_tables(void **state)
{
    static const double table[][3] = {/* index, degrees outside, degrees inside */
                                      {1.333, 0, 0},      {1.333, 30, 22.03}, {1.333, 45, 32.04}, {1.333, 60, 40.52},
                                      {1.333, 90, 48.61}, {1.5, 30, 19.47},   {1.5, 60, 35.26},   {1, 70, 70}};
    static const double up[3] = {0, 1, 0};
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        double in = table[i][1] * degree, to_light[3] = {sin(in), cos(in), 0}, out[3];
        optics_refract(to_light, up, table[i][0], out);
        expect_near(atan2(-out[0], -out[1]) / degree, table[i][2], 0.006); /* light from +x goes on towards -x */
        expect_near(out[2], 0, 1e-15);
    }
}

/* Out of the medium: the same pairs of angles the other way; beyond the critical angle nothing leaves. */
static void light_leaves_as_it_came(void **state)
{
    static const double up[3] = {0, 1, 0};
    (void)state;
    for (double ior = 1; ior < 3; ior += 0.333) {
        double out[3], critical = asin(1 / ior);
        for (double angle = 0; angle < 90; angle += 0.5) {
            double in = asin(sin(angle * degree) / ior), ray[3] = {-sin(in), cos(in), 0}, back[3];
            assert_true(optics_refract_out(ray, up, ior, out));
            expect_near(atan2(-out[0], out[1]), angle * degree, 1e-7);
            optics_refract(out, up, ior, back);
            for (int c = 0; c < 3; c++)
                expect_near(back[c], -ray[c], 1e-12);
        }
        for (double angle = critical + 1e-6; angle < M_PI / 2; angle += 0.1)
            assert_false(optics_refract_out((const double[3]){sin(angle), cos(angle), 0}, up, ior, out));
    }
    expect_near(asin(1 / 1.333) / degree, 48.6, 0.01);
}

/* T = η E + (…) N with N against E, η the index before the surface over that behind it. */
static void foley(const double E[3], const double N[3], double eta, double root, double T[3])
{
    for (int c = 0; c < 3; c++)
        T[c] = eta * E[c] - (eta * dot(E, N) + root) * N[c];
}

/* How far a direction is from a unit vector at the angle of the law of sines. */
static double lawless(const double T[3], double sine)
{
    return fmax(fabs(sqrt(dot(T, T)) - 1), fabs(fabs(T[0]) / sqrt(dot(T, T)) - sine));
}

/* The vector form of Snell's law in Foley et al. 1996 and what is here are one, into the water and out of it. As a blog
 * prints it, with √(1 + η² ((E·N)² + 1)) and either sign of the root, it is not the law of sines. */
static void the_root_has_the_right_sign(void **state)
{
    static const double up[3] = {0, 1, 0}, down[3] = {0, -1, 0};
    (void)state;
    for (double angle = 5; angle < 48; angle += 1) {
        for (int leaves = 0; leaves < 2; leaves++) {
            double eta = leaves ? 1.333 : 1 / 1.333, cosine = cos(angle * degree), sine = sin(angle * degree);
            double E[3] = {sine, leaves ? cosine : -cosine, 0}, T[3], ours[3];
            const double *N = leaves ? down : up;
            if (leaves)
                assert_true(optics_refract_out(E, up, 1.333, ours));
            else
                optics_refract((const double[3]){-E[0], -E[1], 0}, up, 1.333, ours);
            foley(E, N, eta, sqrt(1 - eta * eta * (1 - cosine * cosine)), T);
            for (int c = 0; c < 3; c++)
                expect_near(ours[c], T[c], 1e-12);
            assert_true(lawless(ours, eta * sine) < 1e-12);
            for (int sign = -1; sign <= 1; sign += 2) {
                foley(E, N, eta, sign * sqrt(1 + eta * eta * (cosine * cosine + 1)), T);
                assert_true(lawless(T, eta * sine) > 0.02);
            }
        }
    }
}

static void random_direction(uint64_t *random, double out[3])
{
    double azimuth = 2 * M_PI * support_random_unit(random), y = 2 * support_random_unit(random) - 1;
    out[0] = sqrt(1 - y * y) * cos(azimuth);
    out[1] = y;
    out[2] = sqrt(1 - y * y) * sin(azimuth);
}

/* Any two directions: unit vectors in one plane with the normal, at the angles of Snell's law and of the mirror. */
static void rays_keep_to_their_plane(void **state)
{
    uint64_t random = 5;
    (void)state;
    for (int i = 0; i < 1000; i++) {
        double light[3], normal[3], into[3], back[3], ior = 1 + 2 * support_random_unit(&random);
        random_direction(&random, light);
        random_direction(&random, normal);
        double sign = dot(light, normal) < 0 ? -1 : 1, cosine = fabs(dot(light, normal));
        for (int c = 0; c < 3; c++)
            normal[c] *= sign;
        optics_refract(light, normal, ior, into);
        optics_reflect(light, normal, back);
        expect_near(dot(into, into), 1, 1e-12);
        expect_near(dot(back, back), 1, 1e-12);
        expect_near(dot(back, normal), cosine, 1e-12);
        double along_into[3] = {-into[0], -into[1], -into[2]}, outside[3];
        assert_true(optics_refract_out(along_into, normal, ior, outside));
        for (int c = 0; c < 3; c++)
            expect_near(outside[c], light[c], 1e-7);
        expect_near(-dot(into, normal), sqrt(1 - (1 - cosine * cosine) / (ior * ior)), 1e-12);
        for (int c = 0; c < 3; c++) {
            double along = light[c] - cosine * normal[c]; /* of the light, on the surface */
            expect_near(into[c] + dot(into, normal) * -normal[c], -along / ior, 1e-12);
            expect_near(back[c] - cosine * normal[c], -along, 1e-12);
        }
    }
}

static void absorption_is_a_share_for_each_metre(void **state)
{
    (void)state;
    expect_near(optics_transmittance(0.35, 2), 0.4965853, 1e-7);
    expect_near(optics_transmittance(log(2), 3), 0.125, 1e-12);
    expect_near(optics_transmittance(0, 1e9), 1, 0);
}

static void the_sun_stands_where_it_is_said(void **state)
{
    static const double table[][5] = {/* elevation, azimuth, x, y, z */
                                      {90, 123, 0, 1, 0},
                                      {30, 0, 0.8660254, 0.5, 0},
                                      {30, 90, 0, 0.5, 0.8660254},
                                      {60, 180, -0.5, 0.8660254, 0},
                                      {60, -90, 0, 0.8660254, -0.5},
                                      {1, 45, 0.7069991, 0.0174524, 0.7069991}};
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        struct optics_sun sun = {.elevation = table[i][0], .azimuth = table[i][1], .angular_radius = 0.2665};
        double out[3];
        optics_sun_direction(&sun, out);
        for (int c = 0; c < 3; c++)
            expect_near(out[c], table[i][2 + c], 1e-7);
    }
}

/* A disc of even irradiance: mean at the middle, variance radius²/4 both ways, edge at the angular radius. */
static void the_disc_is_round_and_even(void **state)
{
    const struct optics_sun sun = {.elevation = 37, .azimuth = 200, .angular_radius = 5};
    const struct optics_disc disc = optics_sun_disc(&sun);
    const double radius = sin(5 * degree);
    double sum[3] = {0}, across = 0, up = 0;
    int count = 0;
    (void)state;
    for (double a = -0.995; a < 1; a += 0.01) {
        for (double b = -0.995; b < 1; b += 0.01) {
            double out[3];
            if (a * a + b * b > 1)
                continue;
            optics_disc_place(&disc, (const double[2]){a, b}, out);
            expect_near(dot(out, out), 1, 1e-12);
            expect_near(acos(dot(out, disc.middle)), asin(radius * hypot(a, b)), 1e-7);
            up += pow(dot(out, disc.up) / radius, 2);
            across += pow(dot(out, disc.across) / radius, 2);
            for (int c = 0; c < 3; c++)
                sum[c] += out[c];
            count++;
        }
    }
    double length = sqrt(dot(sum, sum));
    expect_near(dot(sum, disc.middle) / length, 1, 1e-9);
    expect_near(up / count, radius * radius / 4, 1e-3 * radius * radius); /* the grid's own error at the edge */
    expect_near(across / count, radius * radius / 4, 1e-3 * radius * radius);
    double top[3], side[3];
    optics_disc_place(&disc, (const double[2]){1, 0}, top);
    optics_disc_place(&disc, (const double[2]){0, 1}, side);
    expect_near(asin(top[1]), 42 * degree, 1e-9);
    expect_near(side[1], cos(5 * degree) * sin(37 * degree), 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fresnel_is_that_of_the_tables),
        cmocka_unit_test(fresnel_is_that_of_the_angles),
        cmocka_unit_test(light_leaves_as_it_came),
        cmocka_unit_test(the_root_has_the_right_sign),
        cmocka_unit_test(snell_is_that_of_the_tables),
        cmocka_unit_test(rays_keep_to_their_plane),
        cmocka_unit_test(absorption_is_a_share_for_each_metre),
        cmocka_unit_test(the_sun_stands_where_it_is_said),
        cmocka_unit_test(the_disc_is_round_and_even),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
