/* Water from pictures on disk: what they say is what is there, at any time; and what is refused. */
#include "support.h"
#include "water.h"

#include "scene/scene.h"

#include <math.h>

#define SIDE 6

struct fixture {
    struct support_log log;
    char folder[64];
    struct dpl_scene *scene;
    const struct water_model *model;
    struct water_setup setup;
    struct water_memory memory;
};

static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    support_log_start(&fixture->log);
    support_folder_make(fixture->folder);
    assert_int_equal(chdir(fixture->folder), 0);
    fixture->scene = support_scene("[water]\nmodel = heightfield\n", &fixture->log.log);
    *state = fixture;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *fixture = *state;
    water_memory_finish(&fixture->memory, NULL);
    dpl_scene_destroy(fixture->scene);
    support_folder_count(fixture->folder, true);
    free(fixture);
    return 0;
}

static void set(struct fixture *fixture, const char *key, const char *value)
{
    support_set(fixture->scene, key, "%s", value);
}

static bool prepare(struct fixture *fixture, double time)
{
    fixture->setup = scene_water_setup(fixture->scene, NULL);
    fixture->setup.memory = &fixture->memory;
    fixture->model = water_models[fixture->scene->medium.model];
    return water_prepare(fixture->model, &fixture->setup, time, &fixture->log.log);
}

static struct water_point sample(struct fixture *fixture, double time, double x, double z)
{
    assert_true(prepare(fixture, time));
    return sample_point(fixture->model, &fixture->setup, time, x, z);
}

static void write_picture(const char *name, int width, int height, double (*value)(int column, int row, int number),
                          int number)
{
    struct dpl_image *image = dpl_image_create(width, height, NULL);
    for (int i = 0; i < width * height; i++) {
        image->pixels[i * 3] = (float)value(i % width, i / width, number);
        image->pixels[i * 3 + 1] = image->pixels[i * 3 + 2] = 99; /* nobody reads it */
    }
    assert_true(dpl_image_save(image, name, NULL, NULL));
    dpl_image_destroy(image);
}

static double bumps(int column, int row, int number)
{
    return (column * column * 7 + row * 13 + column * row + number) % 256 / 255.0;
}

/* Every pixel is a vertex, its slopes the central differences; of each format, joined at the edges or not. */
static void pixels_are_vertices(void **state)
{
    struct fixture *fixture = *state;
    static const char *const names[] = {"a.pfm", "a.exr", "a.png"};
    set(fixture, "heightfield.scale", "0.3");
    set(fixture, "heightfield.offset", "-0.2");
    for (int k = 0; k < 6; k++) {
        bool periodic = k % 2;
        double spacing = 4.0 / (periodic ? SIDE : SIDE - 1);
        write_picture(names[k / 2], SIDE, SIDE, bumps, 0);
        set(fixture, "heightfield.file", names[k / 2]);
        set(fixture, "heightfield.periodic", periodic ? "true" : "false");
        for (int j = 1; j < SIDE - 1; j++) {
            for (int i = 1; i < SIDE - 1; i++) {
                struct water_point point = sample(fixture, 3, i * spacing - 2, j * spacing - 2);
                double slope_x = (bumps(i + 1, j, 0) - bumps(i - 1, j, 0)) * 0.3 / (2 * spacing);
                double slope_z = (bumps(i, j + 1, 0) - bumps(i, j - 1, 0)) * 0.3 / (2 * spacing);
                assert_true(fabs(point.height - (bumps(i, j, 0) * 0.3 - 0.2)) < 1e-7);
                assert_true(fabs(point.slope[0] - slope_x) < 1e-6 && fabs(point.slope[1] - slope_z) < 1e-6);
            }
        }
        double edge = sample(fixture, 3, 2, 2).height;
        assert_true(fabs(edge - (bumps(periodic ? 0 : SIDE - 1, periodic ? 0 : SIDE - 1, 0) * 0.3 - 0.2)) < 1e-7);
    }
}

