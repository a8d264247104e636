/* What is true of every technique on every water, without OpenGL; the box blur; and what a renderer without OpenGL
 * says no to. */
#include "support.h"

#include "base/threads.h"
#include "light/blur.h"
#include "scene/scene.h"

#include <math.h>

struct fixture {
    struct support_log log;
    struct dpl_renderer *renderer;
    struct dpl_scene *scene;
    char folder[64]; /* of a picture for the model that reads one */
};

static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    support_log_start(&fixture->log);
    fixture->renderer = dpl_renderer_create(NULL, DPL_DEVICE_AUTO, &fixture->log.log);
    fixture->scene = support_scene("[wave.1]\ncycles = 3 2\namplitude = 0.05\n[caustics]\nmap = 49\nmesh = 40\n"
                                   "[reference]\nphotons = 8\n[photons]\ncount = 1\n[hemisphere]\ncandidates = 4\n"
                                   "[precomputed]\nside = 32\nframes = 3\n[ripples]\nside = 64\n",
                                   &fixture->log.log);
    char path[96];
    support_folder_make(fixture->folder);
    snprintf(path, sizeof path, "%s/heights.pfm", fixture->folder);
    support_heights_write(path);
    support_set(fixture->scene, "heightfield.file", "%s", path);
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

/* The map of a time, whole and finite; the caller destroys it. */
static struct dpl_image *map_of(struct fixture *fixture, double time)
{
    struct dpl_image *map = dpl_renderer_map(fixture->renderer, fixture->scene, time);
    if (!map)
        fail_msg("%s", fixture->log.text);
    for (int i = 0; i < map->width * map->height * 3; i++)
        assert_true(isfinite(map->pixels[i]) && map->pixels[i] >= 0);
    return map;
}

static bool same(const struct dpl_image *a, const struct dpl_image *b)
{
    return a->width == b->width && a->height == b->height &&
           !memcmp(a->pixels, b->pixels, (size_t)(a->width * a->height * 3) * sizeof(float));
}

/* Calls `check` with each technique on periodic and on bounded water set in the scene, and with the first technique on
 * every water. (tests/every.c has all pairs.) */
static void every_light(struct fixture *fixture, void (*check)(struct fixture *fixture))
{
    for (int t = 0; light_techniques[t]; t++) {
        for (int w = 0; water_models[w]; w++) {
            bool simple = w == 0 || !strcmp(water_models[w]->name, "collard");
            if (t > 0 && !simple)
                continue;
            support_set(fixture->scene, "caustics.technique", "%s", light_techniques[t]->name);
            support_set(fixture->scene, "water.model", "%s", water_models[w]->name);
            if (light_techniques[t]->trace)
                check(fixture);
        }
    }
}

static const char *water_of(const struct fixture *fixture)
{
    return water_models[fixture->scene->medium.model]->name;
}

static void check_bytes(struct fixture *fixture)
{
    struct dpl_image *first = map_of(fixture, 1.5), *other = map_of(fixture, 1.6), *again = map_of(fixture, 1.5);
    if (strcmp(water_of(fixture), "heightfield")) /* one picture does not move */
        assert_false(same(first, other));
    assert_true(same(first, again));
    dpl_image_destroy(again);
#ifdef _OPENMP
    for (int threads = 1; threads <= 5; threads++) {
        omp_set_num_threads(threads);
        again = map_of(fixture, 1.5);
        assert_true(same(first, again));
        dpl_image_destroy(again);
    }
    omp_set_num_threads(omp_get_num_procs());
#endif
    dpl_renderer_destroy(fixture->renderer);
    fixture->renderer = dpl_renderer_create(NULL, DPL_DEVICE_CPU, &fixture->log.log);
    again = map_of(fixture, 1.5);
    assert_true(same(first, again));
    dpl_image_destroy(first);
    dpl_image_destroy(other);
    dpl_image_destroy(again);
}

static void the_same_bytes_whatever_came_before_and_however_many_threads(void **state)
{
    every_light(*state, check_bytes);
}

/* A finite map, or a clear no where the technique does not serve the scene: no ceiling by one that maps no reflected
 * light. */
static void check_map_or_refusal(struct fixture *fixture, const char *key)
{
    struct dpl_image *map = strcmp(key, "caustics.ceiling") ? map_of(fixture, 0.7)
                                                            : dpl_renderer_map(fixture->renderer, fixture->scene, 0.7);
    if (!map)
        EXPECT_ERROR(&fixture->log, DPL_REASON_UNSUPPORTED, "caustics.ceiling", "accepted: 0");
    dpl_image_destroy(map);
}

/* Every number of the technique, the water and the map at both ends of its range; sides and counts stay small. On other
 * water than the first its own numbers alone. */
static void check_ends(struct fixture *fixture)
{
    for (int i = 0; dpl_scene_section(fixture->scene, i).name; i++) {
        struct dpl_section section = dpl_scene_section(fixture->scene, i);
        if (fixture->scene->medium.model > 0 && strcmp(section.name, water_of(fixture)))
            continue;
        for (const struct dpl_param *param = section.params; section.active && param->name; param++) {
            bool number = param->count == 1 && (param->type == DPL_PARAM_FLOAT || param->type == DPL_PARAM_INT);
            bool large = param->type == DPL_PARAM_INT && param->maximum > 200;
            char key[128], before[64];
            snprintf(key, sizeof key, "%s.%s", section.name, param->name);
            assert_true(dpl_scene_get(fixture->scene, key, before, sizeof before));
            for (int end = 0; number && end < 2; end++) {
                support_set(fixture->scene, key, "%.17g", end == 0 ? param->minimum : large ? 200 : param->maximum);
                check_map_or_refusal(fixture, key);
            }
            support_set(fixture->scene, key, "%s", before);
        }
    }
}

