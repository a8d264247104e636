/* The technique `reference` as a renderer uses it: refining, stopping, going on, files, and the noise it states. */
#include "support.h"

#include "base/threads.h"
#include "scene/scene.h"

#include <math.h>
#include <sys/stat.h>

struct fixture {
    struct support_log log;
    struct dpl_scene *scene;
    struct dpl_renderer *renderer;
    char folder[64], path[80];
    int steps, stop_after; /* of the progress; 0: never */
    double done;
};

static bool step(void *user, double done)
{
    struct fixture *fixture = user;
    assert_true(done > fixture->done && done <= 1);
    fixture->done = done;
    return ++fixture->steps != fixture->stop_after;
}

/* A renderer that has seen nothing. */
static void renew(struct fixture *fixture, int stop_after)
{
    dpl_renderer_destroy(fixture->renderer);
    fixture->renderer = dpl_renderer_create(NULL, DPL_DEVICE_CPU, &fixture->log.log);
    fixture->stop_after = stop_after;
    dpl_renderer_progress(fixture->renderer, step, fixture);
}

static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    support_log_start(&fixture->log);
    support_folder_make(fixture->folder);
    snprintf(fixture->path, sizeof fixture->path, "%s/photons", fixture->folder);
    fixture->scene =
        support_scene("[scene]\nsize = 2\n[wave.1]\ncycles = 3 2\namplitude = 0.02\n"
                      "[wave.2]\ncycles = -1 4\namplitude = 0.01\n"
                      "[caustics]\ntechnique = reference\nmap = 48\nslices = 2\n[reference]\nphotons = 80\n",
                      &fixture->log.log);
    renew(fixture, 0);
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

static struct dpl_image *map_of(struct fixture *fixture)
{
    fixture->steps = 0;
    fixture->done = 0;
    struct dpl_image *map = dpl_renderer_map(fixture->renderer, fixture->scene, 1.5);
    if (!map)
        fail_msg("%s", fixture->log.text);
    return map;
}

static size_t bytes_of(const struct dpl_image *map)
{
    return (size_t)map->width * (size_t)map->height * 3 * sizeof *map->pixels;
}

/* Has the map, which has to be `wanted`. */
static void expect_map(struct fixture *fixture, const struct dpl_image *wanted, int steps)
{
    struct dpl_image *map = map_of(fixture);
    assert_int_equal(fixture->steps, steps);
    assert_memory_equal(map->pixels, wanted->pixels, bytes_of(map));
    dpl_image_destroy(map);
}

static char *read_file(const char *path, size_t *size)
{
    FILE *stream = fopen(path, "rb");
    assert_non_null(stream);
    struct stat status;
    fstat(fileno(stream), &status);
    *size = (size_t)status.st_size;
    char *bytes = malloc(*size + 1);
    assert_int_equal(fread(bytes, 1, *size, stream), *size);
    fclose(stream);
    return bytes;
}

static void write_file(const char *path, const char *bytes, size_t size)
{
    FILE *stream = fopen(path, "wb");
    assert_non_null(stream);
    assert_int_equal(fwrite(bytes, 1, size, stream), size);
    fclose(stream);
}

/* Eight photons a texel are a step: two for each of four strata. */
static void steps_are_told_and_a_finished_map_stays(void **state)
{
    struct fixture *fixture = *state;
    struct dpl_image *map = map_of(fixture);
    assert_int_equal(fixture->steps, 10);
    assert_true(fixture->done == 1);
    expect_map(fixture, map, 0);
    dpl_renderer_progress(fixture->renderer, NULL, NULL);
    support_set(fixture->scene, "reference.photons", "81");
    struct dpl_image *more = map_of(fixture);
    assert_memory_not_equal(map->pixels, more->pixels, bytes_of(map));
    support_set(fixture->scene, "reference.photons", "80");
    expect_map(fixture, map, 0);
    dpl_image_destroy(more);
    dpl_image_destroy(map);
}

