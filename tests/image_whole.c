/* A picture's file appears whole or not at all: after a failure there is what was there before, and nothing else. */
#include "support.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

static const char *const names[] = {"a.png", "a.exr", "a.pfm", NULL};

struct fixture {
    struct support_log log;
    char folder[64], path[512];
    struct dpl_image *image;
};

static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    support_log_start(&fixture->log);
    support_folder_make(fixture->folder);
    fixture->image = dpl_image_create(200, 100, NULL);
    uint64_t random = 1;
    for (int i = 0; i < 200 * 100 * 3; i++)
        fixture->image->pixels[i] = (float)support_random_unit(&random);
    *state = fixture;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *fixture = *state;
    support_folder_count(fixture->folder, true);
    dpl_image_destroy(fixture->image);
    free(fixture);
    return 0;
}

static const char *path_of(struct fixture *fixture, const char *name)
{
    snprintf(fixture->path, sizeof fixture->path, "%s/%s", fixture->folder, name);
    return fixture->path;
}

static bool save(struct fixture *fixture)
{
    return dpl_image_save(fixture->image, fixture->path, NULL, &fixture->log.log);
}

/* Saves while no file may grow beyond that size, as on a disk that is full. */
static bool save_on_full_disk(struct fixture *fixture, rlim_t bytes)
{
    struct rlimit old, small;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &old), 0);
    void (*handler)(int) = signal(SIGXFSZ, SIG_IGN);
    small = (struct rlimit){bytes, old.rlim_max};
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    bool ok = save(fixture);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &old), 0);
    signal(SIGXFSZ, handler);
    return ok;
}

static long long size_of(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 ? (long long)status.st_size : -1;
}

static void a_full_disk_leaves_nothing(void **state)
{
    /* within the first bytes, within a buffer of the C library, in the middle, and at the last byte */
    struct fixture *fixture = *state;
    for (int i = 0; names[i]; i++) {
        path_of(fixture, names[i]);
        assert_true(save(fixture));
        long long whole = size_of(fixture->path);
        const long long limits[] = {0, 1, 100, 4096, whole / 2, whole - 1};
        assert_int_equal(unlink(fixture->path), 0);
        for (int k = 0; k < 6; k++) {
            assert_false(save_on_full_disk(fixture, (rlim_t)limits[k]));
            EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_WRITE, fixture->path);
            assert_int_equal(support_folder_count(fixture->folder, false), 0);
        }
        assert_true(save_on_full_disk(fixture, (rlim_t)whole));
        assert_int_equal(size_of(fixture->path), whole);
        assert_int_equal(unlink(fixture->path), 0);
    }
}

static void a_full_disk_keeps_the_old_file(void **state)
{
    struct fixture *fixture = *state;
    for (int i = 0; names[i]; i++) {
        char text[16] = "";
        FILE *stream = fopen(path_of(fixture, names[i]), "wb");
        fputs("old", stream);
        fclose(stream);
        assert_false(save_on_full_disk(fixture, 5000));
        EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_WRITE, fixture->path);
        stream = fopen(fixture->path, "rb");
        assert_int_equal(fread(text, 1, sizeof text - 1, stream), 3);
        fclose(stream);
        assert_string_equal(text, "old");
        assert_int_equal(support_folder_count(fixture->folder, false), i + 1);
        assert_true(save(fixture));
        assert_true(size_of(fixture->path) > 1000);
    }
}

static void a_folder_is_no_file(void **state)
{
    struct fixture *fixture = *state;
    for (int i = 0; names[i]; i++) {
        assert_int_equal(mkdir(path_of(fixture, names[i]), 0777), 0);
        assert_false(save(fixture));
        EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_WRITE, fixture->path, "directory");
        assert_int_equal(support_folder_count(fixture->folder, false), i + 1);
    }
}

static void a_missing_folder_is_named(void **state)
{
    struct fixture *fixture = *state;
    path_of(fixture, "no/a.png");
    assert_false(save(fixture));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_WRITE, fixture->path, "No such file or directory");
    path_of(fixture, "file");
    fclose(fopen(fixture->path, "wb"));
    path_of(fixture, "file/a.png");
    assert_false(save(fixture));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_WRITE, fixture->path, "Not a directory");
    char *name = malloc(10000);
    memset(name, 'x', 10000);
    strcpy(name + 9990, ".png");
    assert_false(dpl_image_save(fixture->image, name, NULL, &fixture->log.log));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_WRITE, "xxxx", "too long");
    free(name);
}

static void a_folder_that_must_not_be_written_is_named(void **state)
{
    struct fixture *fixture = *state;
    path_of(fixture, "a.png");
    bool root = support_leave_root(fixture->folder);
    chmod(fixture->folder, 0555);
    bool saved = save(fixture);
    chmod(fixture->folder, 0755);
    support_become_root(root);
    assert_false(saved);
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_WRITE, fixture->path, "ermission denied");
    assert_int_equal(support_folder_count(fixture->folder, false), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_full_disk_leaves_nothing, setup, teardown),
        cmocka_unit_test_setup_teardown(a_full_disk_keeps_the_old_file, setup, teardown),
        cmocka_unit_test_setup_teardown(a_folder_is_no_file, setup, teardown),
        cmocka_unit_test_setup_teardown(a_missing_folder_is_named, setup, teardown),
        cmocka_unit_test_setup_teardown(a_folder_that_must_not_be_written_is_named, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
