/* The contract of dapple/gl.h about the state of a caller's context: what every call expects, and what it leaves. */
#include "support.h"

#include "gpu/gl.h"

#include <dlfcn.h>

#define UNITS 8
#define SIDE 64 /* pixels, of the framebuffer that is drawn to */

struct fixture {
    struct support_log log;
    struct dpl_gl *gl;
    struct dpl_scene *scene;
    struct dpl_renderer *renderer;
    GLuint framebuffer, color;
    GLboolean (*IsEnabled)(GLenum);
    void (*GetFloatv)(GLenum, GLfloat *);
};

/* What must be as OpenGL starts, before and after. */
static const GLenum switches[] = {GL_BLEND,        GL_CULL_FACE,       GL_DEPTH_TEST,          GL_STENCIL_TEST,
                                  GL_SCISSOR_TEST, GL_DITHER,          GL_POLYGON_OFFSET_FILL, GL_RASTERIZER_DISCARD,
                                  GL_MULTISAMPLE,  GL_SAMPLE_COVERAGE, GL_FRAMEBUFFER_SRGB,    GL_PROGRAM_POINT_SIZE};
static const GLenum integers[] = {GL_BLEND_EQUATION_RGB,
                                  GL_BLEND_EQUATION_ALPHA,
                                  GL_COLOR_WRITEMASK,
                                  GL_DEPTH_FUNC,
                                  GL_DEPTH_WRITEMASK,
                                  GL_CULL_FACE_MODE,
                                  GL_FRONT_FACE,
                                  GL_POLYGON_MODE,
                                  GL_STENCIL_WRITEMASK,
                                  GL_PACK_ALIGNMENT,
                                  GL_PACK_ROW_LENGTH,
                                  GL_PACK_SKIP_ROWS,
                                  GL_PACK_SKIP_PIXELS,
                                  GL_UNPACK_ALIGNMENT,
                                  GL_UNPACK_ROW_LENGTH,
                                  GL_UNPACK_SKIP_ROWS,
                                  GL_UNPACK_SKIP_PIXELS,
                                  GL_PIXEL_PACK_BUFFER_BINDING,
                                  GL_PIXEL_UNPACK_BUFFER_BINDING,
                                  GL_UNIFORM_BUFFER_BINDING,
                                  GL_TRANSFORM_FEEDBACK_BUFFER_BINDING,
                                  GL_CURRENT_QUERY};
static const GLenum floats[] = {GL_DEPTH_RANGE, GL_DEPTH_CLEAR_VALUE, GL_BLEND_COLOR, GL_LINE_WIDTH, GL_POINT_SIZE};
/* What may be anything before, and is 0 after. */
static const GLenum bindings[] = {GL_VERTEX_ARRAY_BINDING, GL_ARRAY_BUFFER_BINDING, GL_CURRENT_PROGRAM,
                                  GL_RENDERBUFFER_BINDING};
#define COUNT(array) (sizeof array / sizeof *array)

static int setup(void **state)
{
    struct fixture *f = calloc(1, sizeof *f);
    *state = f;
    f->gl = dpl_gl_create_headless(false, NULL, support_log_start(&f->log));
    if (!f->gl)
        return 0;
    void *(*get)(const char *);
    void *library = dlopen("libEGL.so.1", RTLD_NOW), *symbol = dlsym(library, "eglGetProcAddress");
    memcpy(&get, &symbol, sizeof get);
    void *functions[] = {get("glIsEnabled"), get("glGetFloatv")};
    memcpy(&f->IsEnabled, functions, sizeof functions[0]);
    memcpy(&f->GetFloatv, functions + 1, sizeof functions[0]);
    f->scene = dpl_scene_create(&f->log.log);
    assert_true(dpl_scene_load(f->scene, "collard-1"));
    support_set(f->scene, "caustics.map", "64");
    f->gl->GenFramebuffers(1, &f->framebuffer);
    f->gl->GenRenderbuffers(1, &f->color);
    f->gl->BindFramebuffer(GL_FRAMEBUFFER, f->framebuffer);
    f->gl->BindRenderbuffer(GL_RENDERBUFFER, f->color);
    f->gl->RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, GL_RGBA8, SIDE, SIDE);
    f->gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, f->color);
    f->renderer = dpl_renderer_create(f->gl, DPL_DEVICE_GL, &f->log.log);
    return 0;
}

static int teardown(void **state)
{
    struct fixture *f = *state;
    if (f->gl) {
        dpl_renderer_destroy(f->renderer);
        dpl_scene_destroy(f->scene);
        f->gl->DeleteFramebuffers(1, &f->framebuffer);
        f->gl->DeleteRenderbuffers(1, &f->color);
        dpl_gl_destroy(f->gl);
    }
    free(f);
    return 0;
}

static GLint integer(struct dpl_gl *gl, GLenum name)
{
    GLint values[4] = {0};
    gl->GetIntegerv(name, values);
    return values[0];
}

/* Writes the state that must not change, a line a value. */
static void dump(struct fixture *f, char *text, size_t size)
{
    size_t used = 0;
    for (size_t i = 0; i < COUNT(switches); i++)
        used +=
            (size_t)snprintf(text + used, size - used, "enabled 0x%04x %d\n", switches[i], f->IsEnabled(switches[i]));
    for (size_t i = 0; i < COUNT(integers); i++) {
        GLint values[4] = {0};
        f->gl->GetIntegerv(integers[i], values);
        used += (size_t)snprintf(text + used, size - used, "integer 0x%04x %d %d %d %d\n", integers[i], values[0],
                                 values[1], values[2], values[3]);
    }
    for (size_t i = 0; i < COUNT(floats); i++) {
        GLfloat values[4] = {0};
        f->GetFloatv(floats[i], values);
        used += (size_t)snprintf(text + used, size - used, "float 0x%04x %g %g %g %g\n", floats[i], (double)values[0],
                                 (double)values[1], (double)values[2], (double)values[3]);
    }
    assert_true(used < size);
    while (f->gl->GetError() != GL_NO_ERROR) {
        /* names that this version does not know say nothing, before and after alike */
    }
}

