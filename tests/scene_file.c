/* Scenes in files: what cannot be read, and that a saved scene is the same scene. */
#include "support.h"

#include <sys/stat.h>

struct fixture {
    struct support_log log;
    struct dpl_scene *scene;
    char folder[64];
};

static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    fixture->scene = dpl_scene_create(support_log_start(&fixture->log));
    support_folder_make(fixture->folder);
    *state = fixture;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *fixture = *state;
    dpl_scene_destroy(fixture->scene);
    support_folder_count(fixture->folder, true);
    free(fixture);
    return 0;
}

static const char *path_of(const struct fixture *fixture, const char *name, char path[512])
{
    snprintf(path, 512, "%s/%s", fixture->folder, name);
    return path;
}

static void write_file(const char *path, const char *text, size_t length)
{
    FILE *stream = fopen(path, "wb");
    assert_non_null(stream);
    assert_int_equal(fwrite(text, 1, length, stream), length);
    assert_int_equal(fclose(stream), 0);
}

/* The whole file as text; the caller frees it. */
static char *file_text(const char *path)
{
    char *text = calloc(1, 65536);
    FILE *stream = fopen(path, "rb");
    assert_non_null(stream);
    assert_true(fread(text, 1, 65535, stream) > 0);
    fclose(stream);
    return text;
}

/* Every value of the scene in one text, sections that are not in use included; the caller frees it. */
static char *all_values(const struct dpl_scene *scene)
{
    size_t size = 1 << 18, used = 0;
    char *text = malloc(size);
    for (int i = 0; dpl_scene_section(scene, i).name; i++) {
        struct dpl_section section = dpl_scene_section(scene, i);
        for (const struct dpl_param *param = section.params; param->name; param++) {
            char value[512];
            assert_true(dpl_param_format(param, section.values, value, sizeof value));
            used += (size_t)snprintf(text + used, size - used, "%s.%s=%s\n", section.name, param->name, value);
        }
    }
    return text;
}

/* Saves, loads into another scene, saves that: the same values, and the same bytes. */
static void expect_same_after_saving(struct fixture *fixture)
{
    char first[512], second[512];
    struct dpl_scene *other = dpl_scene_create(&fixture->log.log);
    assert_true(dpl_scene_save(fixture->scene, path_of(fixture, "first.ini", first)));
    if (!dpl_scene_load(other, first))
        fail_msg("%s", fixture->log.text);
    assert_true(dpl_scene_save(other, path_of(fixture, "second.ini", second)));
    char *text_first = file_text(first), *text_second = file_text(second);
    char *values_first = all_values(fixture->scene), *values_second = all_values(other);
    assert_string_equal(text_first, text_second);
    assert_string_equal(values_first, values_second);
    assert_int_equal(support_folder_count(fixture->folder, false), 2);
    free(text_first);
    free(text_second);
    free(values_first);
    free(values_second);
    dpl_scene_destroy(other);
}

static void built_in_scenes_are_the_same_after_saving(void **state)
{
    struct fixture *fixture = *state;
    int count = 0;
    for (const struct dpl_builtin_scene *scene = dpl_builtin_scenes(); scene->name; scene++, count++) {
        assert_true(strlen(scene->summary) > 0);
        if (!dpl_scene_load(fixture->scene, scene->name))
            fail_msg("%s", fixture->log.text);
        expect_same_after_saving(fixture);
    }
    assert_true(count >= 4);
}

/* Another value than the default for every entry, in sections that the scene does not use as well. */
static void set_everything(struct fixture *fixture, uint64_t *random)
{
    for (int i = 0; dpl_scene_section(fixture->scene, i).name; i++) {
        struct dpl_section section = dpl_scene_section(fixture->scene, i);
        for (const struct dpl_param *param = section.params; param->name; param++) {
            char key[128], text[256] = "";
            snprintf(key, sizeof key, "%s.%s", section.name, param->name);
            for (int k = 0; k < param->count; k++) {
                double number = param->minimum + support_random_unit(random) * (param->maximum - param->minimum);
                number = param->type == DPL_PARAM_INT || param->type == DPL_PARAM_BOOL ? (double)(int)number : number;
                sprintf(text + strlen(text), "%.17g ", number);
            }
            if (param->type == DPL_PARAM_BOOL)
                snprintf(text, sizeof text, "%s", param->initial[0] != 0 ? "no" : "yes");
            else if (param->type == DPL_PARAM_CHOICE)
                snprintf(text, sizeof text, "%s", param->choice(param->choice(1) != NULL));
            else if (param->type == DPL_PARAM_TEXT)
                snprintf(text, sizeof text, "%*s", DPL_PARAM_TEXT_SIZE - 1, "a/b c=[d]#e;f:g.png");
            for (char *c = text; param->type == DPL_PARAM_TEXT && *c == ' '; c++)
                *c = c == text ? '/' : 'x';
            if (!dpl_scene_set(fixture->scene, key, text))
                fail_msg("%s", fixture->log.text);
        }
    }
}