static void maps_are_finite_at_the_ends_of_every_range(void **state)
{
    every_light(*state, check_ends);
}

static void water_that_touches_the_floor_is_finite(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "scene.depth", "0");
    support_set(fixture->scene, "caustics.depth_bias", "0");
    every_light(fixture, check_ends);
}

static void expect_blurred(const float *from, const float *to, int side, int channels, int width)
{
    for (int j = 0; j < side; j++) {
        for (int i = 0; i < side * channels; i++) {
            double sum = 0;
            for (int z = -width; z < width; z++)
                for (int x = -width; x < width; x++)
                    sum += (double)from[(j + z + 10 * side) % side * side * channels +
                                        (i / channels + x + 10 * side) % side * channels + i % channels];
            double wanted = width ? sum / (4.0 * width * width) : (double)from[j * side * channels + i];
            assert_true(fabs((double)to[j * side * channels + i] - wanted) < 1e-6); /* single precision */
        }
    }
}

/* The mean of the (2 width)² texels from -width to width - 1, the map repeated; maps smaller than that included. */
static void a_blur_is_the_mean_of_its_square(void **state)
{
    static const int sides[] = {1, 2, 3, 5, 8, 41};
    uint64_t random = 11;
    (void)state;
    for (int k = 0; k < 6; k++) {
        for (int channels = 1; channels <= 3; channels += 2) {
            for (int width = 0; width <= 5; width++) {
                struct light_map map = {0};
                struct light_blur blur = {0};
                assert_true(light_map_resize(&map, sides[k], channels, 1, NULL));
                size_t count = (size_t)(sides[k] * sides[k] * channels);
                float *before = malloc(count * sizeof *before);
                for (size_t i = 0; i < count; i++)
                    before[i] = map.texels[i] = (float)support_random_unit(&random);
                assert_true(blur_map(&blur, &map, width, NULL));
                expect_blurred(before, map.texels, sides[k], channels, width);
                free(before);
                light_map_finish(&map);
                blur_finish(&blur, NULL);
            }
        }
    }
}

static void a_scene_asks_for_its_blur(void **state)
{
    struct fixture *fixture = *state;
    struct dpl_image *sharp = map_of(fixture, 1);
    for (int width = 0; width <= 3; width++) {
        support_set(fixture->scene, "caustics.blur", "%d", width);
        struct dpl_image *blurred = map_of(fixture, 1);
        expect_blurred(sharp->pixels, blurred->pixels, sharp->width, 3, width);
        dpl_image_destroy(blurred);
    }
    dpl_image_destroy(sharp);
}

static void a_sun_map_from_a_file_is_used(void **state)
{
    struct fixture *fixture = *state;
    char folder[64], path[128];
    support_folder_make(folder);
    snprintf(path, sizeof path, "%s/sun.png", folder);
    support_set(fixture->scene, "caustics.technique", "multi-sample");
    support_set(fixture->scene, "multi-sample.sun_map", "%s", path);
    assert_null(dpl_renderer_map(fixture->renderer, fixture->scene, 1));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_READ, path);
    struct dpl_image *wide = dpl_image_create(3, 2, NULL), *white = dpl_image_create(4, 4, NULL);
    assert_true(dpl_image_save(wide, path, NULL, &fixture->log.log));
    assert_null(dpl_renderer_map(fixture->renderer, fixture->scene, 1));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_FORMAT, path, "3 × 2", "square");
    for (int i = 0; i < 48; i++)
        white->pixels[i] = 1;
    assert_true(dpl_image_save(white, path, NULL, &fixture->log.log));
    /* one sample, white everywhere: base_intensity to the power of depth + bias + 1 */
    support_set(fixture->scene, "multi-sample.steps", "1");
    struct dpl_image *map = map_of(fixture, 1);
    for (int i = 0; i < map->width * map->height * 3; i++)
        assert_true(fabs((double)map->pixels[i] - pow(0.6, 2.6)) < 1e-5);
    dpl_image_destroy(map);
    dpl_image_destroy(wide);
    dpl_image_destroy(white);
    support_folder_count(folder, true);
}

static void without_opengl_there_is_no_picture(void **state)
{
    struct fixture *fixture = *state;
    assert_null(dpl_renderer_picture(fixture->renderer, fixture->scene, 0, 64, 64));
    EXPECT_ERROR(&fixture->log, DPL_REASON_NO_GL, "OpenGL");
    assert_false(dpl_renderer_draw(fixture->renderer, fixture->scene, 0, 0, 64, 64));
    EXPECT_ERROR(&fixture->log, DPL_REASON_NO_GL, "OpenGL");
    assert_null(dpl_renderer_thumbnail(fixture->renderer, 0).name);
    struct dpl_image *surface = dpl_renderer_surface(fixture->renderer, fixture->scene, 0);
    assert_non_null(surface);
    assert_int_equal(surface->width, 40);
    dpl_image_destroy(surface);
    dpl_renderer_destroy(NULL);
    assert_int_equal(fixture->log.errors, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(the_same_bytes_whatever_came_before_and_however_many_threads, setup, teardown),
        cmocka_unit_test_setup_teardown(maps_are_finite_at_the_ends_of_every_range, setup, teardown),
        cmocka_unit_test_setup_teardown(water_that_touches_the_floor_is_finite, setup, teardown),
        cmocka_unit_test_setup_teardown(a_blur_is_the_mean_of_its_square, setup, teardown),
        cmocka_unit_test_setup_teardown(a_scene_asks_for_its_blur, setup, teardown),
        cmocka_unit_test_setup_teardown(a_sun_map_from_a_file_is_used, setup, teardown),
        cmocka_unit_test_setup_teardown(without_opengl_there_is_no_picture, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