/* Sets what the contract lets a caller leave as it likes. */
static void disorder(struct fixture *f)
{
    struct dpl_gl *gl = f->gl;
    gl->Viewport(3, 5, 7, 11);
    gl->ClearColor(0.1f, 0.2f, 0.3f, 0.4f);
    gl->BlendFuncSeparate(GL_DST_COLOR, GL_ZERO, GL_SRC_ALPHA, GL_ONE);
    gl->BindFramebuffer(GL_FRAMEBUFFER, f->framebuffer);
    gl->BindRenderbuffer(GL_RENDERBUFFER, f->color);
    gl->BindVertexArray(gl->empty_array);
    gl->ActiveTexture(GL_TEXTURE5);
}

static void expect_left(struct fixture *f, GLuint framebuffer, const char *before, const char *call)
{
    char after[4096];
    assert_int_equal(f->gl->GetError(), GL_NO_ERROR);
    dump(f, after, sizeof after);
    if (strcmp(before, after))
        fail_msg("%s changes the state; before:\n%safter:\n%s", call, before, after);
    for (size_t i = 0; i < COUNT(bindings); i++)
        if (integer(f->gl, bindings[i]) != 0)
            fail_msg("%s leaves binding 0x%04x at %d", call, bindings[i], integer(f->gl, bindings[i]));
    assert_int_equal(integer(f->gl, GL_DRAW_FRAMEBUFFER_BINDING), framebuffer);
    assert_int_equal(integer(f->gl, GL_READ_FRAMEBUFFER_BINDING), framebuffer);
    assert_int_equal(integer(f->gl, GL_ACTIVE_TEXTURE), GL_TEXTURE0);
    for (GLenum unit = 0; unit < UNITS; unit++) {
        f->gl->ActiveTexture(GL_TEXTURE0 + unit);
        if (integer(f->gl, GL_TEXTURE_BINDING_2D) != 0)
            fail_msg("%s leaves a texture on unit %u", call, unit);
    }
    f->gl->ActiveTexture(GL_TEXTURE0);
}

/* Every call that draws, from a context in disorder, for the scene as it is now. */
static void expect_contract(struct fixture *f)
{
    char before[4096];
    dump(f, before, sizeof before);
    disorder(f);
    assert_true(dpl_renderer_draw(f->renderer, f->scene, 1, f->framebuffer, SIDE, SIDE));
    expect_left(f, f->framebuffer, before, "dpl_renderer_draw");
    disorder(f);
    dpl_image_destroy(dpl_renderer_picture(f->renderer, f->scene, 1, SIDE, SIDE));
    expect_left(f, 0, before, "dpl_renderer_picture");
    disorder(f);
    dpl_image_destroy(dpl_renderer_map(f->renderer, f->scene, 1));
    expect_left(f, 0, before, "dpl_renderer_map");
    disorder(f);
    dpl_image_destroy(dpl_renderer_surface(f->renderer, f->scene, 1));
    expect_left(f, 0, before, "dpl_renderer_surface");
    for (int i = 0; i < 2; i++) {
        disorder(f);
        assert_non_null(dpl_renderer_thumbnail(f->renderer, i).name);
        expect_left(f, 0, before, "dpl_renderer_thumbnail");
    }
    assert_int_equal(f->log.errors, 0);
}

static void state_is_left_as_promised(void **state)
{
    struct fixture *f = *state;
    if (!f->gl)
        skip();
    expect_contract(f);
    support_set(f->scene, "render.wireframe", "true");
    support_set(f->scene, "render.samples", "4");
    support_set(f->scene, "caustics.blur", "2");
    expect_contract(f);
    support_set(f->scene, "water.model", "sines");
    support_set(f->scene, "caustics.mesh", "32");
    support_set(f->scene, "wave.1.amplitude", "0.02");
    expect_contract(f);
}

static void timing_leaves_no_query_open(void **state)
{
    struct fixture *f = *state;
    if (!f->gl)
        skip();
    dpl_renderer_time_passes(f->renderer, DPL_TIMING_QUERIES, NULL);
    for (int i = 0; i < 6; i++)
        expect_contract(f);
    assert_non_null(dpl_renderer_pass_time(f->renderer, 0).name);
}

static void creating_and_destroying_leaves_the_state(void **state)
{
    struct fixture *f = *state;
    char before[4096];
    if (!f->gl)
        skip();
    dump(f, before, sizeof before);
    struct dpl_renderer *renderer = dpl_renderer_create(f->gl, DPL_DEVICE_AUTO, &f->log.log);
    assert_true(dpl_renderer_draw(renderer, f->scene, 1, f->framebuffer, SIDE, SIDE));
    dpl_renderer_destroy(renderer);
    expect_left(f, f->framebuffer, before, "dpl_renderer_destroy");
}

int main(void)
{
    if (!support_has_gl())
        return SUPPORT_SKIPPED;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(state_is_left_as_promised, setup, teardown),
        cmocka_unit_test_setup_teardown(timing_leaves_no_query_open, setup, teardown),
        cmocka_unit_test_setup_teardown(creating_and_destroying_leaves_the_state, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