static void any_scene_is_the_same_after_saving(void **state)
{
    struct fixture *fixture = *state;
    uint64_t random = 7;
    expect_same_after_saving(fixture);
    for (int i = 0; i < 20; i++) {
        char key[32];
        snprintf(key, sizeof key, "wave.%d.phase", 1 + i * 3);
        support_set(fixture->scene, key, "0");
        snprintf(key, sizeof key, "object.n%d.seed", i);
        support_set(fixture->scene, key, "1");
        set_everything(fixture, &random);
        support_set(fixture->scene, "water.model", i % 2 ? "sines" : "collard");
        expect_same_after_saving(fixture);
    }
}

static void a_wave_and_an_object_of_defaults_are_kept(void **state)
{
    struct fixture *fixture = *state;
    support_set(fixture->scene, "object.a.turn", "0");
    support_set(fixture->scene, "wave.5.phase", "0");
    support_set(fixture->scene, "water.model", "collard");
    expect_same_after_saving(fixture);
}

static void text_that_a_scene_cannot_hold_is_refused(void **state)
{
    static const char *const texts[] = {"a\nb.png", "a.png\n[sun]\nelevation = 1",
                                        "a\rb",     "a\tb",
                                        " a.png",   "a.png ",
                                        " ",        "a #b.png",
                                        "a ;b.png", "#a.png",
                                        ";a.png",   NULL};
    struct fixture *fixture = *state;
    for (int i = 0; texts[i]; i++) {
        if (dpl_scene_set(fixture->scene, "multi-sample.sun_map", texts[i]))
            fail_msg("takes \"%s\"", texts[i]);
        EXPECT_ERROR(&fixture->log, DPL_REASON_VALUE, "multi-sample.sun_map", "text of at most");
    }
}

static void files_that_cannot_be_read_are_named(void **state)
{
    struct fixture *fixture = *state;
    char path[512];
    path_of(fixture, "missing.ini", path);
    assert_false(dpl_scene_load(fixture->scene, path));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_READ, path, "built-in");
    assert_false(dpl_scene_load(fixture->scene, ""));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_READ, "built-in");
    assert_false(dpl_scene_load(fixture->scene, fixture->folder));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_READ, fixture->folder, "not a regular file");
    assert_false(dpl_scene_load(fixture->scene, "/dev/zero"));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_READ, "/dev/zero", "not a regular file");

    size_t size = (1 << 20) + 1;
    char *blanks = malloc(size);
    memset(blanks, '\n', size);
    write_file(path_of(fixture, "large.ini", path), blanks, size);
    free(blanks);
    assert_false(dpl_scene_load(fixture->scene, path));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_READ, path, "1048577", "1048576");

    write_file(path_of(fixture, "secret.ini", path), "[sun]\n", 6);
    assert_int_equal(chmod(path, 0), 0);
    bool root = support_leave_root(fixture->folder);
    bool loaded = dpl_scene_load(fixture->scene, path);
    support_become_root(root);
    assert_false(loaded);
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_READ, path, "ermission denied");
}

static void a_file_goes_before_a_built_in_scene(void **state)
{
    struct fixture *fixture = *state;
    char old[512], value[64];
    assert_non_null(getcwd(old, sizeof old));
    assert_int_equal(chdir(fixture->folder), 0);
    write_file("collard-1", "[sun]\nelevation = 3\n", 20);
    bool loaded = dpl_scene_load(fixture->scene, "collard-1");
    assert_int_equal(chdir(old), 0);
    assert_true(loaded);
    assert_true(dpl_scene_get(fixture->scene, "sun.elevation", value, sizeof value));
    assert_string_equal(value, "3");
}

static void file_is(const struct fixture *fixture, const char *folder, const char *name)
{
    char value[512], wanted[1024];
    snprintf(wanted, sizeof wanted, "%s/%s", folder, name);
    assert_true(dpl_scene_get(fixture->scene, "heightfield.file", value, sizeof value));
    assert_string_equal(value, wanted);
}

