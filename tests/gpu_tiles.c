/* Pictures in tiles: the same as drawn at once, for every look; and the path of the camera in the picture. */
#include "support.h"

#include "render/picture.h"
#include "scene/look.h"

#include <math.h>

#define WIDTH 150 /* no multiple of a tile */
#define HEIGHT 90

struct fixture {
    struct support_log log;
    struct dpl_gl *gl;
    struct dpl_renderer *renderer;
    struct dpl_scene *scene;
    int tiles, of; /* as progress told last */
};

static const char scene_text[] = "[water]\nmodel = sines\n[wave.1]\ncycles = 2 1\namplitude = 0.05\n"
                                 "[camera]\nposition = 0.5 0.8 2.5\nfield_of_view = 60\n"
                                 "[sphere]\nradius = 0.3\nposition = -0.4 -0.5 0.2\n[caustics]\nmap = 64\n"
                                 "[look.path-traced]\npasses = 1\nmesh = 128\n";

static void count_tile(void *user, int done, int tiles)
{
    struct fixture *fixture = user;
    assert_int_equal(done, fixture->tiles + 1);
    fixture->tiles = done;
    fixture->of = tiles;
}

static void start(struct fixture *fixture, bool es)
{
    *fixture = (struct fixture){0};
    const struct dpl_log *log = support_log_start(&fixture->log);
    fixture->gl = support_gl(es, log);
    fixture->renderer = dpl_renderer_create(fixture->gl, DPL_DEVICE_AUTO, log);
    fixture->scene = support_scene(scene_text, log);
    dpl_renderer_tiles(fixture->renderer, count_tile, fixture);
}

static void finish(struct fixture *fixture)
{
    assert_int_equal(fixture->log.errors, 0);
    dpl_renderer_destroy(fixture->renderer);
    dpl_scene_destroy(fixture->scene);
    dpl_gl_destroy(fixture->gl);
}

static struct dpl_image *picture(struct fixture *fixture, double time, int side)
{
    fixture->tiles = fixture->of = 0;
    renderer_limit_tiles(fixture->renderer, side);
    struct dpl_image *image = dpl_renderer_picture(fixture->renderer, fixture->scene, time, WIDTH, HEIGHT);
    assert_non_null(image);
    return image;
}

/* Pixels that differ visibly. An edge may fall on the other side of a pixel's middle: a matrix is not exact. */
static int different(const struct dpl_image *a, const struct dpl_image *b)
{
    int count = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        float most = 0;
        for (int c = 0; c < 3; c++)
            most = fmaxf(most, fabsf(a->pixels[i * 3 + c] - b->pixels[i * 3 + c]));
        count += most > 2.5f / 255;
    }
    return count;
}

static void check_looks(struct fixture *fixture)
{
    for (int i = 0; scene_looks[i]; i++) {
        support_set(fixture->scene, "render.look", "%s", scene_looks[i]->name);
        struct dpl_image *whole = picture(fixture, 0.7, 0);
        assert_int_equal(fixture->of, 0); /* one tile tells of no progress */
        struct dpl_image *tiled = picture(fixture, 0.7, 64), *later = picture(fixture, 0.9, 64);
        assert_int_equal(fixture->tiles, fixture->of);
        assert_true(fixture->of >= 6);
        int count = different(whole, tiled);
        if (count > WIDTH * HEIGHT / 500)
            fail_msg("%s: %d pixels of tiles are not those of the whole picture", scene_looks[i]->name, count);
        assert_true(different(whole, later) > WIDTH * HEIGHT / 50); /* what is compared shows a difference */
        dpl_image_destroy(whole);
        dpl_image_destroy(tiled);
        dpl_image_destroy(later);
    }
}

