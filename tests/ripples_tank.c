/* The water of `ripples`: against a plain second implementation, its energy, waves that travel and are thrown back,
 * drops, what the ball displaces. */
#include "support.h"

#include "water/ripples_tank.h"

#include <math.h>

static struct tank make_tank(int side, double size, double damping)
{
    struct tank tank = {0};
    assert_true(tank_resize(&tank, side, NULL));
    tank.spacing = size / (side - 1);
    tank.damping = damping;
    tank.pool = (struct ball_pool){size / 2, 1, 4};
    return tank;
}

static void disturb(struct tank *tank, uint64_t random)
{
    for (int i = 0; i < tank->side * tank->side; i++) {
        tank->heights[i] = (float)(support_random_unit(&random) - 0.5);
        tank->speeds[i] = (float)(support_random_unit(&random) - 0.5);
    }
}

static void make_steps(struct tank *tank, int count)
{
    for (int i = 0; i < count; i++)
        tank_apply(tank, &(struct ripples_event){.kind = RIPPLES_STEP});
}

static void drop_into(struct tank *tank, double x, double z, double radius, double height)
{
    tank_apply(tank, &(struct ripples_event){.kind = RIPPLES_DROP, .drop = {x, z, radius, height}});
}

/* The height of a vertex or, beyond the walls, of the nearest one. */
static double height_at(const struct tank *tank, int i, int j)
{
    int last = tank->side - 1;
    i = i < 0 ? 0 : i > last ? last : i;
    j = j < 0 ? 0 : j > last ? last : j;
    return (double)tank->heights[j * tank->side + i];
}

static void a_step_is_the_formula(void **state)
{
    (void)state;
    enum { SIDE = 13 };
    struct tank tank = make_tank(SIDE, 2, 0.97), before = make_tank(SIDE, 2, 0.97);
    disturb(&tank, 3);
    disturb(&before, 3);
    make_steps(&tank, 1);
    for (int k = 0; k < SIDE * SIDE; k++) {
        int i = k % SIDE, j = k / SIDE;
        double mean = (height_at(&before, i - 1, j) + height_at(&before, i + 1, j) + height_at(&before, i, j - 1) +
                       height_at(&before, i, j + 1)) /
                      4;
        double h = (double)before.heights[k], v = 0.97 * ((double)before.speeds[k] + 2 * (mean - h));
        assert_true(fabs((double)tank.speeds[k] - v) < 1e-6);
        assert_true(fabs((double)tank.heights[k] - (h + v)) < 1e-6);
    }
    tank_finish(&tank);
    tank_finish(&before);
}

/* E of ripples_tank.c; <f, A g> is half the sum of (difference of f) (difference of g) over all pairs of neighbours. */
static double energy(const struct tank *tank)
{
    const double d = tank->damping;
    const int side = tank->side;
    double sum = 0;
    for (int k = 0; k < side * side; k++) {
        double v = (double)tank->speeds[k], h = (double)tank->heights[k] - v;
        sum += v * v + (1 - d) * h * v;
        for (int axis = 0; axis < 2; axis++) {
            if ((axis ? k / side : k % side) == side - 1)
                continue;
            int next = k + (axis ? side : 1);
            double other_v = (double)tank->speeds[next], other_h = (double)tank->heights[next] - other_v;
            sum += d * 0.5 * (h - other_h) * (h + v - other_h - other_v);
        }
    }
    return sum / 2;
}

static void energy_stays_or_is_damped(void **state)
{
    (void)state;
    static const double dampings[] = {1, 0.995, 0.9};
    for (int i = 0; i < 3; i++) {
        struct tank tank = make_tank(64, 2, (double)(float)dampings[i]);
        drop_into(&tank, 0.3, -0.2, 0.1, 0.01);
        drop_into(&tank, -0.9, 0.9, 0.2, -0.02);
        make_steps(&tank, 1);
        double start = energy(&tank);
        assert_true(start > 0);
        for (int steps = 1; steps <= 100; steps++) {
            make_steps(&tank, 1);
            assert_true(fabs(energy(&tank) / start / pow(tank.damping, steps) - 1) < 1e-4);
        }
        tank_finish(&tank);
    }
}

/* A smooth ridge across the tank becomes two, which go apart by √½ cells a step each. */
static void waves_travel_at_their_speed(void **state)
{
    (void)state;
    enum { SIDE = 301, STEPS = 120 };
    struct tank tank = make_tank(SIDE, 3, 1);
    for (int k = 0; k < SIDE * SIDE; k++)
        tank.heights[k] = (float)exp(-pow((k % SIDE - 150) / 12.0, 2));
    make_steps(&tank, STEPS);
    double sum = 0, moment = 0;
    for (int i = 150; i < SIDE; i++) {
        sum += height_at(&tank, i, 77);
        moment += height_at(&tank, i, 77) * (i - 150);
    }
    assert_true(fabs(moment / sum - STEPS * M_SQRT1_2) < 0.5);
    tank_finish(&tank);
}