static void what_a_surface_is_written_as_is_read_back(void **state)
{
    struct fixture *fixture = *state;
    struct dpl_renderer *renderer = dpl_renderer_create(NULL, DPL_DEVICE_CPU, NULL);
    struct dpl_image *images[2];
    set(fixture, "water.model", "sines");
    set(fixture, "wave.1.cycles", "3 -2");
    set(fixture, "caustics.mesh", "50");
    for (int i = 0; i < 2; i++) {
        images[i] = dpl_renderer_surface(renderer, fixture->scene, 1.2);
        assert_non_null(images[i]);
        assert_true(dpl_image_save(images[i], "waves.pfm", NULL, NULL));
        set(fixture, "water.model", "heightfield");
        set(fixture, "heightfield.file", "waves.pfm");
    }
    for (int i = 0; i < 50 * 50; i++) {
        assert_true(images[0]->pixels[i * 3] == images[1]->pixels[i * 3]);
        for (int c = 1; c < 3; c++) /* central differences of a wave 17 cells long: 2.4 % of 0.047 */
            assert_true(fabsf(images[0]->pixels[i * 3 + c] - images[1]->pixels[i * 3 + c]) < 2e-3f);
    }
    dpl_image_destroy(images[0]);
    dpl_image_destroy(images[1]);
    dpl_renderer_destroy(renderer);
}

static double square(int column, int row, int number)
{
    (void)column, (void)row;
    return number * number;
}

/* Pictures 7, 8 and 9 with the heights 49, 64 and 81. */
static void pictures_go_over_into_each_other(void **state)
{
    struct fixture *fixture = *state;
    static const struct {
        const char *scene_loop, *loop;
        double time, wanted;
    } cases[] = {
        {"0", "no", -3, 49},          {"0", "no", 0, 49},
        {"0", "no", 0.25, 56.5},      {"0", "no", 0.5, 64},
        {"0", "no", 0.9, 77.6},       {"0", "no", 100, 81},
        {"0", "yes", 1.25, 65},       {"0", "yes", 1.5, 49},
        {"0", "yes", 151.25, 65},     {"0", "yes", -0.25, 65},
        {"3.2", "no", 0.8 / 3, 56.5}, {"3.2", "no", 1.6 / 3 + 3.2, 64}, /* twice round in 3.2 s */
        {"3.2", "no", 1.6, 49},       {"0.1", "no", 0.05, 72.5},
    };
    for (int number = 7; number < 10; number++) {
        char name[32];
        snprintf(name, sizeof name, "h-%03d.pfm", number);
        write_picture(name, 2, 2, square, number);
    }
    set(fixture, "heightfield.file", "h-%03d.pfm");
    set(fixture, "heightfield.first", "7");
    set(fixture, "heightfield.rate", "2");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        set(fixture, "scene.loop", cases[i].scene_loop);
        set(fixture, "heightfield.loop", cases[i].loop);
        assert_true(fabs(sample(fixture, cases[i].time, 0.3, 0.1).height - cases[i].wanted) < 1e-4);
    }
}

/* Heights are kept from frame to frame, but not when a number changes, the picture, or one could not be read. */
static void every_number_changes_the_heights_and_back(void **state)
{
    struct fixture *fixture = *state;
    static const char *const changes[][3] = {
        {"heightfield.scale", "2", "1"}, {"heightfield.offset", "5", "0"},
        {"heightfield.first", "1", "0"}, {"heightfield.file", "b-%d.pfm", "a-%d.pfm"},
        {"heightfield.rate", "3", "1"},  {"scene.loop", "1", "0"},
    };
    for (int number = 0; number < 3; number++) {
        char name[32];
        snprintf(name, sizeof name, "a-%d.pfm", number + 1);
        write_picture(name, 2, 2, square, number + 1);
        snprintf(name, sizeof name, "b-%d.pfm", number);
        write_picture(name, 2, 2, square, number + 7);
    }
    write_picture("a-0.pfm", 2, 2, square, 4);
    write_picture("a-3.pfm", 3, 3, square, 4);
    set(fixture, "heightfield.file", "a-%d.pfm");
    set(fixture, "heightfield.rate", "1");
    for (size_t i = 0; i < sizeof changes / sizeof *changes; i++) {
        assert_true(sample(fixture, 0.25, 0, 0).height == 12.25);
        set(fixture, changes[i][0], changes[i][1]);
        if (sample(fixture, 0.25, 0, 0).height == 12.25)
            fail_msg("%s changes nothing", changes[i][0]);
        set(fixture, changes[i][0], changes[i][2]);
        assert_true(sample(fixture, 0.25, 0, 0).height == 12.25);
        assert_false(prepare(fixture, 2.5));
        EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_FORMAT, "a-3.pfm");
    }
}

