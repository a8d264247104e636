/* The laws of single rays on the GPU against those on the CPU. */
#include "support.h"

#include "base/resource.h"
#include "gpu/program.h"
#include "gpu/texture.h"
#include "optics/phase.h"
#include "optics/refraction.h"
#include "optics/sun.h"

#include <sys/stat.h>

/* Refraction with Fresnel's share, reflection with what is left after a way, and scattering, in a column each of a row
 * of fragments, for an angle and an index. */
static const char optics_shader[] =
    "#include \"gpu/screen.glsl\"\n"
    "#ifdef FRAGMENT\n"
    "#include \"optics/refraction.glsl\"\n"
    "#include \"optics/phase.glsl\"\n"
    "uniform vec3 sun, slopes;\n"
    "uniform float ior;\n"
    "out vec4 color;\n"
    "void main()\n"
    "{\n"
    "    vec3 normal = normalize(vec3(-slopes.x, 1.0, -slopes.y));\n"
    "    color = vec4(optics_refract(sun, normal, ior),\n"
    "                 optics_fresnel_reflectance(dot(sun, normal), ior));\n"
    "    if (gl_FragCoord.x > 1.0)\n"
    "        color = vec4(optics_reflect(sun, normal), optics_transmittance(sun, ior).y);\n"
    "    if (gl_FragCoord.x > 2.0)\n"
    "        color = vec4(optics_phase(sun.y, 0.9), optics_phase(sun.x, 1.0 - 1.0 / ior), optics_phase(sun.z, -0.5),\n"
    "                     optics_phase(1.0, 0.0));\n"
    "}\n"
    "#endif\n";

/* Single precision keeps 6e-8 of numbers up to 1; near grazing and near no refraction differences of such numbers are
 * divided by small ones. */
static void check_optics(struct dpl_gl *gl, const struct gpu_program *program, const double sun[3],
                         const double slopes[3], double ior)
{
    float got[3][4];
    double length = sqrt(1 + slopes[0] * slopes[0] + slopes[1] * slopes[1]), wanted[3][4];
    double normal[3] = {-slopes[0] / length, 1 / length, -slopes[1] / length};
    double cosine = sun[0] * normal[0] + sun[1] * normal[1] + sun[2] * normal[2];
    if (cosine < 0.02)
        return;
    program_vec3(gl, program, "sun", sun);
    program_vec3(gl, program, "slopes", slopes);
    program_float(gl, program, "ior", ior);
    gpu_draw_screen(gl);
    gl->ReadPixels(0, 0, 3, 1, GL_RGBA, GL_FLOAT, got);
    optics_refract(sun, normal, ior, wanted[0]);
    wanted[0][3] = optics_fresnel_reflectance(cosine, ior);
    optics_reflect(sun, normal, wanted[1]);
    wanted[1][3] = optics_transmittance(sun[1], ior);
    wanted[2][0] = optics_phase(sun[1], 0.9);
    wanted[2][1] = optics_phase(sun[0], 1 - 1 / ior);
    wanted[2][2] = optics_phase(sun[2], -0.5);
    wanted[2][3] = optics_phase(1, 0);
    for (int i = 0; i < 12; i++)
        assert_true(fabs((double)got[i / 4][i % 4] - wanted[i / 4][i % 4]) < 2e-5 * fmax(1, wanted[i / 4][i % 4]));
}

static void optics_are_those_of_the_cpu(void **state)
{
    (void)state;
    for (int es = 0; es < 2; es++) {
        struct support_log log;
        struct gpu_texture row = {0};
        struct gpu_program program = {0};
        char folder[64], path[128];
        static const char *const subfolders[] = {"gpu", "optics", ""};
        support_folder_make(folder);
        for (int i = 0; i < 2; i++) {
            snprintf(path, sizeof path, "%s/%s", folder, subfolders[i]);
            assert_int_equal(mkdir(path, 0777), 0);
        }
        support_file_write(folder, "test.glsl", optics_shader);
        support_file_write(folder, "gpu/screen.glsl", base_resource_find("gpu/screen.glsl"));
        support_file_write(folder, "optics/refraction.glsl", base_resource_find("optics/refraction.glsl"));
        support_file_write(folder, "optics/phase.glsl", base_resource_find("optics/phase.glsl"));
        struct dpl_gl *gl = dpl_gl_create_headless(es, folder, support_log_start(&log));
        assert_non_null(gl);
        assert_true(program_ready(gl, &program, "test.glsl", ""));
        texture_resize(gl, &row, GL_RGBA32F, 3, 1, TEXTURE_CLAMP, TEXTURE_NEAREST);
        texture_draw_to(gl, &row);
        program_use(gl, &program);
        for (int i = 0; i < 1000; i++) {
            static const double iors[] = {1, 1.0001, 1.333, 2.4};
            const struct optics_sun at = {.elevation = 1 + i * 0.089, .azimuth = i * 7};
            double sun[3], slopes[3] = {0.1 * (i % 7) - 0.3, 0.1 * (i % 5) - 0.2, 0};
            optics_sun_direction(&at, sun);
            check_optics(gl, &program, sun, slopes, iors[i % 4]);
        }
        texture_finish(gl, &row);
        program_finish(gl, &program);
        dpl_gl_destroy(gl);
        for (int i = 0; i < 3; i++) {
            snprintf(path, sizeof path, "%s/%s", folder, subfolders[i]);
            support_folder_count(path, true);
        }
        assert_int_equal(log.errors, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(optics_are_those_of_the_cpu),
    };
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