static void a_stopped_map_goes_on(void **state)
{
    struct fixture *fixture = *state;
    struct dpl_image *whole = map_of(fixture);
    renew(fixture, 3);
    struct dpl_image *part = map_of(fixture);
    assert_int_equal(fixture->steps, 3);
    assert_memory_not_equal(part->pixels, whole->pixels, bytes_of(part));
    fixture->stop_after = 0;
    expect_map(fixture, whole, 7);
    dpl_image_destroy(part);
    dpl_image_destroy(whole);
}

/* Everything that a result depends on: with it changed the count starts anew, and is what it is from nothing. */
static void nothing_is_kept_of_another_scene(void **state)
{
    static const char *const settings[][2] = {
        {"scene.size", "3"},         {"scene.depth", "2"},         {"scene.loop", "7"},
        {"sun.elevation", "40"},     {"sun.azimuth", "90"},        {"sun.angular_radius", "1"},
        {"water.ior", "1.4"},        {"water.dispersion", "0.01"}, {"water.absorption", "1 1 1"},
        {"wave.2.phase", "10"},      {"wave.3.amplitude", "0.02"}, {"caustics.slices", "3"},
        {"caustics.map", "47"},      {"caustics.ceiling", "1"},    {"water.model", "collard"},
        {"collard.wave", "preset-4"}};
    struct fixture *fixture = *state;
    support_set(fixture->scene, "reference.photons", "8");
    struct dpl_image *before = map_of(fixture);
    for (size_t i = 0; i < sizeof settings / sizeof *settings; i++) {
        support_set(fixture->scene, settings[i][0], "%s", settings[i][1]);
        struct dpl_image *after = map_of(fixture);
        assert_int_equal(fixture->steps, 1);
        assert_true(bytes_of(before) != bytes_of(after) || !strcmp(settings[i][0], "caustics.slices") ||
                    memcmp(before->pixels, after->pixels, bytes_of(before)) != 0);
        dpl_image_destroy(before);
        before = after;
    }
    renew(fixture, 0);
    expect_map(fixture, before, 1);
    dpl_image_destroy(before);
}

/* Stopped three times, each time in a new renderer, on other numbers of threads: same map, same file. */
static void a_file_goes_on_to_the_same_bytes(void **state)
{
    struct fixture *fixture = *state;
    size_t size, again_size;
    support_set(fixture->scene, "reference.file", "%s", fixture->path);
    struct dpl_image *whole = map_of(fixture);
    char *wanted = read_file(fixture->path, &size), *again;
    assert_int_equal(size, 48 + 2 * 2 * 48 * 48 * 3 * 8);
    unlink(fixture->path);
    for (int k = 0; k < 3; k++) {
#ifdef _OPENMP
        omp_set_num_threads(1 << k);
#endif
        renew(fixture, 3);
        dpl_image_destroy(map_of(fixture));
        assert_int_equal(support_folder_count(fixture->folder, false), 1);
    }
#ifdef _OPENMP
    omp_set_num_threads(omp_get_num_procs());
#endif
    renew(fixture, 0);
    expect_map(fixture, whole, 1);
    again = read_file(fixture->path, &again_size);
    assert_int_equal(size, again_size);
    assert_memory_equal(wanted, again, size);
    renew(fixture, 0);
    expect_map(fixture, whole, 0);
    free(wanted);
    free(again);
    dpl_image_destroy(whole);
}

/* Refused for that reason, and left as it is. */
static void expect_refused(struct fixture *fixture, const char *bytes, size_t size, const char *why)
{
    size_t size_after;
    write_file(fixture->path, bytes, size);
    renew(fixture, 0);
    assert_null(dpl_renderer_map(fixture->renderer, fixture->scene, 1.5));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_FORMAT, fixture->path, why);
    assert_null(dpl_renderer_map(fixture->renderer, fixture->scene, 1.5)); /* the second time too */
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_FORMAT, fixture->path, why);
    char *after = read_file(fixture->path, &size_after);
    assert_int_equal(size, size_after);
    assert_memory_equal(after, bytes, size);
    free(after);
}

