/* The contract of dapple/gl.h: the state in which a call finds a context, and the state in which it leaves it. */
#include "gpu_state.h"

struct fixture {
    struct support_log log;
    struct dpl_gl *headless; /* makes the context, and keeps it current */
    struct state_gl gl;
    struct dpl_gl *guest; /* a second one in that same context, as a caller's would be */
    struct dpl_renderer *renderer;
    struct dpl_scene *scene;
    GLuint texture, array, beyond, framebuffer; /* the caller's own */
    struct state_text initial;
};

#define WIDTH 96
#define HEIGHT 64

static GLuint make_texture(struct state_gl *gl)
{
    GLuint name;
    gl->GenTextures(1, &name);
    gl->BindTexture(GL_TEXTURE_2D, name);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, WIDTH, HEIGHT, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    return name;
}

/* What the caller has of its own: a texture on a unit beyond dapple's, and a framebuffer. */
static void make_own(struct fixture *fixture)
{
    struct state_gl *gl = &fixture->gl;
    fixture->texture = make_texture(gl);
    gl->GenFramebuffers(1, &fixture->framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, fixture->framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, fixture->texture, 0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->GenTextures(1, &fixture->array);
    gl->ActiveTexture(GL_TEXTURE17);
    fixture->beyond = make_texture(gl);
    gl->ActiveTexture(GL_TEXTURE0);
    state_dump(gl, &fixture->initial);
}

static void start(struct fixture *fixture, bool es)
{
    *fixture = (struct fixture){0};
    const struct dpl_log *log = support_log_start(&fixture->log);
    fixture->headless = support_gl(es, log);
    state_load(&fixture->gl);
    make_own(fixture);
    fixture->scene = support_scene("[wave.1]\ncycles = 2 1\namplitude = 0.03\n[caustics]\nmap = 64\nmesh = 40\n"
                                   "blur = 1\nslices = 2\n[render]\nlook = collard\nsamples = 4\nwireframe = yes\n",
                                   log);
}

static void finish(struct fixture *fixture)
{
    assert_int_equal(fixture->log.errors, 0);
    dpl_scene_destroy(fixture->scene);
    dpl_gl_destroy(fixture->headless);
}

/* Everything that may be anything before a call. */
static void disturb(struct fixture *fixture)
{
    struct state_gl *gl = &fixture->gl;
    GLuint array, buffer, renderbuffer;
    gl->GenVertexArrays(1, &array);
    gl->BindVertexArray(array);
    gl->EnableVertexAttribArray(3);
    gl->GenBuffers(1, &buffer);
    gl->BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer);
    gl->GetError(); /* before OpenGL 4.3 and OpenGL ES 3.1 there are no such buffers */
    gl->GenRenderbuffers(1, &renderbuffer);
    gl->BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, fixture->framebuffer);
    for (GLenum unit = 0; unit < 16; unit++) {
        gl->ActiveTexture(GL_TEXTURE0 + unit);
        gl->BindTexture(GL_TEXTURE_2D, fixture->texture);
        gl->BindTexture(GL_TEXTURE_2D_ARRAY, fixture->array);
    }
    gl->ActiveTexture(GL_TEXTURE17);
    gl->Viewport(3, 4, 5, 6);
    gl->ClearColor(0.1f, 0.2f, 0.3f, 0.4f);
    gl->BlendFuncSeparate(GL_DST_COLOR, GL_ZERO, GL_ONE, GL_SRC_COLOR);
    assert_int_equal(gl->GetError(), GL_NO_ERROR);
}

static bool may_be_anything(const char *line)
{
    static const char *const names[] = {"VIEWPORT",   "SCISSOR_BOX", "COLOR_CLEAR_VALUE",
                                        "BLEND_SRC_", "BLEND_DST_",  NULL};
    for (int i = 0; names[i]; i++)
        if (!strncmp(line, names[i], strlen(names[i])))
            return true;
    return false;
}

/* The state is the first one, but for the exceptions; `framebuffer` is bound; the viewport is that, if not NULL. */
static void expect_state(struct fixture *fixture, const char *call, GLuint framebuffer, const char *viewport)
{
    struct state_text now, wanted = fixture->initial;
    char number[16];
    int wrong = 0;
    snprintf(number, sizeof number, "%u", framebuffer);
    state_set_line(&wanted, "DRAW_FRAMEBUFFER_BINDING", number);
    state_set_line(&wanted, "READ_FRAMEBUFFER_BINDING", number);
    if (viewport)
        state_set_line(&wanted, "VIEWPORT", viewport);
    state_dump(&fixture->gl, &now);
    assert_int_equal(now.count, wanted.count);
    for (int i = 0; i < now.count; i++) {
        bool free_line = may_be_anything(now.lines[i]) && !(viewport && !strncmp(now.lines[i], "VIEWPORT", 8));
        if (free_line || !strcmp(now.lines[i], wanted.lines[i]))
            continue;
        print_error("after %s: %s, not %s\n", call, now.lines[i], wanted.lines[i]);
        wrong++;
    }
    assert_int_equal(wrong, 0);
}

