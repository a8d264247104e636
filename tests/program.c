/* Shader programs: how files are put together, what is said when they are wrong, and that what works stays in use. */
#include "support.h"

#include "base/resource.h"
#include "gpu/program.h"

#include <sys/stat.h>

#define SCREEN "#include \"gpu/screen.glsl\"\n"

struct fixture {
    struct support_log log;
    char folder[64]; /* with subfolders gpu, light, … as the repository's src/ */
};

static const char *const subfolders[] = {"gpu", "light", "optics", "render", "scene", "water", NULL};

/* A folder with a copy of every shader that is built in. */
static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    char path[256];
    support_log_start(&fixture->log);
    support_folder_make(fixture->folder);
    for (int i = 0; subfolders[i]; i++) {
        snprintf(path, sizeof path, "%s/%s", fixture->folder, subfolders[i]);
        assert_int_equal(mkdir(path, 0777), 0);
    }
    for (const struct base_resource *resource = base_resources; resource->path; resource++)
        support_file_write(fixture->folder, resource->path, resource->text);
    *state = fixture;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *fixture = *state;
    char path[256];
    for (int i = 0; subfolders[i]; i++) {
        snprintf(path, sizeof path, "%s/%s", fixture->folder, subfolders[i]);
        support_folder_count(path, true);
    }
    support_folder_count(fixture->folder, true);
    free(fixture);
    return 0;
}

static int count(const char *text, const char *part)
{
    int times = 0;
    while ((text = strstr(text, part))) {
        times++;
        text += strlen(part);
    }
    return times;
}

/* The text of a fragment stage from the fixture's folder; the caller frees it. */
static char *source(struct fixture *fixture, const char *name, enum program_dialect dialect)
{
    return program_source(name, fixture->folder, dialect, PROGRAM_FRAGMENT, "#define STEPS 3\n", &fixture->log.log);
}

static void every_built_in_shader_is_found_and_has_its_dialect(void **state)
{
    struct fixture *fixture = *state;
    int shaders = 0;
    for (const struct base_resource *resource = base_resources; resource->path; resource++, shaders++) {
        for (int kind = 0; kind < 16; kind++) {
            static const char *const versions[] = {"#version 330 core\n", "#version 300 es\n", "#version 430 core\n",
                                                   "#version 310 es\n"};
            static const char *const defines[] = {"#define VERTEX\n", "#define FRAGMENT\n", "#define COMPUTE\n",
                                                  "#define GEOMETRY\n"};
            char *text = program_source(resource->path, NULL, (enum program_dialect)(kind % 4),
                                        (enum program_stage)(kind / 4), "", &fixture->log.log);
            assert_non_null(text);
            assert_int_equal(strncmp(text, versions[kind % 4], strlen(versions[kind % 4])), 0);
            assert_non_null(strstr(text, defines[kind / 4]));
            assert_int_equal(count(text, "#version"), 1);
            assert_null(strstr(text, "#include"));
            assert_true((strstr(text, "precision highp float;") != NULL) == (kind % 2));
            free(text);
        }
    }
    assert_true(shaders > 8);
    assert_null(base_resource_find("light/no.glsl"));
}

static void includes_are_expanded_once_each(void **state)
{
    struct fixture *fixture = *state;
    support_file_write(fixture->folder, "a.glsl", "first\n#include \"b.glsl\"\nafter b\n#include \"c.glsl\"\nlast");
    support_file_write(fixture->folder, "b.glsl", "in b\n#include \"c.glsl\"\n#include \"a.glsl\"\nend b\n");
    support_file_write(fixture->folder, "c.glsl", "in c\n");
    char *text = source(fixture, "a.glsl", PROGRAM_GL33);
    assert_string_equal(text, "#version 330 core\n#define FRAGMENT\n#define STEPS 3\n"
                              "#line 1 1\nfirst\n"
                              "#line 1 2\nin b\n"
                              "#line 1 3\nin c\n"
                              "#line 3 2\n"
                              "#line 4 2\nend b\n"
                              "#line 3 1\nafter b\n"
                              "#line 5 1\nlast");
    free(text);
}

static void a_missing_file_is_named(void **state)
{
    struct fixture *fixture = *state;
    char path[256];
    support_file_write(fixture->folder, "a.glsl", "#include \"gpu/no.glsl\"\n");
    snprintf(path, sizeof path, "%s/gpu/no.glsl", fixture->folder);
    assert_null(source(fixture, "a.glsl", PROGRAM_GL33));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_READ, path);
    assert_null(program_source("gpu/no.glsl", NULL, PROGRAM_GL33, PROGRAM_FRAGMENT, "", &fixture->log.log));
    EXPECT_ERROR(&fixture->log, DPL_REASON_SHADER, "gpu/no.glsl");
}

/* More files than the loader counts: an error, not an endless chain. */
static void too_many_includes_are_refused(void **state)
{
    struct fixture *fixture = *state;
    for (int i = 0; i < 40; i++) {
        char name[32], text[64];
        snprintf(name, sizeof name, "part%d.glsl", i);
        snprintf(text, sizeof text, "#include \"part%d.glsl\"\n", i < 39 ? i + 1 : 38);
        support_file_write(fixture->folder, name, text);
    }
    assert_null(source(fixture, "part0.glsl", PROGRAM_GL33));
    EXPECT_ERROR(&fixture->log, DPL_REASON_SHADER, "part", "16");
}

