#include "gpu/gl.h"

#include "base/log.h"
#include "gpu/headless.h"
#include "gpu/texture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Those that dapple uses, as dapple/gl.h says. */
#define STORAGE_BUFFERS 1

static bool load_functions(struct dpl_gl *gl, const struct dpl_gl_options *options)
{
#define GPU_LOAD(type, name)                                                                                           \
    gl->name = (type)options->get_proc_address(options->user, "gl" #name);                                             \
    if (!gl->name)                                                                                                     \
        return base_fail(gl->log, DPL_REASON_NO_GL, "OpenGL function gl%s is missing", #name);
    GPU_FUNCTIONS(GPU_LOAD)
#undef GPU_LOAD
    return true;
}

static bool has_extension(struct dpl_gl *gl, const char *name)
{
    GLint count = 0;
    gl->GetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; i++)
        if (!strcmp((const char *)gl->GetStringi(GL_EXTENSIONS, (GLuint)i), name))
            return true;
    return false;
}

static bool is_software(const char *renderer)
{
    static const char *const names[] = {"llvmpipe", "softpipe", "SwiftShader", "Software Rasterizer"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strstr(renderer, names[i]))
            return true;
    return false;
}

static bool is_version(struct dpl_gl *gl, int least_gl, int least_es)
{
    GLint major = 0, minor = 0;
    gl->GetIntegerv(GL_MAJOR_VERSION, &major);
    gl->GetIntegerv(GL_MINOR_VERSION, &minor);
    return major * 10 + minor >= (gl->info.es ? least_es : least_gl);
}

static bool check_version(struct dpl_gl *gl)
{
    const char *version = (const char *)gl->GetString(GL_VERSION);
    if (!version)
        return base_fail(gl->log, DPL_REASON_NO_GL, "no OpenGL context is current on this thread");
    gl->info.es = strstr(version, "OpenGL ES") != NULL;
    if (!is_version(gl, 33, 30))
        return base_fail(gl->log, DPL_REASON_NO_GL, "OpenGL is too old: %s (OpenGL 3.3 or OpenGL ES 3.0 is needed)",
                         version);
    gl->info.version = version;
    gl->info.vendor = (const char *)gl->GetString(GL_VENDOR);
    gl->info.renderer = (const char *)gl->GetString(GL_RENDERER);
    gl->info.software = is_software(gl->info.renderer);
    return true;
}

static void add_fallback(struct dpl_gl *gl, bool lacks, const char *text)
{
    int count = 0;
    while (gl->fallbacks[count])
        count++;
    if (lacks && count < GPU_FALLBACKS_MAX)
        gl->fallbacks[count] = text;
}

/* Compute shaders, whose buffers a fragment shader can read too: OpenGL ES 3.1 alone does not promise that. */
static void detect_compute(struct dpl_gl *gl, const struct dpl_gl_options *options)
{
    GLint blocks = 0;
    if (options->plain || !is_version(gl, 43, 31))
        return;
    gl->GetIntegerv(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, &blocks);
    gl->GetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &gl->info.storage_max);
    if (blocks < STORAGE_BUFFERS)
        return;
    gl->DispatchCompute = (PFNGLDISPATCHCOMPUTEPROC)options->get_proc_address(options->user, "glDispatchCompute");
    gl->MemoryBarrier = (PFNGLMEMORYBARRIERPROC)options->get_proc_address(options->user, "glMemoryBarrier");
    gl->info.compute = gl->DispatchCompute && gl->MemoryBarrier;
}

