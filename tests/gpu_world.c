/* What sways and what is laid in patterns, on the GPU against the CPU, in OpenGL 3.3 and in OpenGL ES 3.0. */
#include "support.h"

#include "base/resource.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "gpu/texture.h"
#include "scene/sway.h"
#include "scene/world.h"

#include <sys/stat.h>

/* One fragment: a place and its numbers come as uniforms. */
static const char shader[] = "#include \"gpu/screen.glsl\"\n"
                             "#ifdef FRAGMENT\n"
                             "#include \"scene/pattern.glsl\"\n"
                             "#include \"scene/sway.glsl\"\n"
                             "uniform vec3 place, tint, joint, width;\n"
                             "uniform float size, reach;\n"
                             "uniform int pattern, sways;\n"
                             "out vec4 color;\n"
                             "void main()\n"
                             "{\n"
                             "    color = vec4(pattern_color(pattern, size, joint, tint, place.xz, width.xy), 1.0);\n"
                             "    if (sways != 0)\n"
                             "        color = vec4(sway_move(place, reach), 1.0);\n"
                             "}\n"
                             "#endif\n";

struct fixture {
    struct support_log log;
    struct dpl_gl *gl;
    struct gpu_texture texel;
    struct gpu_program program;
    char folder[64];
};

static void start(struct fixture *fixture, bool es)
{
    static const char *const files[] = {"gpu/screen.glsl", "scene/pattern.glsl", "scene/sway.glsl"};
    char path[128];
    *fixture = (struct fixture){0};
    support_folder_make(fixture->folder);
    for (int i = 0; i < 2; i++) {
        snprintf(path, sizeof path, "%s/%s", fixture->folder, i ? "scene" : "gpu");
        assert_int_equal(mkdir(path, 0777), 0);
    }
    support_file_write(fixture->folder, "test.glsl", shader);
    for (int i = 0; i < 3; i++)
        support_file_write(fixture->folder, files[i], base_resource_find(files[i]));
    fixture->gl = dpl_gl_create_headless(es, fixture->folder, support_log_start(&fixture->log));
    if (!fixture->gl)
        skip();
    if (!program_ready(fixture->gl, &fixture->program, "test.glsl", ""))
        fail_msg("%s", fixture->log.text);
    texture_resize(fixture->gl, &fixture->texel, GL_RGBA32F, 1, 1, TEXTURE_CLAMP, TEXTURE_NEAREST);
    texture_draw_to(fixture->gl, &fixture->texel);
    program_use(fixture->gl, &fixture->program);
}

static void finish(struct fixture *fixture)
{
    static const char *const folders[] = {"gpu", "scene", ""};
    texture_finish(fixture->gl, &fixture->texel);
    program_finish(fixture->gl, &fixture->program);
    dpl_gl_destroy(fixture->gl);
    for (int i = 0; i < 3; i++) {
        char path[128];
        snprintf(path, sizeof path, "%s/%s", fixture->folder, folders[i]);
        support_folder_count(path, true);
    }
    assert_int_equal(fixture->log.errors, 0);
}

static void draw(struct fixture *fixture, float got[4])
{
    gpu_draw_screen(fixture->gl);
    fixture->gl->ReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, got);
}

static void check_sway(struct fixture *fixture)
{
    struct dpl_scene *scene = support_scene("[current]\nstrength = 1.5\nazimuth = 70\n[scene]\nloop = 9\n", NULL);
    uint64_t random = 5;
    program_int(fixture->gl, &fixture->program, "sways", 1);
    program_float(fixture->gl, &fixture->program, "reach", 0.25);
    for (int i = 0; i < 500; i++) {
        struct world_vertex vertex = {.sway = 0.25f};
        struct sway sway;
        double place[3], time = 1000 * support_random_unit(&random);
        float got[4], wanted[3];
        for (int c = 0; c < 3; c++) {
            place[c] = 20 * support_random_unit(&random) - 10;
            vertex.position[c] = (float)place[c];
        }
        sway_now(scene, time, &sway);
        program_vec4s(fixture->gl, &fixture->program, "sway_waves", SWAY_WAVES, sway.waves[0]);
        program_vec4s(fixture->gl, &fixture->program, "sway_current", 1, sway.current);
        program_vec3(fixture->gl, &fixture->program, "place", place);
        draw(fixture, got);
        sway_move(&sway, vertex.position, vertex.sway, wanted);
        for (int c = 0; c < 3; c++)
            assert_true(fabs((double)(got[c] - wanted[c])) < 1e-5);
    }
    dpl_scene_destroy(scene);
}