static void check_comparison(struct fixture *fixture)
{
    static const enum dpl_comparison modes[] = {DPL_COMPARE_SPLIT, DPL_COMPARE_DIFFERENCE};
    int technique = 0;
    while (strcmp(dpl_technique(technique).name, "wavefront"))
        technique++;
    for (int i = 0; i < 2; i++) {
        struct dpl_compare compare = {modes[i], technique, .place = 0.55, .gain = 1, .range = 1};
        dpl_renderer_compare(fixture->renderer, &compare);
        struct dpl_image *whole = picture(fixture, 0.7, 0), *tiled = picture(fixture, 0.7, 32);
        assert_true(different(whole, tiled) <= WIDTH * HEIGHT / 500);
        dpl_image_destroy(whole);
        dpl_image_destroy(tiled);
    }
    dpl_renderer_compare(fixture->renderer, &(struct dpl_compare){0});
}

/* A picture on the path is that of a camera which stands there. */
static void check_path(struct fixture *fixture)
{
    struct dpl_image *free_camera = picture(fixture, 1, 0);
    support_set(fixture->scene, "camera.1.position", "-2 1.5 2");
    support_set(fixture->scene, "camera.2.time", "2");
    support_set(fixture->scene, "camera.2.position", "3 0.7 1");
    support_set(fixture->scene, "camera.2.field_of_view", "80");
    struct dpl_image *moved = picture(fixture, 1, 0);
    assert_true(different(free_camera, moved) > WIDTH * HEIGHT / 10);
    dpl_renderer_path(fixture->renderer, false);
    struct dpl_image *stays = picture(fixture, 1, 0);
    assert_int_equal(different(free_camera, stays), 0);
    struct dpl_view view = dpl_scene_view(fixture->scene, 1);
    support_set(fixture->scene, "camera.position", "%.17g %.17g %.17g", view.position[0], view.position[1],
                view.position[2]);
    support_set(fixture->scene, "camera.target", "%.17g %.17g %.17g", view.target[0], view.target[1], view.target[2]);
    support_set(fixture->scene, "camera.field_of_view", "%.17g", view.field_of_view);
    struct dpl_image *placed = picture(fixture, 1, 0);
    assert_int_equal(different(moved, placed), 0);
    dpl_renderer_path(fixture->renderer, true);
    dpl_image_destroy(free_camera);
    dpl_image_destroy(moved);
    dpl_image_destroy(stays);
    dpl_image_destroy(placed);
}

/* Tiles, and how much of them is drawn, cover a picture once, whatever its size. */
static void check_cut(struct fixture *fixture)
{
    static const int sizes[][2] = {{1, 1}, {16384, 16384}, {16384, 3}, {5000, 700}, {1920, 1080}};
    const struct picture limited = {.side_max = 96}, free_size = {0};
    for (int s = 0; s < 5; s++) {
        for (int margin = 0; margin <= 20; margin += 10) {
            struct picture_tiles tiles =
                picture_cut(s < 3 ? &free_size : &limited, fixture->gl, sizes[s][0], sizes[s][1], 4, margin);
            long seen = 0;
            for (int i = 0; i < tiles.columns * tiles.rows; i++) {
                struct camera_view view = picture_view(&tiles, i);
                assert_true(view.left >= 0 && view.left + view.columns <= sizes[s][0]);
                assert_true(view.bottom >= 0 && view.bottom + view.rows <= sizes[s][1]);
                assert_true(view.columns <= (s < 3 ? fixture->gl->info.texture_max : 96));
                assert_true((long)view.columns * view.rows * 4 <= 1 << 25);
                seen += (long)view.columns * view.rows;
            }
            long pixels = (long)sizes[s][0] * sizes[s][1];
            assert_true(tiles.margin ? seen > pixels : seen == pixels);
        }
    }
}

static void check(bool es)
{
    struct fixture fixture;
    start(&fixture, es);
    check_looks(&fixture);
    check_comparison(&fixture);
    check_path(&fixture);
    check_cut(&fixture);
    finish(&fixture);
}

static void tiles_make_the_picture(void **state)
{
    (void)state;
    check(false);
}

static void tiles_make_the_picture_in_es(void **state)
{
    (void)state;
    check(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tiles_make_the_picture),
        cmocka_unit_test(tiles_make_the_picture_in_es),
    };
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
