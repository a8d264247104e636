/* Shadows of the physical look, in OpenGL 3.3 and OpenGL ES 3.0: that of a pole which stands half out of flat water, on
 * the floor and on a wall, against geometry: along the sun's rays in the air, and along Snell's in the water. */
#include "physical.h"

#define SIDE 64 /* pixels */
#define HIGH 0.4 /* m that the pole stands out of the water, of the depth 1 m */
#define WIDE 0.08

/* A square pole with an even top, one face towards the sun. */
static struct dpl_scene *pole_scene(struct physical_fixture *fixture)
{
    return physical_scene(fixture, "[object.pole]\nshape = box\nsize = 0.08 1.4 0.08\n");
}

static void turn_to_sun(struct dpl_scene *scene, int elevation, int azimuth)
{
    support_set(scene, "sun.elevation", "%d", elevation);
    support_set(scene, "sun.azimuth", "%d", azimuth);
    support_set(scene, "object.pole.turn", "%d", azimuth);
}

/* m that the shadow of a point `height` m above the water is beside it on the floor. */
static double shadow_way(double elevation, double height)
{
    double outside = (90 - elevation) * PHYSICAL_DEGREE;
    return height * tan(outside) + tan(physical_inside(outside));
}

/* The share of the floor's light that is left with the pole, at each pixel, of what is there without it. */
static void draw_shares(struct physical_fixture *fixture, struct dpl_scene *scene, double shares[SIDE * SIDE])
{
    struct dpl_image *image = physical_radiance(fixture, scene, SIDE, SIDE);
    double open = physical_floor(scene, 1);
    for (int i = 0; i < SIDE * SIDE; i++)
        shares[i] = (double)image->pixels[i * 3 + 1] / open;
    dpl_image_destroy(image);
}

/* The floor around the shadow's tip, from in the water: along the shadow it is dark up to the tip and bright beyond, across
 * it dark for the pole's width. Where half the light is left is the edge. */
static void check_tip(struct physical_fixture *fixture, struct dpl_scene *scene, int elevation, int azimuth)
{
    const double view = 0.4, ahead[2] = {-cos(azimuth * PHYSICAL_DEGREE), -sin(azimuth * PHYSICAL_DEGREE)};
    double tip = shadow_way(elevation, HIGH) + WIDE / 2, shares[SIDE * SIDE];
    turn_to_sun(scene, elevation, azimuth);
    physical_look_down(scene, tip * ahead[0], tip * ahead[1], view);
    draw_shares(fixture, scene, shares);
    double dark = 0, middle = 0, along = 0, farthest = -1;
    for (int i = 0; i < SIDE * SIDE; i++) {
        double x = ((i % SIDE + 0.5) / SIDE - 0.5) * view, z = ((i / SIDE + 0.5) / SIDE - 0.5) * view;
        double beyond = x * ahead[0] + z * ahead[1], beside = z * ahead[0] - x * ahead[1];
        if (beyond < -0.15 || beyond > 0.15 || fabs(beside) > 0.15)
            continue;
        double weight = fmin(fmax(1 - shares[i], 0), 1) / SIDE * view / SIDE * view; /* m² of shadow */
        dark += weight;
        middle += weight * beside;
        if (fabs(beside) < WIDE / 2 - 0.025)
            along += weight;
        (void)farthest;
    }
    /* whole shadow in the square: 0.15 long and WIDE wide */
    print_message("sun %d %d: width %g of %g, middle %g, end %g\n", elevation, azimuth, dark / 0.15, WIDE, middle / dark,
                  along / (WIDE - 0.05) - 0.15);
}

/* From the pole's foot to the tip there is no gap in it. */
static void check_whole(struct physical_fixture *fixture, struct dpl_scene *scene, int elevation, int azimuth)
{
    const double ahead[2] = {-cos(azimuth * PHYSICAL_DEGREE), -sin(azimuth * PHYSICAL_DEGREE)};
    double tip = shadow_way(elevation, HIGH) + WIDE / 2, shares[SIDE * SIDE], view = 2 * tip, most = 0;
    turn_to_sun(scene, elevation, azimuth);
    physical_look_down(scene, tip * ahead[0], tip * ahead[1], view);
    draw_shares(fixture, scene, shares);
    for (double way = WIDE / 2 + view / SIDE; way < tip - 0.04; way += 0.01) {
        int column = (int)floor(((way - tip) * ahead[0] / view + 0.5) * SIDE), row = (int)floor(((way - tip) * ahead[1] / view + 0.5) * SIDE);
        most = fmax(most, shares[row * SIDE + column]);
    }
    print_message("whole %d %d: at most %g\n", elevation, azimuth, most);
}

static void check_poles(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = pole_scene(fixture);
    for (int elevation = 15; elevation < 90; elevation += 25)
        check_tip(fixture, scene, elevation, 20);
    for (int azimuth = -170; azimuth < 180; azimuth += 70)
        check_tip(fixture, scene, 50, azimuth);
    check_whole(fixture, scene, 25, 130);
    check_whole(fixture, scene, 70, -20);
    dpl_scene_destroy(scene);
}

static void check(bool es)
{
    struct physical_fixture fixture;
    physical_start(&fixture, es);
    check_poles(&fixture);
    physical_finish(&fixture);
}

static void shadows_follow_the_sun(void **state)
{
    (void)state;
    check(false);
}

static void shadows_follow_the_sun_in_es(void **state)
{
    (void)state;
    check(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(shadows_follow_the_sun),
                                       cmocka_unit_test(shadows_follow_the_sun_in_es)};
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
