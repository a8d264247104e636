/* The technique `precomputed`: its loops, those from files too. tests/random_caustics.c has the wave theory. */
#include "support.h"

#include "light/loop.h"

#include <math.h>
#include <sys/stat.h>

struct fixture {
    struct support_log log;
    struct dpl_renderer *renderer;
    struct dpl_scene *scene;
    char folder[64], path[128];
};

static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    support_log_start(&fixture->log);
    fixture->renderer = dpl_renderer_create(NULL, DPL_DEVICE_CPU, &fixture->log.log);
    fixture->scene = support_scene("[caustics]\ntechnique = precomputed\nmesh = 4\n"
                                   "[precomputed]\nside = 32\nframes = 3\ncolors = 1\n",
                                   &fixture->log.log);
    support_folder_make(fixture->folder);
    *state = fixture;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *fixture = *state;
    dpl_renderer_destroy(fixture->renderer);
    dpl_scene_destroy(fixture->scene);
    support_folder_count(fixture->folder, true);
    free(fixture);
    return 0;
}

static struct dpl_image *map_of(struct fixture *fixture, double time)
{
    struct dpl_image *map = dpl_renderer_map(fixture->renderer, fixture->scene, time);
    if (!map)
        fail_msg("%s", fixture->log.text);
    return map;
}

static bool same(struct dpl_image *a, struct dpl_image *b)
{
    assert_int_equal(a->width, b->width);
    bool equal = !memcmp(a->pixels, b->pixels, (size_t)(a->width * a->height * 3) * sizeof(float));
    dpl_image_destroy(a);
    dpl_image_destroy(b);
    return equal;
}

/* Between frames too, on maps finer and coarser than they are, side by side. */
static void the_mean_is_1(void **state)
{
    static const int sides[] = {1, 7, 32, 97, 128};
    struct fixture *fixture = *state;
    for (int i = 0; i < 15; i++) {
        support_set(fixture->scene, "caustics.map", "%d", sides[i % 5]);
        support_set(fixture->scene, "precomputed.repeat", "%d", 1 + i / 5);
        support_set(fixture->scene, "precomputed.colors", "%d", 1 + i % 2);
        struct dpl_image *map = map_of(fixture, 0.37 * i);
        double sum = 0;
        for (int k = 0; k < map->width * map->height * 3; k++)
            sum += (double)map->pixels[k];
        assert_true(fabs(sum / (map->width * map->height * 3) - 1) < 2e-6);
        dpl_image_destroy(map);
    }
}

static void a_loop_ends_as_it_starts(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "precomputed.loop", "0.7");
    assert_true(same(map_of(fixture, 0), map_of(fixture, 0.7)));
    assert_true(same(map_of(fixture, 0), map_of(fixture, 0.7 * 3)));
    assert_true(same(map_of(fixture, 0.2), map_of(fixture, 0.2 - 0.7)));
    assert_false(same(map_of(fixture, 0), map_of(fixture, 0.35)));
    support_set(fixture->scene, "scene.loop", "5");
    assert_true(same(map_of(fixture, 0), map_of(fixture, 5)));
    assert_false(same(map_of(fixture, 0), map_of(fixture, 0.7)));
    support_set(fixture->scene, "precomputed.loop", "4"); /* is not looked at now */
    assert_true(same(map_of(fixture, 1), map_of(fixture, 6)));
}

static struct dpl_image *picture(int width, int height, int number)
{
    struct dpl_image *image = dpl_image_create(width, height, NULL);
    for (int i = 0; i < width * height * 3; i++)
        image->pixels[i] = (float)(i * 7 % 31 + 10 * number);
    return image;
}

static void save(struct fixture *fixture, const char *name, int width, int height, int number)
{
    struct dpl_image *image = picture(width, height, number);
    snprintf(fixture->path, sizeof fixture->path, "%s/%s", fixture->folder, name);
    assert_true(dpl_image_save(image, fixture->path, NULL, NULL));
    dpl_image_destroy(image);
}

