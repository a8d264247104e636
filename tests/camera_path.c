/* The camera's path: through its keys, smooth, without overshoot, round where it is closed; and its sections as text.
 */
#include "support.h"

#include "scene/scene.h"

struct fixture {
    struct support_log log;
    struct dpl_scene *scene;
};

static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    fixture->scene = dpl_scene_create(support_log_start(&fixture->log));
    *state = fixture;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *fixture = *state;
    assert_int_equal(fixture->log.errors, 0);
    dpl_scene_destroy(fixture->scene);
    free(fixture);
    return 0;
}

static void read_text(struct fixture *fixture, const char *text)
{
    assert_true(dpl_scene_read(fixture->scene, "path", text, strlen(text)));
}

static double x_at(const struct fixture *fixture, double time)
{
    return dpl_scene_view(fixture->scene, time).position[0];
}

/* Keys out of order, at uneven times. */
static const char three_keys[] = "[camera]\nposition = 9 9 9\nfield_of_view = 30\n"
                                 "[camera.4]\ntime = 7\nposition = 4 1 0\ntarget = 0 0 -3\nfield_of_view = 60\n"
                                 "[camera.2]\ntime = 1\nposition = 0 1 2\nfield_of_view = 40\n"
                                 "[camera.3]\ntime = 2\nposition = 1 2 2\ntarget = 0 1 0\n";

static void keys_are_met(void **state)
{
    struct fixture *fixture = *state;
    read_text(fixture, three_keys);
    static const struct {
        double time, position[3], target[3], field_of_view;
    } keys[] = {
        {-3, {0, 1, 2}, {0, -0.6, 0}, 40}, {1, {0, 1, 2}, {0, -0.6, 0}, 40}, {2, {1, 2, 2}, {0, 1, 0}, 45},
        {7, {4, 1, 0}, {0, 0, -3}, 60},    {99, {4, 1, 0}, {0, 0, -3}, 60},
    };
    for (size_t k = 0; k < sizeof keys / sizeof *keys; k++) {
        struct dpl_view view = dpl_scene_view(fixture->scene, keys[k].time);
        for (int c = 0; c < 3; c++) {
            assert_float_equal(view.position[c], keys[k].position[c], 1e-12);
            assert_float_equal(view.target[c], keys[k].target[c], 1e-12);
        }
        assert_float_equal(view.field_of_view, keys[k].field_of_view, 1e-12);
    }
}

/* One key, or none, is no path. */
static void one_key_is_no_path(void **state)
{
    struct fixture *fixture = *state;
    read_text(fixture, "[camera]\nposition = 9 9 9\n[camera.1]\nposition = 1 1 1\ntime = 3\n");
    for (int second = 0; second < 5; second++)
        assert_float_equal(x_at(fixture, second), 9, 0);
}

/* Neither place nor velocity jumps, at keys and between. */
static void path_is_smooth(void **state)
{
    struct fixture *fixture = *state;
    const double step = 1e-4;
    for (int closed = 0; closed < 2; closed++) {
        read_text(fixture, three_keys);
        support_set(fixture->scene, "camera.closed", closed ? "yes" : "no");
        double place = x_at(fixture, 0.5), velocity = 0, fastest = 0;
        if (closed)
            velocity = (place - x_at(fixture, 0.5 - step)) / step;
        for (double time = 0.5 + step; time < 14; time += step) {
            double next = x_at(fixture, time), now = (next - place) / step;
            assert_true(fabs(now - velocity) < 0.02);
            fastest = fmax(fastest, fabs(now));
            place = next;
            velocity = now;
        }
        assert_true(fastest > 0.5 && fastest < 4);
    }
}

/* What rises from key to key rises in between; what stands still stands still. */
static void nothing_overshoots(void **state)
{
    struct fixture *fixture = *state;
    read_text(fixture, "[camera.1]\nposition = 0 0 0\n[camera.2]\ntime = 1\nposition = 0 0 0\n"
                       "[camera.3]\ntime = 1.1\nposition = 5 0 0\n[camera.4]\ntime = 8\nposition = 5.01 0 0\n"
                       "[camera.5]\ntime = 9\nposition = 8 0 0\n");
    double last = x_at(fixture, 0);
    for (double time = 0; time <= 9; time += 0.01) {
        double x = x_at(fixture, time);
        assert_true(x >= last - 1e-12);
        assert_true(time > 1 || x == 0);
        last = x;
    }
    assert_float_equal(last, 8, 1e-3);
}