static void detect_abilities(struct dpl_gl *gl, const struct dpl_gl_options *options)
{
    enum { ALIASED_POINT_SIZE_RANGE = 0x846D }; /* OpenGL ES's name, which the core profile dropped */
    GLint points[2] = {1, 1};
    gl->GetIntegerv(GL_MAX_TEXTURE_SIZE, &gl->info.texture_max);
    gl->GetIntegerv(GL_MAX_SAMPLES, &gl->info.samples_max);
    gl->GetIntegerv(gl->info.es ? ALIASED_POINT_SIZE_RANGE : GL_POINT_SIZE_RANGE, points);
    gl->info.point_max = points[1];
    gl->info.float_render =
        texture_can_render(gl, GL_RGBA32F) && texture_can_render(gl, GL_RGBA16F) && texture_can_render(gl, GL_R16F);
    gl->info.timer_queries = !gl->info.es || has_extension(gl, "GL_EXT_disjoint_timer_query");
    if (!gl->info.es)
        gl->PolygonMode = (PFNGLPOLYGONMODEPROC)options->get_proc_address(options->user, "glPolygonMode");
    gl->info.polygon_mode = gl->PolygonMode != NULL;
    gl->info.geometry = !gl->info.es;
    gl->info.float_linear = !gl->info.es || has_extension(gl, "GL_OES_texture_float_linear");
    gl->info.float_blend = gl->info.float_render && (!gl->info.es || has_extension(gl, "GL_EXT_float_blend"));
    detect_compute(gl, options);
    add_fallback(gl, !gl->info.float_render,
                 "no drawing to float textures: surfaces and caustic maps are computed on "
                 "the CPU and uploaded");
    add_fallback(gl, !gl->info.timer_queries, "no timer queries: passes are timed by waiting for the device");
    add_fallback(gl, !gl->info.polygon_mode, "no polygon mode: wireframe is drawn filled");
    add_fallback(gl, !gl->info.compute, "no compute shaders: light is added up by blending");
    add_fallback(gl, !gl->info.compute && !gl->info.float_blend,
                 "no blending of 32-bit floats: light is added up in 16 bits, which shows in the brightest lines");
    add_fallback(gl, !gl->info.geometry,
                 "no geometry shaders: wavefront.variant = geometry is drawn as neighbours, with the same result");
    add_fallback(gl, gl->info.software,
                 "OpenGL runs on the CPU: techniques with a CPU path of their own use that "
                 "unless --device gl is given");
}

struct dpl_gl *dpl_gl_create(const struct dpl_gl_options *options, const struct dpl_log *log)
{
    struct dpl_gl *gl = base_allocate(log, 1, sizeof *gl, "OpenGL functions");
    if (!gl)
        return NULL;
    gl->log = log;
    gl->generation = 1;
    gl->shader_folder = options->shader_folder ? strdup(options->shader_folder) : NULL;
    bool copied = gl->shader_folder || !options->shader_folder;
    if (!copied || !load_functions(gl, options) || !check_version(gl)) {
        free(gl->shader_folder);
        free(gl);
        return NULL;
    }
    gpu_enter(gl);
    detect_abilities(gl, options);
    gl->GenVertexArrays(1, &gl->empty_array);
    gpu_leave(gl, 0);
    return gl;
}

void dpl_gl_destroy(struct dpl_gl *gl)
{
    if (!gl)
        return;
    gpu_leave(gl, 0);
    gl->DeleteVertexArrays(1, &gl->empty_array);
    headless_destroy(gl->headless);
    free(gl->shader_folder);
    free(gl);
}

const struct dpl_gl_info *dpl_gl_describe(const struct dpl_gl *gl)
{
    return &gl->info;
}

const char *dpl_gl_fallback(const struct dpl_gl *gl, int index)
{
    return index >= 0 && index < GPU_FALLBACKS_MAX ? gl->fallbacks[index] : NULL;
}

void gpu_draw_screen(struct dpl_gl *gl)
{
    gl->BindVertexArray(gl->empty_array);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
}

void gpu_enter(struct dpl_gl *gl)
{
    while (gl->GetError() != GL_NO_ERROR) {
        /* what went wrong before is not this call's fault */
    }
    gl->ActiveTexture(GL_TEXTURE0);
}

bool gpu_check(struct dpl_gl *gl)
{
    bool ok = true;
    for (GLenum error; (error = gl->GetError()) != GL_NO_ERROR; ok = false) {
        if (error == GL_OUT_OF_MEMORY)
            base_fail(gl->log, DPL_REASON_LIMIT, "the device is out of memory (smaller maps, meshes or pictures help)");
        else
            base_fail(gl->log, DPL_REASON_UNSUPPORTED, "OpenGL refused a call: error 0x%04x", error);
    }
    return ok;
}

void gpu_leave(struct dpl_gl *gl, unsigned framebuffer)
{
    for (GLenum unit = GPU_TEXTURE_UNITS; unit-- > 0;) {
        gl->ActiveTexture(GL_TEXTURE0 + unit);
        gl->BindTexture(GL_TEXTURE_2D, 0);
        gl->BindTexture(GL_TEXTURE_2D_ARRAY, 0);
    }
    for (GLuint index = 0; gl->info.compute && index < STORAGE_BUFFERS; index++)
        gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, index, 0);
    gl->UseProgram(0);
    gl->BindVertexArray(0);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    gl->BindRenderbuffer(GL_RENDERBUFFER, 0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}