static void expect_pictures(struct fixture *fixture, int side)
{
    for (int frame = 0; frame < 3; frame++)
        assert_true(same(map_of(fixture, 4.0 / 3 * frame), picture(side, side, frame)));
    struct dpl_image *between = map_of(fixture, 2), *first = picture(side, side, 1);
    for (int i = 0; i < side * side * 3; i++)
        assert_true(fabs((double)(between->pixels[i] - first->pixels[i]) - 5) < 1e-4);
    dpl_image_destroy(between);
    dpl_image_destroy(first);
}

static void numbered_pictures_are_played(void **state)
{
    struct fixture *fixture = *state;
    save(fixture, "2nd-map-9.exr", 6, 6, 0);
    save(fixture, "2nd-map-10.exr", 6, 6, 1);
    save(fixture, "2nd-map-11.exr", 6, 6, 2);
    support_set(fixture->scene, "caustics.map", "6");
    support_set(fixture->scene, "precomputed.files", "%s", fixture->folder);
    expect_pictures(fixture, 6);
    save(fixture, "other-1.exr", 2, 2, 0);
    support_set(fixture->scene, "precomputed.files", "%s/2nd-map-%%04d.exr", fixture->folder);
    expect_pictures(fixture, 6);
    support_set(fixture->scene, "caustics.map", "12");
    support_set(fixture->scene, "precomputed.repeat", "2");
    struct dpl_image *map = map_of(fixture, 0), *tile = picture(6, 6, 0);
    for (int j = 0; j < 12; j++)
        for (int i = 0; i < 36; i++)
            assert_true(map->pixels[j * 36 + i] == tile->pixels[j % 6 * 18 + i % 18]);
    dpl_image_destroy(map);
    dpl_image_destroy(tile);
}

static void expect_refusal(struct fixture *fixture, enum dpl_reason reason, const char *first, const char *second)
{
    assert_null(dpl_renderer_map(fixture->renderer, fixture->scene, 0));
    EXPECT_ERROR(&fixture->log, reason, first, second);
}

static void spoil(struct fixture *fixture, float value)
{
    struct dpl_image *image = picture(6, 6, 0);
    image->pixels[3 * (6 * 4 + 5) + 1] = value;
    assert_true(dpl_image_save(image, fixture->path, NULL, NULL));
    dpl_image_destroy(image);
}

static void broken_loops_are_refused_by_name(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "precomputed.files", "%s", fixture->folder);
    expect_refusal(fixture, DPL_REASON_FILE_READ, fixture->folder, "no numbered pictures");
    save(fixture, "a.pfm", 6, 6, 0); /* has no number: not of the loop */
    save(fixture, "1.pfm", 6, 6, 0);
    save(fixture, "3.pfm", 6, 6, 0);
    expect_refusal(fixture, DPL_REASON_FILE_READ, fixture->folder, "2 is missing");
    save(fixture, "2.png", 6, 6, 0);
    expect_refusal(fixture, DPL_REASON_FILE_READ, fixture->folder, "several names");
    unlink(fixture->path);
    save(fixture, "01.pfm", 6, 6, 0);
    expect_refusal(fixture, DPL_REASON_FILE_READ, fixture->folder, "1 is there twice");
    unlink(fixture->path);
    save(fixture, "2.pfm", 6, 5, 0);
    expect_refusal(fixture, DPL_REASON_FILE_FORMAT, fixture->path, "6 × 5");
    save(fixture, "2.pfm", 5, 5, 0);
    expect_refusal(fixture, DPL_REASON_FILE_FORMAT, fixture->path, "accepted: 6");
    spoil(fixture, NAN);
    expect_refusal(fixture, DPL_REASON_FILE_FORMAT, fixture->path, "column 5, row 4: \"nan\"");
    spoil(fixture, -1);
    expect_refusal(fixture, DPL_REASON_FILE_FORMAT, fixture->path, "column 5, row 4: \"-1\"");
    assert_int_equal(truncate(fixture->path, 100), 0);
    expect_refusal(fixture, DPL_REASON_FILE_FORMAT, fixture->path, "bytes of values");
    unlink(fixture->path);
    assert_int_equal(mkdir(fixture->path, 0700), 0);
    expect_refusal(fixture, DPL_REASON_FILE_READ, fixture->path, "not a regular file");
    assert_int_equal(rmdir(fixture->path), 0);
    save(fixture, "2.pfm", 6, 6, 0);
    dpl_image_destroy(map_of(fixture, 0));
}