/* A path through four keys of a circle stays near it, all the way round and again. */
static void closed_path_is_round(void **state)
{
    struct fixture *fixture = *state;
    read_text(fixture, "[camera]\nclosed = yes\n"
                       "[camera.1]\ntime = 2\nposition = 1 0 1\n[camera.2]\ntime = 3\nposition = -1 0 1\n"
                       "[camera.3]\ntime = 4\nposition = -1 0 -1\n[camera.4]\ntime = 5\nposition = 1 0 -1\n"
                       "[camera.5]\ntime = 6\nposition = 77 77 77\n"); /* of the last the time alone counts */
    for (double time = -6; time < 14; time += 0.01) {
        struct dpl_view view = dpl_scene_view(fixture->scene, time), later = dpl_scene_view(fixture->scene, time + 4);
        double radius = hypot(view.position[0], view.position[2]);
        assert_true(radius > 1.2 && radius < 1.4143);
        assert_float_equal(view.position[0], later.position[0], 1e-9);
        assert_float_equal(view.position[2], later.position[2], 1e-9);
    }
}

static void equal_times_are_a_cut(void **state)
{
    struct fixture *fixture = *state;
    read_text(fixture, "[camera.1]\nposition = 0 0 0\n[camera.2]\ntime = 2\nposition = 1 0 0\n"
                       "[camera.3]\ntime = 2\nposition = 5 0 0\n[camera.4]\ntime = 3\nposition = 6 0 0\n");
    assert_true(x_at(fixture, 1.999) <= 1 && x_at(fixture, 1.999) > 0.99);
    assert_float_equal(x_at(fixture, 2), 5, 1e-12);
    read_text(fixture, "[camera]\nclosed = yes\n[camera.1]\nposition = 3 0 0\n[camera.2]\nposition = 4 0 0\n");
    assert_float_equal(x_at(fixture, 0), 3, 1e-12); /* a round of no time */
    assert_float_equal(x_at(fixture, 1), 3, 1e-12);
}

static int count_keys(const struct fixture *fixture)
{
    int count = 0;
    for (int i = 0; dpl_scene_section(fixture->scene, i).name; i++)
        count += !strncmp(dpl_scene_section(fixture->scene, i).name, "camera.", 7);
    return count;
}

static void keys_come_and_go(void **state)
{
    struct fixture *fixture = *state;
    char folder[64], path[128], value[64];
    support_folder_make(folder);
    snprintf(path, sizeof path, "%s/path.ini", folder);
    read_text(fixture, three_keys);
    assert_true(dpl_scene_save(fixture->scene, path));
    assert_true(dpl_scene_load(fixture->scene, path));
    assert_int_equal(count_keys(fixture), 3);
    assert_true(dpl_scene_get(fixture->scene, "camera.3.position", value, sizeof value));
    assert_string_equal(value, "1 2 2");
    support_set(fixture->scene, "camera.16.time", "20");
    assert_int_equal(count_keys(fixture), 4);
    assert_true(dpl_scene_remove(fixture->scene, "camera.3"));
    assert_true(dpl_scene_remove(fixture->scene, "camera.3"));
    assert_int_equal(count_keys(fixture), 3);
    assert_true(dpl_scene_get(fixture->scene, "camera.3.time", value, sizeof value));
    assert_string_equal(value, "0");
    assert_false(dpl_scene_set(fixture->scene, "camera.17.time", "1"));
    support_expect(&fixture->log, DPL_REASON_UNKNOWN_SECTION, (const char *[]){"camera.17", "camera.16", NULL});
    assert_false(dpl_scene_remove(fixture->scene, "camera"));
    support_expect(&fixture->log, DPL_REASON_UNKNOWN_SECTION, (const char *[]){"camera: ", "camera.16", NULL});
    support_folder_count(folder, true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(keys_are_met, setup, teardown),
        cmocka_unit_test_setup_teardown(one_key_is_no_path, setup, teardown),
        cmocka_unit_test_setup_teardown(path_is_smooth, setup, teardown),
        cmocka_unit_test_setup_teardown(nothing_overshoots, setup, teardown),
        cmocka_unit_test_setup_teardown(closed_path_is_round, setup, teardown),
        cmocka_unit_test_setup_teardown(equal_times_are_a_cut, setup, teardown),
        cmocka_unit_test_setup_teardown(keys_come_and_go, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