static void wrong_files_are_refused_and_kept(void **state)
{
    struct fixture *fixture = *state;
    size_t size;
    support_set(fixture->scene, "reference.file", "%s", fixture->path);
    support_set(fixture->scene, "reference.photons", "8");
    dpl_image_destroy(map_of(fixture));
    char *bytes = read_file(fixture->path, &size);
    expect_refused(fixture, bytes, size - 1, "cut short");
    expect_refused(fixture, bytes, 30, "cut short");
    expect_refused(fixture, bytes, 0, "no photon counts");
    expect_refused(fixture, "# a scene\n", 10, "no photon counts");
    for (size_t place = 24; place < size; place += size / 40 * 8 + 1) { /* after what it belongs to */
        bytes[place] ^= 16;
        expect_refused(fixture, bytes, size, place >= 32 && place < 40 ? "cut short" : "damaged");
        bytes[place] ^= 16;
    }
    support_set(fixture->scene, "sun.azimuth", "31");
    expect_refused(fixture, bytes, size, "another scene");
    support_set(fixture->scene, "sun.azimuth", "30");
    renew(fixture, 0);
    dpl_image_destroy(map_of(fixture));
    support_set(fixture->scene, "reference.file", "%s/no/folder", fixture->folder);
    assert_null(dpl_renderer_map(fixture->renderer, fixture->scene, 1.5));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_WRITE, "no/folder");
    support_set(fixture->scene, "reference.file", "%s", fixture->folder);
    assert_null(dpl_renderer_map(fixture->renderer, fixture->scene, 1.5));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_READ, fixture->folder);
    free(bytes);
}

/* RMS difference of two maps, in units of the second's RMS. */
static double difference(const struct dpl_image *map, const struct dpl_image *truth)
{
    double sum = 0, square = 0;
    for (int i = 0; i < map->width * map->height * 3; i++) {
        sum += pow((double)map->pixels[i] - (double)truth->pixels[i], 2);
        square += pow((double)truth->pixels[i], 2);
    }
    return sqrt(sum / square);
}

static void the_noise_is_what_it_says(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "caustics.slices", "1");
    support_set(fixture->scene, "caustics.map", "32");
    for (int disc = 0; disc < 2; disc++) {
        support_set(fixture->scene, "sun.angular_radius", disc ? "0.2665" : "0");
        support_set(fixture->scene, "reference.photons", "3000");
        struct dpl_image *truth = map_of(fixture);
        double last = 1;
        for (int photons = 8; photons <= 128; photons *= 4) {
            support_set(fixture->scene, "reference.photons", "%d", photons);
            struct dpl_image *map = map_of(fixture);
            double noise = dpl_renderer_noise(fixture->renderer), wanted = difference(map, truth);
            if (!(noise > wanted / 1.5 && noise < wanted * 1.5 && noise < last / 1.7))
                fail_msg("noise %.5f for a difference of %.5f, %d photons", noise, wanted, photons);
            last = noise;
            dpl_image_destroy(map);
        }
        dpl_image_destroy(truth);
    }
}

static void a_wanted_noise_is_enough(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "reference.photons", "5000");
    support_set(fixture->scene, "reference.noise", "5");
    struct dpl_image *map = map_of(fixture);
    assert_true(dpl_renderer_noise(fixture->renderer) <= 0.05 && dpl_renderer_noise(fixture->renderer) > 0.04);
    assert_true(fixture->steps > 2 && fixture->steps < 1000 && fixture->done == 1);
    expect_map(fixture, map, 0);
    support_set(fixture->scene, "caustics.technique", "multi-sample");
    dpl_image_destroy(map_of(fixture));
    assert_true(dpl_renderer_noise(fixture->renderer) == 0);
    dpl_image_destroy(map);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(steps_are_told_and_a_finished_map_stays, setup, teardown),
        cmocka_unit_test_setup_teardown(a_stopped_map_goes_on, setup, teardown),
        cmocka_unit_test_setup_teardown(nothing_is_kept_of_another_scene, setup, teardown),
        cmocka_unit_test_setup_teardown(a_file_goes_on_to_the_same_bytes, setup, teardown),
        cmocka_unit_test_setup_teardown(wrong_files_are_refused_and_kept, setup, teardown),
        cmocka_unit_test_setup_teardown(the_noise_is_what_it_says, setup, teardown),
        cmocka_unit_test_setup_teardown(a_wanted_noise_is_enough, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