/* Each call of a renderer in turn, `disturbed` or not. */
static void call_everything(struct fixture *fixture, enum dpl_device device, bool disturbed)
{
#define CALL(text, framebuffer, viewport, ...)                                                                         \
    if (disturbed)                                                                                                     \
        disturb(fixture);                                                                                              \
    __VA_ARGS__;                                                                                                       \
    expect_state(fixture, text, framebuffer, viewport)
    struct dpl_gl_options options = {.get_proc_address = state_get_function, .plain = !disturbed};
    const struct dpl_log *log = &fixture->log.log;
    const struct dpl_scene *scene = fixture->scene;
    CALL("dpl_gl_create", 0, NULL, fixture->guest = dpl_gl_create(&options, log));
    assert_non_null(fixture->guest);
    fixture->renderer = dpl_renderer_create(fixture->guest, device, log);
    struct dpl_renderer *renderer = fixture->renderer;
    for (int frame = 0; frame < 3; frame++) {
        struct dpl_image *image;
        if (frame == 1 && device == DPL_DEVICE_GL)
            support_set(fixture->scene, "caustics.technique", "coverage");
        if (frame == 2) { /* water from the CPU, no blur, one sample */
            support_set(fixture->scene, "water.model", "collard");
            support_set(fixture->scene, "caustics.blur", "0");
            support_set(fixture->scene, "render.samples", "1");
        }
        CALL("dpl_renderer_surface", 0, NULL, image = dpl_renderer_surface(renderer, scene, frame));
        dpl_image_destroy(image);
        CALL("dpl_renderer_map", 0, NULL, image = dpl_renderer_map(renderer, scene, frame));
        dpl_image_destroy(image);
        CALL("dpl_renderer_picture", 0, NULL, image = dpl_renderer_picture(renderer, scene, frame, WIDTH, HEIGHT));
        dpl_image_destroy(image);
        CALL("dpl_renderer_draw", fixture->framebuffer, "0 0 96 64",
             assert_true(dpl_renderer_draw(renderer, scene, frame, fixture->framebuffer, WIDTH, HEIGHT)));
        fixture->gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
        CALL("dpl_renderer_draw into nothing", 0, NULL,
             assert_true(dpl_renderer_draw(renderer, scene, frame, DPL_NO_FRAMEBUFFER, WIDTH, HEIGHT)));
        for (int i = 0; i < 3; i++) {
            CALL("dpl_renderer_thumbnail", 0, NULL,
                 assert_true((dpl_renderer_thumbnail(renderer, i).name != NULL) == (i < 2)));
        }
    }
    CALL("dpl_renderer_destroy", 0, NULL, dpl_renderer_destroy(renderer));
    CALL("dpl_gl_destroy", 0, NULL, dpl_gl_destroy(fixture->guest));
#undef CALL
}

static void check_calls(bool es, enum dpl_device device, bool disturbed)
{
    struct fixture fixture;
    start(&fixture, es);
    if (device == DPL_DEVICE_GL)
        support_set(fixture.scene, "render.look", "physical");
    call_everything(&fixture, device, disturbed);
    finish(&fixture);
}

static void calls_leave_the_first_state(void **state)
{
    (void)state;
    check_calls(false, DPL_DEVICE_GL, false);
    check_calls(true, DPL_DEVICE_GL, false);
}

static void calls_leave_the_first_state_whatever_was_bound(void **state)
{
    (void)state;
    check_calls(false, DPL_DEVICE_GL, true);
    check_calls(false, DPL_DEVICE_CPU, true);
    check_calls(true, DPL_DEVICE_GL, true);
    check_calls(true, DPL_DEVICE_CPU, true);
}

/* What the caller sees of a frame in its own framebuffer. */
static void frame_of(struct fixture *fixture, unsigned char bytes[WIDTH * HEIGHT * 4])
{
    const struct dpl_scene *scene = fixture->scene;
    assert_true(dpl_renderer_draw(fixture->renderer, scene, 1, fixture->framebuffer, WIDTH, HEIGHT));
    fixture->gl.ReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
}