static void places_that_name_no_loop_are_refused(void **state)
{
    static const char *const places[] = {
        "/none-such/%d.png", "/none-such", "a%d%d.png", "%s", "%04", "%", "a.png", "%4d"};
    struct fixture *fixture = *state;
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        support_set(fixture->scene, "precomputed.files", "%s", places[i]);
        expect_refusal(fixture, DPL_REASON_FILE_READ, places[i], i == 0 ? "cannot be read" : "accepted");
    }
    support_set(fixture->scene, "precomputed.files", "");
    dpl_image_destroy(map_of(fixture, 0));
}

static void a_loop_too_large_is_refused_by_name(void **state)
{
    struct support_log log;
    struct loop loop = {0};
    (void)state;
    assert_false(loop_resize(&loop, LOOP_FRAMES_MAX, LIGHT_MAP_MAX, 3, "mine", support_log_start(&log)));
    EXPECT_ERROR(&log, DPL_REASON_LIMIT, "mine: ", "4096 frames of 8192", "2048 MB");
    assert_null(loop.texels);
}

/* Slices whose windows differ in size share buffers: those that the largest needs stay. */
static void buffers_only_grow(void **state)
{
    static const struct ray_window windows[] = {{-1, -1, 8}, {-1, -1, 0.5}};
    struct loop_player player = {0};
    struct loop loop = {0};
    struct light_map map = {0}, alone = {0};
    const struct loop_moment moment = {0, 1, 0.5f};
    size_t rooms[4];
    (void)state;
    assert_true(loop_resize(&loop, 2, 16, 1, "mine", NULL));
    for (int i = 0; i < 2 * 16 * 16; i++)
        loop.texels[i] = (float)(i * 7 % 31);
    assert_true(light_map_resize(&map, 8, 3, 2, NULL) && light_map_resize(&alone, 8, 3, 2, NULL));
    for (int i = 0; i < 4; i++) {
        struct loop_player fresh = {0};
        assert_true(loop_play(&player, &loop, &moment, windows + i % 2, 2, 2, &map, i % 2, NULL));
        assert_true(loop_play(&fresh, &loop, &moment, windows + i % 2, 2, 2, &alone, i % 2, NULL));
        loop_player_finish(&fresh);
        const size_t now[4] = {player.x.first_room, player.x.weights_room, player.lines_room, player.scratch_room};
        if (i == 0)
            memcpy(rooms, now, sizeof rooms);
        assert_memory_equal(rooms, now, sizeof rooms);
    }
    assert_memory_equal(map.texels, alone.texels, 2 * 8 * 8 * 3 * sizeof(float));
    loop_player_finish(&player);
    loop_finish(&loop);
    light_map_finish(&map);
    light_map_finish(&alone);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(the_mean_is_1, setup, teardown),
        cmocka_unit_test_setup_teardown(a_loop_ends_as_it_starts, setup, teardown),
        cmocka_unit_test_setup_teardown(numbered_pictures_are_played, setup, teardown),
        cmocka_unit_test_setup_teardown(broken_loops_are_refused_by_name, setup, teardown),
        cmocka_unit_test_setup_teardown(places_that_name_no_loop_are_refused, setup, teardown),
        cmocka_unit_test(a_loop_too_large_is_refused_by_name),
        cmocka_unit_test(buffers_only_grow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