/* Places chosen by chance are none where rounding decides on which side of an edge they lie: all agree. */
static void check_patterns(struct fixture *fixture)
{
    static const double tint[3] = {0.6, 0.5, 0.9};
    uint64_t random = 9;
    program_int(fixture->gl, &fixture->program, "sways", 0);
    program_vec3(fixture->gl, &fixture->program, "tint", tint);
    program_vec3(fixture->gl, &fixture->program, "width", (const double[3]){0, 0, 0});
    for (int i = 0; i < 2000; i++) {
        struct world_part part = {.pattern = i % WORLD_PATTERNS, .pattern_size = 0.17, .joint = {0.1, 0.2, 0.3}};
        double place[3] = {6 * support_random_unit(&random) - 3, 0, 6 * support_random_unit(&random) - 3};
        float got[4], wanted[3];
        program_vec3(fixture->gl, &fixture->program, "joint", part.joint);
        program_vec3(fixture->gl, &fixture->program, "place", place);
        program_float(fixture->gl, &fixture->program, "size", part.pattern_size);
        program_int(fixture->gl, &fixture->program, "pattern", part.pattern);
        draw(fixture, got);
        world_color(&part, (const float[3]){0.6f, 0.5f, 0.9f}, (const float[2]){(float)place[0], (float)place[2]},
                    wanted);
        for (int c = 0; c < 3; c++)
            assert_true(fabs((double)(got[c] - wanted[c])) < 1e-5);
    }
}

/* What a pixel sees is the mean of what it covers, where one board's shade does not go over into another's. */
static void check_filter(struct fixture *fixture, int pattern, double width)
{
    struct world_part part = {.pattern = pattern, .pattern_size = 0.5, .joint = {0, 0, 0}};
    const double place[3] = {0.03, 0, 0.26};
    double sum = 0;
    uint64_t random = 1;
    float got[4], seen[3];
    program_int(fixture->gl, &fixture->program, "pattern", pattern);
    program_float(fixture->gl, &fixture->program, "size", 0.5);
    program_vec3(fixture->gl, &fixture->program, "tint", (const double[3]){0.8, 0.8, 0.8});
    program_vec3(fixture->gl, &fixture->program, "joint", part.joint);
    program_vec3(fixture->gl, &fixture->program, "place", place);
    program_vec3(fixture->gl, &fixture->program, "width", (const double[3]){width, width, 0});
    draw(fixture, got);
    for (int j = 0; j < 400; j++)
        for (int i = 0; i < 400; i++) {
            /* each anywhere in its cell, lest joints fall between them */
            double x = (i + support_random_unit(&random)) / 400, z = (j + support_random_unit(&random)) / 400;
            const float at[2] = {(float)(place[0] + width * (x - 0.5)), (float)(place[2] + width * (z - 0.5))};
            world_color(&part, (const float[3]){0.8f, 0.8f, 0.8f}, at, seen);
            sum += (double)seen[0] / 160000;
        }
    /* a pixel as wide as a tile or less sees other shares of joints than the mean */
    if (fabs((double)got[0] - sum) > (width > 4 ? 0.005 : 0.048))
        fail_msg("pattern %d, width %g: %g, not %g", pattern, width, (double)got[0], sum);
}

static void check(bool es)
{
    struct fixture fixture;
    start(&fixture, es);
    check_sway(&fixture);
    check_patterns(&fixture);
    for (double width = 0.02; width < 8; width *= 1.7)
        check_filter(&fixture, WORLD_TILES, width);
    check_filter(&fixture, WORLD_BLOCKS, 8);
    check_filter(&fixture, WORLD_PLANKS, 30);
    finish(&fixture);
}

static void the_gpu_agrees(void **state)
{
    (void)state;
    check(false);
}

static void the_gpu_agrees_in_es(void **state)
{
    (void)state;
    check(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_gpu_agrees), cmocka_unit_test(the_gpu_agrees_in_es)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