static void check_picture(bool es)
{
    static unsigned char first[WIDTH * HEIGHT * 4], second[WIDTH * HEIGHT * 4];
    struct fixture fixture;
    start(&fixture, es);
    fixture.renderer = dpl_renderer_create(fixture.headless, DPL_DEVICE_GL, &fixture.log.log);
    frame_of(&fixture, first);
    disturb(&fixture);
    frame_of(&fixture, second);
    assert_memory_equal(first, second, sizeof first);
    struct dpl_image *image = dpl_renderer_picture(fixture.renderer, fixture.scene, 1, WIDTH, HEIGHT);
    for (int y = 0; y < HEIGHT; y++) /* OpenGL's rows go upwards, an image's downwards */
        for (int x = 0; x < WIDTH * 3; x++)
            assert_int_equal(first[((HEIGHT - 1 - y) * WIDTH + x / 3) * 4 + x % 3],
                             (int)(image->pixels[y * WIDTH * 3 + x] * 255 + 0.5f));
    dpl_image_destroy(image);
    dpl_renderer_destroy(fixture.renderer);
    finish(&fixture);
}

static void what_was_bound_does_not_show(void **state)
{
    (void)state;
    check_picture(false);
    check_picture(true);
}

static double seconds(void)
{
    return 1;
}

static void check_timing(bool es, enum dpl_timing timing)
{
    struct fixture fixture;
    start(&fixture, es);
    if (timing != DPL_TIMING_QUERIES || dpl_gl_describe(fixture.headless)->timer_queries) {
        fixture.renderer = dpl_renderer_create(fixture.headless, DPL_DEVICE_GL, &fixture.log.log);
        dpl_renderer_time_passes(fixture.renderer, timing, seconds);
        for (int frame = 0; frame < 12; frame++) {
            assert_true(dpl_renderer_draw(fixture.renderer, fixture.scene, frame, fixture.framebuffer, WIDTH, HEIGHT));
            expect_state(&fixture, "a timed frame", fixture.framebuffer, "0 0 96 64");
        }
        fixture.gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
        assert_string_equal(dpl_renderer_pass_time(fixture.renderer, 0).name, "surface");
        assert_string_equal(dpl_renderer_pass_time(fixture.renderer, 1).name, "light");
        dpl_renderer_destroy(fixture.renderer);
        expect_state(&fixture, "the end of a timed renderer", 0, NULL);
    }
    finish(&fixture);
}

static void timing_leaves_the_first_state(void **state)
{
    (void)state;
    check_timing(false, DPL_TIMING_QUERIES);
    check_timing(false, DPL_TIMING_WAIT);
    check_timing(true, DPL_TIMING_QUERIES);
    check_timing(true, DPL_TIMING_WAIT);
}

static void check_failure(bool es)
{
    struct fixture fixture;
    start(&fixture, es);
    fixture.renderer = dpl_renderer_create(fixture.headless, DPL_DEVICE_GL, &fixture.log.log);
    dpl_renderer_time_passes(fixture.renderer, DPL_TIMING_WAIT, seconds);
    disturb(&fixture);
    assert_null(dpl_renderer_picture(fixture.renderer, fixture.scene, 0, 1 << 20, HEIGHT));
    EXPECT_ERROR(&fixture.log, DPL_REASON_LIMIT, "1048576 × 64");
    expect_state(&fixture, "a picture that is too large", 0, NULL);
    assert_null(dpl_renderer_picture(fixture.renderer, fixture.scene, 0, 0, HEIGHT));
    EXPECT_ERROR(&fixture.log, DPL_REASON_LIMIT, "0 × 64");
    dpl_image_destroy(dpl_renderer_picture(fixture.renderer, fixture.scene, 0, WIDTH, HEIGHT));
    dpl_renderer_destroy(fixture.renderer);
    finish(&fixture);
}

static void a_failed_call_leaves_the_first_state(void **state)
{
    (void)state;
    check_failure(false);
    check_failure(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(calls_leave_the_first_state),
        cmocka_unit_test(calls_leave_the_first_state_whatever_was_bound),
        cmocka_unit_test(what_was_bound_does_not_show),
        cmocka_unit_test(timing_leaves_the_first_state),
        cmocka_unit_test(a_failed_call_leaves_the_first_state),
    };
    return support_has_gl() ? cmocka_run_group_tests(tests, NULL, NULL) : SUPPORT_SKIPPED;
}
