/* Shadows of the physical look, in OpenGL 3.3 and OpenGL ES 3.0: that of a pole which stands half out of flat water, on
 * the floor and on a wall, against geometry: along the sun's rays in the air, and along Snell's in the water. */
#include "physical.h"

#define SIDE 64  /* pixels */
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

/* The share of the sun's light that the pole takes, at each pixel of the floor; the rest of the floor's light is what
 * the water throws back. */
static void draw_shadow(struct physical_fixture *fixture, struct dpl_scene *scene, double taken[SIDE * SIDE])
{
    struct dpl_image *image = physical_radiance(fixture, scene, SIDE, SIDE);
    double open = physical_floor(scene, 1), straight = 1 - scene->floor.color[1] * physical_thrown_back(0);
    for (int i = 0; i < SIDE * SIDE; i++)
        taken[i] = (1 - (double)image->pixels[i * 3 + 1] / open) / straight;
    dpl_image_destroy(image);
}

/* A square of the floor, 0.3 m wide and turned along the shadow, in whose middle its tip should be: its width, its
 * middle and its end, of the area that is dark. Waves are taken to blur it by 2 cm, evenly to both sides; a texel of
 * the shadow map is 2 mm, a pixel 8 mm, of which the width counts many and the end few. */
static void check_tip(struct physical_fixture *fixture, struct dpl_scene *scene, int elevation, int azimuth)
{
    const double view = 0.5, half = 0.15;
    const double ahead[2] = {-cos(azimuth * PHYSICAL_DEGREE), -sin(azimuth * PHYSICAL_DEGREE)};
    double tip = shadow_way(elevation, HIGH) + WIDE / 2, taken[SIDE * SIDE], end = 0, area = 0, middle = 0;
    int inside = 0, all = 0;
    turn_to_sun(scene, elevation, azimuth);
    physical_look_down(scene, tip * ahead[0], tip * ahead[1], view);
    draw_shadow(fixture, scene, taken);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double x = ((i % SIDE + 0.5) / SIDE - 0.5) * view, z = ((i / SIDE + 0.5) / SIDE - 0.5) * view;
        double beyond = x * ahead[0] + z * ahead[1], beside = z * ahead[0] - x * ahead[1];
        if (fabs(beyond) > half || fabs(beside) > half)
            continue;
        all++;
        area += taken[i];
        middle += taken[i] * beside;
        inside += fabs(beside) < WIDE / 4;
        end += fabs(beside) < WIDE / 4 ? taken[i] : 0;
    }
    end = end / inside * 2 * half - half;
    middle /= area;
    double width = area / all * 4 * half;
    if (fabs(width - WIDE) > 0.004 || fabs(middle) > 0.002 || fabs(end) > 0.004)
        fail_msg("sun at %d, %d degrees: the tip is %g m off, %g beside, %g wide", elevation, azimuth, end, middle,
                 width);
}

/* From the pole's foot to the tip there is no gap in it: the middle of a wide one is all dark. */
static void check_whole(struct physical_fixture *fixture, struct dpl_scene *scene, int elevation, int azimuth)
{
    const double ahead[2] = {-cos(azimuth * PHYSICAL_DEGREE), -sin(azimuth * PHYSICAL_DEGREE)}, wide = 0.16;
    double tip = shadow_way(elevation, HIGH) + wide / 2, taken[SIDE * SIDE], view = 2.1 * tip;
    support_set(scene, "object.pole.size", "%g 1.4 %g", wide, wide);
    turn_to_sun(scene, elevation, azimuth);
    physical_look_down(scene, tip * ahead[0], tip * ahead[1], view);
    draw_shadow(fixture, scene, taken);
    for (double way = wide / 2; way < tip + 0.1; way += 0.01) {
        int column = (int)(((way - tip) * ahead[0] / view + 0.5) * SIDE);
        int row = (int)(((way - tip) * ahead[1] / view + 0.5) * SIDE);
        double found = taken[row * SIDE + column], pixel = view / SIDE;
        if ((way < tip - 0.03 - pixel && found < 0.9) || (way > tip + 0.03 + pixel && found > 0.05))
            fail_msg("sun at %d, %d degrees, %g m of %g: %g of the light taken", elevation, azimuth, way, tip, found);
    }
}

/* A ball in the water throws an ellipse and no more: as large as itself, over the cosine of the light's way. */
static void check_ball(struct physical_fixture *fixture)
{
    struct dpl_scene *scene = physical_scene(fixture, "[sun]\nelevation = 50\nazimuth = 70\n[object.ball]\n"
                                                      "shape = sphere\non_floor = no\nposition = 0 -0.7 0\n"
                                                      "size = 0.3 0.3 0.3\n");
    double inside = physical_inside(40 * PHYSICAL_DEGREE), way = 0.45 * tan(inside), taken[SIDE * SIDE], area = 0;
    physical_look_down(scene, -way * cos(70 * PHYSICAL_DEGREE), -way * sin(70 * PHYSICAL_DEGREE), 0.7);
    support_set(scene, "camera.position", "%.17g -0.02 %.17g", scene->camera.position[0], scene->camera.position[2]);
    support_set(scene, "object.ball.color",
                "0.02 0.02 0.02"); /* it hides some of the floor, and is black like its shadow */
    draw_shadow(fixture, scene, taken);
    for (int i = 0; i < SIDE * SIDE; i++)
        area += taken[i] * 0.7 * 0.7 / (SIDE * SIDE);
    double expected = M_PI * 0.15 * 0.15 / cos(inside);
    if (fabs(area / expected - 1) > 0.05)
        fail_msg("the shadow of a ball: %g m², not %g", area, expected);
    dpl_scene_destroy(scene);
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
    check_ball(&fixture);
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