/* A tank of twice the side in which each drop falls four times, mirrored by the middles, where there is no wall. */
static void walls_are_mirrors(void **state)
{
    (void)state;
    enum { SIDE = 40 };
    struct tank tank = make_tank(SIDE, SIDE - 1, 1), wide = make_tank(2 * SIDE, 2 * SIDE - 1, 1);
    double middle = (SIDE - 1) / 2.0, x = 29.3, z = 33.1, largest = 0; /* in cells from the first vertex */
    drop_into(&tank, x - middle, z - middle, 5, 1);
    for (int k = 0; k < 4; k++)
        drop_into(&wide, (k % 2 ? 1 : -1) * (SIDE - 0.5 - x), (k / 2 ? 1 : -1) * (SIDE - 0.5 - z), 5, 1);
    make_steps(&tank, 60);
    make_steps(&wide, 60);
    for (int k = 0; k < SIDE * SIDE; k++) {
        double height = height_at(&tank, k % SIDE, k / SIDE);
        assert_true(fabs(height - height_at(&wide, k % SIDE, k / SIDE)) < 1e-5);
        largest = fmax(largest, fabs(height));
    }
    assert_true(largest > 0.02);
    tank_finish(&tank);
    tank_finish(&wide);
}

static void a_drop_has_its_shape_and_volume(void **state)
{
    (void)state;
    enum { SIDE = 128 };
    struct tank tank = make_tank(SIDE, 2, 1);
    const double radius = 0.3, x = 0.21, z = -0.4;
    double volume = 0;
    drop_into(&tank, x, z, radius, 0.01);
    for (int k = 0; k < SIDE * SIDE; k++) {
        double from_x = k % SIDE * tank.spacing - 1 - x, from_z = k / SIDE * tank.spacing - 1 - z;
        double w = fmax(0, 1 - sqrt(from_x * from_x + from_z * from_z) / radius), height = (double)tank.heights[k];
        assert_true(fabs(height - 0.01 * (0.5 - 0.5 * cos(M_PI * w))) < 1e-8);
        volume += height * tank.spacing * tank.spacing;
    }
    double exact = 0.01 * M_PI * radius * radius * (0.5 - 2 / (M_PI * M_PI)); /* its integral over the disc */
    assert_true(fabs(volume / exact - 1) < 1e-3);
    drop_into(&tank, 1, 1, 0.1, 1); /* half outside */
    drop_into(&tank, 5, -7, 0.1, 1);
    assert_true(height_at(&tank, SIDE - 1, SIDE - 1) > 0.99);
    tank_finish(&tank);
}

/* Wallace's volume of a ball over a point, in his units. */
static double wallace_volume(const double ball[4], double x, double z)
{
    double from[3] = {x - ball[0], -ball[1], z - ball[2]};
    double t = sqrt(from[0] * from[0] + from[1] * from[1] + from[2] * from[2]) / ball[3];
    double dy = exp(-pow(t * 1.5, 6)), low = fmin(0, ball[1] - dy);
    double high = fmin(fmax(0, ball[1] + dy), low + 2 * dy);
    return (high - low) * 0.1;
}

static void the_ball_displaces_what_wallace_has_it_displace(void **state)
{
    (void)state;
    enum { SIDE = 65 };
    static const double places[][4] = {{-0.4, -0.75, 0.2, 0.25},
                                       {0.1, -0.1, 0.3, 0.25},
                                       {0.2, 0.15, 0.2, 0.4},
                                       {0.9, 0, -0.95, 0.5},
                                       {0.5, 0, 0.5, 0}};
    const double unit = 3; /* m: half a side of this pool */
    for (int p = 0; p < 4; p++) {
        struct tank tank = make_tank(SIDE, 2 * unit, 1);
        struct ripples_event event = {.kind = RIPPLES_MOVE};
        const double *from = places[p], *to = places[p + 1];
        double largest = 0;
        for (int c = 0; c < 3; c++) {
            event.from.center[c] = from[c] * unit;
            event.to.center[c] = to[c] * unit;
        }
        event.from.radius = from[3] * unit;
        event.to.radius = to[3] * unit;
        tank_apply(&tank, &event);
        for (int k = 0; k < SIDE * SIDE; k++) {
            double x = k % SIDE * tank.spacing / unit - 1, z = k / SIDE * tank.spacing / unit - 1;
            double wanted = wallace_volume(from, x, z) - (to[3] > 0 ? wallace_volume(to, x, z) : 0);
            assert_true(fabs((double)tank.heights[k] - wanted * unit) < 1e-6);
            largest = fmax(largest, fabs(wanted));
        }
        assert_true(largest > 1e-3);
        tank_finish(&tank);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_step_is_the_formula),
        cmocka_unit_test(energy_stays_or_is_damped),
        cmocka_unit_test(waves_travel_at_their_speed),
        cmocka_unit_test(walls_are_mirrors),
        cmocka_unit_test(a_drop_has_its_shape_and_volume),
        cmocka_unit_test(the_ball_displaces_what_wallace_has_it_displace),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