/* In a scene's file from there; set by hand from where the program is; after saving still the same files. */
static void files_are_found_from_the_folder_of_the_scene(void **state)
{
    struct fixture *fixture = *state;
    static const char relative[] = "[heightfield]\nfile = maps/h.png\n",
                      rooted[] = "[heightfield]\nfile = /maps/h.png\n";
    char first[512], second[512], here[512];
    write_file(path_of(fixture, "first.ini", first), relative, strlen(relative));
    path_of(fixture, "second.ini", second);
    assert_non_null(getcwd(here, sizeof here));
    assert_true(dpl_scene_load(fixture->scene, first));
    file_is(fixture, fixture->folder, "maps/h.png");
    assert_true(dpl_scene_save(fixture->scene, second));
    char *text = file_text(second);
    assert_non_null(strstr(text, "\nfile = maps/h.png\n"));
    free(text);
    assert_true(dpl_scene_load(fixture->scene, second));
    file_is(fixture, fixture->folder, "maps/h.png");
    support_set(fixture->scene, "heightfield.file", "by/hand.png");
    assert_true(dpl_scene_save(fixture->scene, second));
    assert_true(dpl_scene_load(fixture->scene, second));
    file_is(fixture, here, "by/hand.png");
    write_file(first, rooted, strlen(rooted));
    assert_true(dpl_scene_load(fixture->scene, first));
    file_is(fixture, "/maps", "h.png");
    support_set(fixture->scene, "heightfield.file", "%0*d", DPL_PARAM_TEXT_SIZE - 1, 0);
    assert_false(dpl_scene_save(fixture->scene, second));
    EXPECT_ERROR(&fixture->log, DPL_REASON_LIMIT, second, "too long");
    assert_int_equal(support_folder_count(fixture->folder, false), 2);
}

/* A folder's name may hold what could not stand in scene text. */
static void files_are_found_in_any_folder(void **state)
{
    struct fixture *fixture = *state;
    static const char text[] = "[heightfield]\nfile = h.png\n";
    char folder[512], path[600], here[512];
    assert_int_equal(mkdir(path_of(fixture, "sea #2", folder), 0777), 0);
    snprintf(path, sizeof path, "%s/a.ini", folder);
    write_file(path, text, strlen(text));
    assert_true(dpl_scene_load(fixture->scene, path));
    file_is(fixture, folder, "h.png");
    assert_true(dpl_scene_save(fixture->scene, path));
    assert_true(dpl_scene_load(fixture->scene, path));
    file_is(fixture, folder, "h.png");
    support_set(fixture->scene, "heightfield.file", "by-hand.png");
    assert_non_null(getcwd(here, sizeof here));
    assert_int_equal(chdir(folder), 0);
    char other[512];
    assert_false(dpl_scene_save(fixture->scene, path_of(fixture, "b.ini", other)));
    assert_int_equal(chdir(here), 0);
    EXPECT_ERROR(&fixture->log, DPL_REASON_VALUE, other, "cannot stand in scene text");
    unlink(path);
    rmdir(folder);
}

static void names_that_are_nearly_right_are_told(void **state)
{
    struct fixture *fixture = *state;
    assert_false(dpl_scene_load(fixture->scene, "colard-1"));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_READ, "colard-1", "did you mean \"collard-1\"");
    assert_false(dpl_scene_set(fixture->scene, "wafer.model", "sines"));
    EXPECT_ERROR(&fixture->log, DPL_REASON_UNKNOWN_SECTION, "wafer", "did you mean \"water\"");
    assert_false(dpl_scene_set(fixture->scene, "sun.elevaiton", "3"));
    EXPECT_ERROR(&fixture->log, DPL_REASON_UNKNOWN_KEY, "elevaiton", "did you mean \"elevation\"");
    assert_false(dpl_scene_set(fixture->scene, "sun.brightness", "3"));
    assert_null(strstr(fixture->log.text, "did you mean"));
    EXPECT_ERROR(&fixture->log, DPL_REASON_UNKNOWN_KEY, "brightness", "(accepted: ");
}

static void a_scene_that_cannot_be_saved_says_so(void **state)
{
    struct fixture *fixture = *state;
    char path[512];
    assert_false(dpl_scene_save(fixture->scene, path_of(fixture, "no/such/folder.ini", path)));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_WRITE, path, "cannot be written");
    assert_false(dpl_scene_save(fixture->scene, fixture->folder));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_WRITE, fixture->folder, "directory");
    assert_int_equal(support_folder_count(fixture->folder, false), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(built_in_scenes_are_the_same_after_saving, setup, teardown),
        cmocka_unit_test_setup_teardown(any_scene_is_the_same_after_saving, setup, teardown),
        cmocka_unit_test_setup_teardown(a_wave_and_an_object_of_defaults_are_kept, setup, teardown),
        cmocka_unit_test_setup_teardown(text_that_a_scene_cannot_hold_is_refused, setup, teardown),
        cmocka_unit_test_setup_teardown(files_that_cannot_be_read_are_named, setup, teardown),
        cmocka_unit_test_setup_teardown(a_file_goes_before_a_built_in_scene, setup, teardown),
        cmocka_unit_test_setup_teardown(files_are_found_from_the_folder_of_the_scene, setup, teardown),
        cmocka_unit_test_setup_teardown(files_are_found_in_any_folder, setup, teardown),
        cmocka_unit_test_setup_teardown(names_that_are_nearly_right_are_told, setup, teardown),
        cmocka_unit_test_setup_teardown(a_scene_that_cannot_be_saved_says_so, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