/* A context whose shaders come from the fixture's folder; NULL ends the test as skipped. */
static struct dpl_gl *open_context(struct fixture *fixture, bool es)
{
    struct dpl_gl *gl = dpl_gl_create_headless(es, fixture->folder, &fixture->log.log);
    if (!gl)
        skip();
    return gl;
}

static void check_errors(struct fixture *fixture, bool es)
{
    struct dpl_gl *gl = open_context(fixture, es);
    struct gpu_program program = {0};
    support_file_write(fixture->folder, "light/ok.glsl",
                       SCREEN "#ifdef FRAGMENT\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n#endif\n");
    support_file_write(fixture->folder, "a.glsl", SCREEN "#ifdef FRAGMENT\n#include \"light/ok.glsl\"\n#endif\n");
    assert_true(program_ready(gl, &program, "a.glsl", ""));
    GLuint name = program.name;
    support_file_write(fixture->folder, "light/ok.glsl", "\n\nout vec4 c;\nvoid main() { c = nonsense; }\n");
    assert_true(program_ready(gl, &program, "a.glsl", "")); /* nobody has asked for a reload */
    gl->generation++;
    assert_true(program_ready(gl, &program, "a.glsl", ""));
    assert_int_equal(program.name, name);
    /* the driver's words for line 4 of the third file (Mesa loses the 3), and which files those are */
    EXPECT_ERROR(&fixture->log, DPL_REASON_SHADER, "a.glsl: ", "nonsense", "1 = a.glsl", "2 = gpu/screen.glsl",
                 "3 = light/ok.glsl", ":4");
    assert_true(program_ready(gl, &program, "a.glsl", "")); /* said once */
    assert_int_equal(fixture->log.errors, 0);
    program_finish(gl, &program);
    assert_int_equal(program.name, 0);
    assert_false(program_ready(gl, &program, "a.glsl", ""));
    EXPECT_ERROR(&fixture->log, DPL_REASON_SHADER, "nonsense");
    dpl_gl_destroy(gl);
}

static void errors_name_their_files_and_keep_the_old_program(void **state)
{
    check_errors(*state, false);
    check_errors(*state, true);
}

static void a_program_that_does_not_link_is_named(void **state)
{
    struct fixture *fixture = *state;
    struct dpl_gl *gl = open_context(fixture, false);
    struct gpu_program program = {0};
    support_file_write(
        fixture->folder, "a.glsl",
        "#ifdef VERTEX\nout vec3 twofold;\nvoid main() { twofold = vec3(1.0); gl_Position = vec4(0.0); }\n"
        "#else\nin vec2 twofold;\nout vec4 c;\nvoid main() { c = twofold.xyxy; }\n#endif\n");
    assert_false(program_ready(gl, &program, "a.glsl", ""));
    EXPECT_ERROR(&fixture->log, DPL_REASON_SHADER, "a.glsl", "does not link", "twofold");
    dpl_gl_destroy(gl);
}

/* From the outside: a broken file leaves the picture, a mended one changes it. */
static void a_renderer_goes_on_while_a_shader_is_edited(void **state)
{
    static const char quarter[] = SCREEN "#ifdef FRAGMENT\nout float map;\nvoid main() { map = 0.25; }\n#endif\n";
    struct fixture *fixture = *state;
    struct dpl_gl *gl = open_context(fixture, false);
    struct dpl_renderer *renderer = dpl_renderer_create(gl, DPL_DEVICE_GL, &fixture->log.log);
    struct dpl_scene *scene = support_scene("[wave.1]\ncycles = 1 1\n[caustics]\ntechnique = multi-sample\n"
                                            "map = 32\nmesh = 32\n",
                                            NULL);
    struct dpl_image *images[4];
    for (int i = 0; i < 4; i++) {
        if (i == 1)
            support_file_write(fixture->folder, "light/multi_sample.glsl", "broken\n");
        if (i == 2)
            support_file_write(fixture->folder, "light/multi_sample.glsl", quarter);
        if (i != 3) /* the fourth time nothing changed */
            dpl_renderer_reload(renderer);
        images[i] = dpl_renderer_map(renderer, scene, 1);
        assert_non_null(images[i]);
        if (i == 1)
            EXPECT_ERROR(&fixture->log, DPL_REASON_SHADER, "light/multi_sample.glsl");
        assert_int_equal(fixture->log.errors, 0);
    }
    assert_memory_equal(images[0]->pixels, images[1]->pixels, 32 * 32 * 3 * sizeof(float));
    for (int i = 0; i < 32 * 32 * 3; i++)
        assert_true(images[2]->pixels[i] == 0.25f && images[3]->pixels[i] == 0.25f);
    for (int i = 0; i < 4; i++)
        dpl_image_destroy(images[i]);
    dpl_scene_destroy(scene);
    dpl_renderer_destroy(renderer);
    dpl_gl_destroy(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(every_built_in_shader_is_found_and_has_its_dialect, setup, teardown),
        cmocka_unit_test_setup_teardown(includes_are_expanded_once_each, setup, teardown),
        cmocka_unit_test_setup_teardown(a_missing_file_is_named, setup, teardown),
        cmocka_unit_test_setup_teardown(too_many_includes_are_refused, setup, teardown),
        cmocka_unit_test_setup_teardown(errors_name_their_files_and_keep_the_old_program, setup, teardown),
        cmocka_unit_test_setup_teardown(a_program_that_does_not_link_is_named, setup, teardown),
        cmocka_unit_test_setup_teardown(a_renderer_goes_on_while_a_shader_is_edited, setup, teardown),
    };
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
