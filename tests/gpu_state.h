/* tests/gpu_state.h: the state of an OpenGL context as lines of text, and state to disturb it with. */
#ifndef TESTS_GPU_STATE_H
#define TESTS_GPU_STATE_H

#include "support.h"

#include <GL/glcorearb.h>
#include <dlfcn.h>

/* X(type in glcorearb.h, name without gl) */
#define STATE_FUNCTIONS(X)                                                                                             \
    X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                                                                           \
    X(PFNGLBINDBUFFERPROC, BindBuffer)                                                                                 \
    X(PFNGLBINDBUFFERBASEPROC, BindBufferBase)                                                                         \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                                                                       \
    X(PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer)                                                                     \
    X(PFNGLBINDTEXTUREPROC, BindTexture)                                                                               \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                                                                       \
    X(PFNGLBLENDFUNCSEPARATEPROC, BlendFuncSeparate)                                                                   \
    X(PFNGLBUFFERDATAPROC, BufferData)                                                                                 \
    X(PFNGLCLEARCOLORPROC, ClearColor)                                                                                 \
    X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray)                                                       \
    X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D)                                                             \
    X(PFNGLGENBUFFERSPROC, GenBuffers)                                                                                 \
    X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                                                                       \
    X(PFNGLGENRENDERBUFFERSPROC, GenRenderbuffers)                                                                     \
    X(PFNGLGENTEXTURESPROC, GenTextures)                                                                               \
    X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                                                                       \
    X(PFNGLGETERRORPROC, GetError)                                                                                     \
    X(PFNGLGETFLOATVPROC, GetFloatv)                                                                                   \
    X(PFNGLGETINTEGERI_VPROC, GetIntegeri_v)                                                                           \
    X(PFNGLGETQUERYIVPROC, GetQueryiv)                                                                                 \
    X(PFNGLGETTEXPARAMETERIVPROC, GetTexParameteriv)                                                                   \
    X(PFNGLGETVERTEXATTRIBIVPROC, GetVertexAttribiv)                                                                   \
    X(PFNGLISENABLEDPROC, IsEnabled)                                                                                   \
    X(PFNGLREADPIXELSPROC, ReadPixels)                                                                                 \
    X(PFNGLTEXIMAGE2DPROC, TexImage2D)                                                                                 \
    X(PFNGLVIEWPORTPROC, Viewport)

struct state_gl {
#define STATE_MEMBER(type, name) type name;
    STATE_FUNCTIONS(STATE_MEMBER)
#undef STATE_MEMBER
};

/* For struct dpl_gl_options, and for the test itself: from the context that is current. */
static inline void *state_get_function(void *user, const char *name)
{
    void *library = dlopen("libEGL.so.1", RTLD_NOW), *symbol = library ? dlsym(library, "eglGetProcAddress") : NULL;
    void *(*get)(const char *name);
    (void)user;
    assert_non_null(symbol);
    memcpy(&get, &symbol, sizeof get);
    return get(name);
}