/* More than are kept, in any order. */
static void any_picture_is_found_at_any_time(void **state)
{
    struct fixture *fixture = *state;
    enum { COUNT = 300 };
    uint64_t random = 11;
    for (int number = 0; number < COUNT; number++) {
        char name[32];
        snprintf(name, sizeof name, "%d.pfm", number);
        write_picture(name, 2, 2, square, number);
    }
    set(fixture, "heightfield.file", "%d.pfm");
    set(fixture, "heightfield.rate", "1");
    set(fixture, "heightfield.loop", "yes");
    for (int i = 0; i < 1000; i++) {
        int number = (int)(support_random(&random) % COUNT), next = (number + 1) % COUNT;
        double wanted = (number * number + next * next) / 2.0;
        assert_true(fabs(sample(fixture, number + 0.5, 0, 0).height - wanted) < 1e-6 * wanted + 1e-6);
    }
}

static double broken(int column, int row, int number)
{
    return column == 1 && row == 2 ? (number ? INFINITY : NAN) : 0;
}

static void expect_refused(struct fixture *fixture, const char *file, enum dpl_reason reason, const char *part,
                           const char *accepted)
{
    set(fixture, "heightfield.file", file);
    for (int frame = 0; frame < 2; frame++) { /* each one fails, and says so */
        assert_false(prepare(fixture, 0.5));
        EXPECT_ERROR(&fixture->log, reason, part, accepted);
    }
}

static void what_is_no_height_is_refused(void **state)
{
    struct fixture *fixture = *state;
    static const char *const patterns[] = {"a-%s.png", "a-%d-%d.png", "a-%4d.png", "a-%00d.png", "a-%n.png", "a-%"};
    expect_refused(fixture, "", DPL_REASON_VALUE, "heightfield.file", "accepted: the name of a picture");
    expect_refused(fixture, "no.png", DPL_REASON_FILE_READ, "no.png", "");
    expect_refused(fixture, "no-%02d.png", DPL_REASON_FILE_READ, "no-00.png", "");
    expect_refused(fixture, "a.txt", DPL_REASON_FILE_FORMAT, "a.txt", "accepted: .png, .exr, .pfm");
    for (size_t i = 0; i < sizeof patterns / sizeof *patterns; i++)
        expect_refused(fixture, patterns[i], DPL_REASON_VALUE, patterns[i], "accepted: one %d or %0Nd");
    write_picture("wide.pfm", 3, 2, bumps, 0);
    expect_refused(fixture, "wide.pfm", DPL_REASON_FILE_FORMAT, "wide.pfm: 3 × 2", "accepted: as wide as high");
    write_picture("dot.pfm", 1, 1, bumps, 0);
    expect_refused(fixture, "dot.pfm", DPL_REASON_FILE_FORMAT, "dot.pfm: 1 × 1", "2 at least");
    write_picture("nan.pfm", 4, 4, broken, 0);
    expect_refused(fixture, "nan.pfm", DPL_REASON_RANGE, "nan.pfm: ", "at column 1, row 2 (accepted: -1e6 to 1e6)");
    write_picture("inf.exr", 4, 4, broken, 1);
    expect_refused(fixture, "inf.exr", DPL_REASON_RANGE, "inf.exr: inf at column 1, row 2", "accepted");
    write_picture("s-0.pfm", 4, 4, bumps, 0);
    write_picture("s-1.pfm", 5, 5, bumps, 1);
    set(fixture, "heightfield.rate", "1");
    expect_refused(fixture, "s-%d.pfm", DPL_REASON_FILE_FORMAT, "s-1.pfm: 5 pixels", "as the first picture, 4");
    write_picture("gap-0.pfm", 4, 4, bumps, 0);
    write_picture("gap-2.pfm", 4, 4, bumps, 2);
    expect_refused(fixture, "gap-%d.pfm", DPL_REASON_FILE_READ, "gap-1.pfm: is missing, and gap-2.pfm is there", "");
    set(fixture, "heightfield.file", "s-0.pfm"); /* all is well again */
    assert_true(prepare(fixture, 0));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(pixels_are_vertices, setup, teardown),
        cmocka_unit_test_setup_teardown(what_a_surface_is_written_as_is_read_back, setup, teardown),
        cmocka_unit_test_setup_teardown(pictures_go_over_into_each_other, setup, teardown),
        cmocka_unit_test_setup_teardown(every_number_changes_the_heights_and_back, setup, teardown),
        cmocka_unit_test_setup_teardown(any_picture_is_found_at_any_time, setup, teardown),
        cmocka_unit_test_setup_teardown(what_is_no_height_is_refused, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