static inline void state_load(struct state_gl *gl)
{
#define STATE_LOAD(type, name)                                                                                         \
    gl->name = (type)state_get_function(NULL, "gl" #name);                                                             \
    assert_non_null(gl->name);
    STATE_FUNCTIONS(STATE_LOAD)
#undef STATE_LOAD
}

#define STATE_UNITS 20 /* texture units looked at: those that dapple uses, and some beyond */
#define STATE_LINES 300

struct state_text {
    int count;
    char lines[STATE_LINES][96];
};

/* Values of glGet with their number; what this context does not know is left out. */
struct state_value {
    GLenum name;
    int count;
    const char *text;
};
#define STATE_VALUE(name, count)                                                                                       \
    {                                                                                                                  \
        GL_##name, count, #name                                                                                        \
    }

static const struct state_value state_values[] = {
    STATE_VALUE(ACTIVE_TEXTURE, 1),
    STATE_VALUE(CURRENT_PROGRAM, 1),
    STATE_VALUE(VERTEX_ARRAY_BINDING, 1),
    STATE_VALUE(ARRAY_BUFFER_BINDING, 1),
    STATE_VALUE(ELEMENT_ARRAY_BUFFER_BINDING, 1),
    STATE_VALUE(PIXEL_PACK_BUFFER_BINDING, 1),
    STATE_VALUE(PIXEL_UNPACK_BUFFER_BINDING, 1),
    STATE_VALUE(UNIFORM_BUFFER_BINDING, 1),
    STATE_VALUE(COPY_READ_BUFFER_BINDING, 1),
    STATE_VALUE(COPY_WRITE_BUFFER_BINDING, 1),
    STATE_VALUE(TRANSFORM_FEEDBACK_BUFFER_BINDING, 1),
    STATE_VALUE(SHADER_STORAGE_BUFFER_BINDING, 1),
    STATE_VALUE(DISPATCH_INDIRECT_BUFFER_BINDING, 1),
    STATE_VALUE(DRAW_FRAMEBUFFER_BINDING, 1),
    STATE_VALUE(READ_FRAMEBUFFER_BINDING, 1),
    STATE_VALUE(RENDERBUFFER_BINDING, 1),
    STATE_VALUE(VIEWPORT, 4),
    STATE_VALUE(SCISSOR_BOX, 4),
    STATE_VALUE(DEPTH_RANGE, 2),
    STATE_VALUE(COLOR_CLEAR_VALUE, 4),
    STATE_VALUE(DEPTH_CLEAR_VALUE, 1),
    STATE_VALUE(STENCIL_CLEAR_VALUE, 1),
    STATE_VALUE(COLOR_WRITEMASK, 4),
    STATE_VALUE(DEPTH_WRITEMASK, 1),
    STATE_VALUE(STENCIL_WRITEMASK, 1),
    STATE_VALUE(STENCIL_BACK_WRITEMASK, 1),
    STATE_VALUE(DEPTH_FUNC, 1),
    STATE_VALUE(STENCIL_FUNC, 1),
    STATE_VALUE(STENCIL_REF, 1),
    STATE_VALUE(STENCIL_VALUE_MASK, 1),
    STATE_VALUE(STENCIL_FAIL, 1),
    STATE_VALUE(STENCIL_PASS_DEPTH_FAIL, 1),
    STATE_VALUE(STENCIL_PASS_DEPTH_PASS, 1),
    STATE_VALUE(BLEND_SRC_RGB, 1),
    STATE_VALUE(BLEND_DST_RGB, 1),
    STATE_VALUE(BLEND_SRC_ALPHA, 1),
    STATE_VALUE(BLEND_DST_ALPHA, 1),
    STATE_VALUE(BLEND_EQUATION_RGB, 1),
    STATE_VALUE(BLEND_EQUATION_ALPHA, 1),
    STATE_VALUE(BLEND_COLOR, 4),
    STATE_VALUE(CULL_FACE_MODE, 1),
    STATE_VALUE(FRONT_FACE, 1),
    STATE_VALUE(LINE_WIDTH, 1),
    STATE_VALUE(POINT_SIZE, 1),
    STATE_VALUE(POLYGON_MODE, 1),
    STATE_VALUE(POLYGON_OFFSET_FACTOR, 1),
    STATE_VALUE(POLYGON_OFFSET_UNITS, 1),
    STATE_VALUE(SAMPLE_COVERAGE_VALUE, 1),
    STATE_VALUE(SAMPLE_COVERAGE_INVERT, 1),
    STATE_VALUE(PRIMITIVE_RESTART_INDEX, 1),
    STATE_VALUE(PROVOKING_VERTEX, 1),
    STATE_VALUE(LOGIC_OP_MODE, 1),
    STATE_VALUE(FRAGMENT_SHADER_DERIVATIVE_HINT, 1),
    STATE_VALUE(PACK_ALIGNMENT, 1),
    STATE_VALUE(PACK_ROW_LENGTH, 1),
    STATE_VALUE(PACK_SKIP_ROWS, 1),
    STATE_VALUE(PACK_SKIP_PIXELS, 1),
    STATE_VALUE(UNPACK_ALIGNMENT, 1),
    STATE_VALUE(UNPACK_ROW_LENGTH, 1),
    STATE_VALUE(UNPACK_IMAGE_HEIGHT, 1),
    STATE_VALUE(UNPACK_SKIP_ROWS, 1),
    STATE_VALUE(UNPACK_SKIP_PIXELS, 1),
    STATE_VALUE(UNPACK_SKIP_IMAGES, 1),
};

static const struct state_value state_switches[] = {
    STATE_VALUE(BLEND, 0),
    STATE_VALUE(COLOR_LOGIC_OP, 0),
    STATE_VALUE(CULL_FACE, 0),
    STATE_VALUE(DEPTH_CLAMP, 0),
    STATE_VALUE(DEPTH_TEST, 0),
    STATE_VALUE(DITHER, 0),
    STATE_VALUE(FRAMEBUFFER_SRGB, 0),
    STATE_VALUE(LINE_SMOOTH, 0),
    STATE_VALUE(MULTISAMPLE, 0),
    STATE_VALUE(POLYGON_OFFSET_FILL, 0),
    STATE_VALUE(POLYGON_OFFSET_LINE, 0),
    STATE_VALUE(POLYGON_SMOOTH, 0),
    STATE_VALUE(PRIMITIVE_RESTART, 0),
    STATE_VALUE(PRIMITIVE_RESTART_FIXED_INDEX, 0),
    STATE_VALUE(PROGRAM_POINT_SIZE, 0),
    STATE_VALUE(RASTERIZER_DISCARD, 0),
    STATE_VALUE(SAMPLE_ALPHA_TO_COVERAGE, 0),
    STATE_VALUE(SAMPLE_ALPHA_TO_ONE, 0),
    STATE_VALUE(SAMPLE_COVERAGE, 0),
    STATE_VALUE(SCISSOR_TEST, 0),
    STATE_VALUE(STENCIL_TEST, 0),
    STATE_VALUE(TEXTURE_CUBE_MAP_SEAMLESS, 0),
};

/* Bindings that each texture unit has. */
static const struct state_value state_unit_values[] = {
    STATE_VALUE(TEXTURE_BINDING_2D, 1),       STATE_VALUE(TEXTURE_BINDING_3D, 1),
    STATE_VALUE(TEXTURE_BINDING_2D_ARRAY, 1), STATE_VALUE(TEXTURE_BINDING_CUBE_MAP, 1),
    STATE_VALUE(SAMPLER_BINDING, 1),
};

static inline void state_add(struct state_gl *gl, struct state_text *text, const struct state_value *value, int unit)
{
    GLfloat numbers[16] = {0};
    char line[96];
    assert_true(text->count < STATE_LINES);
    if (value->count == 0)
        numbers[0] = gl->IsEnabled(value->name);
    else
        gl->GetFloatv(value->name, numbers);
    if (gl->GetError() != GL_NO_ERROR)
        return;
    size_t used = (size_t)snprintf(line, sizeof line, "%s", value->text);
    if (unit >= 0)
        used += (size_t)snprintf(line + used, sizeof line - used, " of unit %d", unit);
    used += (size_t)snprintf(line + used, sizeof line - used, " =");
    for (int i = 0; i < value->count || i == 0; i++)
        used += (size_t)snprintf(line + used, sizeof line - used, " %g", (double)numbers[i]);
    memcpy(text->lines[text->count++], line, sizeof line);
}

/* Leaves the state as it is. */
static inline void state_dump(struct state_gl *gl, struct state_text *text)
{
    GLfloat active;
    assert_int_equal(gl->GetError(), GL_NO_ERROR);
    *text = (struct state_text){0};
    gl->GetFloatv(GL_ACTIVE_TEXTURE, &active);
    for (size_t i = 0; i < sizeof state_values / sizeof *state_values; i++)
        state_add(gl, text, state_values + i, -1);
    for (size_t i = 0; i < sizeof state_switches / sizeof *state_switches; i++)
        state_add(gl, text, state_switches + i, -1);
    for (int unit = 0; unit < STATE_UNITS; unit++) {
        gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        for (size_t i = 0; i < sizeof state_unit_values / sizeof *state_unit_values; i++)
            state_add(gl, text, state_unit_values + i, unit);
    }
    gl->ActiveTexture((GLenum)active);
    for (GLuint index = 0; index < 4; index++) {
        GLint buffer = 0;
        gl->GetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, index, &buffer);
        if (gl->GetError() == GL_NO_ERROR)
            snprintf(text->lines[text->count++], sizeof text->lines[0], "storage buffer %u = %d", index, buffer);
    }
    GLint query = 0;
    gl->GetQueryiv(GL_TIME_ELAPSED, GL_CURRENT_QUERY, &query);
    if (gl->GetError() == GL_NO_ERROR)
        snprintf(text->lines[text->count++], sizeof text->lines[0], "TIME_ELAPSED query = %d", query);
    assert_true(text->count > 90);
}

/* The line whose name that is, made to hold other numbers. */
static inline void state_set_line(struct state_text *text, const char *name, const char *numbers)
{
    for (int i = 0; i < text->count; i++) {
        if (strncmp(text->lines[i], name, strlen(name)) != 0 || strncmp(text->lines[i] + strlen(name), " =", 2) != 0)
            continue;
        snprintf(text->lines[i], sizeof text->lines[i], "%s = %s", name, numbers);
        return;
    }
    fail_msg("no line %s", name);
}

#endif
