#include "gpu/headless.h"

#include "base/log.h"
#include "gpu/gl.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

/* X(result, name without egl, parameters) */
#define EGL_FUNCTIONS(X)                                                                                               \
    X(EGLBoolean, BindAPI, (EGLenum))                                                                                  \
    X(EGLBoolean, ChooseConfig, (EGLDisplay, const EGLint *, EGLConfig *, EGLint, EGLint *))                           \
    X(EGLContext, CreateContext, (EGLDisplay, EGLConfig, EGLContext, const EGLint *))                                  \
    X(EGLBoolean, DestroyContext, (EGLDisplay, EGLContext))                                                            \
    X(EGLBoolean, Initialize, (EGLDisplay, EGLint *, EGLint *))                                                        \
    X(EGLBoolean, MakeCurrent, (EGLDisplay, EGLSurface, EGLSurface, EGLContext))                                       \
    X(EGLBoolean, Terminate, (EGLDisplay))                                                                             \
    X(const char *, QueryString, (EGLDisplay, EGLint))                                                                 \
    X(__eglMustCastToProperFunctionPointerType, GetProcAddress, (const char *))

struct gpu_headless {
    void *library;
#define EGL_MEMBER(result, name, parameters) result(*name) parameters;
    EGL_FUNCTIONS(EGL_MEMBER)
#undef EGL_MEMBER
    EGLDisplay display;
    EGLContext context;
};

/* dlsym() returns an object pointer; ISO C converts it to a function pointer only through memory. */
static bool load_symbol(void *library, const char *name, void *function)
{
    void *symbol = dlsym(library, name);
    memcpy(function, &symbol, sizeof symbol);
    return symbol != NULL;
}

static bool load_egl(struct gpu_headless *headless)
{
    headless->library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!headless->library)
        return false;
    bool ok = true;
#define EGL_LOAD(result, name, parameters) ok = load_symbol(headless->library, "egl" #name, &headless->name) && ok;
    EGL_FUNCTIONS(EGL_LOAD)
#undef EGL_LOAD
    return ok;
}

static bool open_display(struct gpu_headless *headless, EGLenum platform, void *native)
{
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_display =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)headless->GetProcAddress("eglGetPlatformDisplayEXT");
    headless->display = get_display ? get_display(platform, native, NULL) : EGL_NO_DISPLAY;
    return headless->display && headless->Initialize(headless->display, NULL, NULL);
}

static bool open_context(struct gpu_headless *headless, bool es)
{
    const EGLint choice[] = {EGL_RENDERABLE_TYPE, es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                             EGL_NONE};
    const EGLint core[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLint embedded[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
    EGLConfig config;
    EGLint count = 0;
    if (!headless->BindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API) ||
        !headless->ChooseConfig(headless->display, choice, &config, 1, &count) || !count)
        return false;
    headless->context = headless->CreateContext(headless->display, config, EGL_NO_CONTEXT, es ? embedded : core);
    return headless->context != EGL_NO_CONTEXT &&
           headless->MakeCurrent(headless->display, EGL_NO_SURFACE, EGL_NO_SURFACE, headless->context);
}

static void close_display(struct gpu_headless *headless)
{
    if (!headless->display)
        return;
    headless->MakeCurrent(headless->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (headless->context)
        headless->DestroyContext(headless->display, headless->context);
    headless->Terminate(headless->display);
    headless->context = EGL_NO_CONTEXT;
    headless->display = EGL_NO_DISPLAY;
}

/* A context on the first device; where that has none of the version wanted, on Mesa's surfaceless platform. */
static bool open_any(struct gpu_headless *headless, bool es)
{
    PFNEGLQUERYDEVICESEXTPROC query_devices = (PFNEGLQUERYDEVICESEXTPROC)headless->GetProcAddress("eglQueryDevicesEXT");
    const char *extensions = headless->QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    EGLDeviceEXT device;
    EGLint count = 0;
    if (!extensions)
        return false;
    if (query_devices && strstr(extensions, "EGL_EXT_platform_device") && query_devices(1, &device, &count) && count) {
        if (open_display(headless, EGL_PLATFORM_DEVICE_EXT, device) && open_context(headless, es))
            return true;
        close_display(headless);
    }
    return strstr(extensions, "EGL_MESA_platform_surfaceless") &&
           open_display(headless, EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY) && open_context(headless, es);
}

void headless_destroy(struct gpu_headless *headless)
{
    if (!headless)
        return;
    close_display(headless);
    if (headless->library)
        dlclose(headless->library);
    free(headless);
}

static void *get_function(void *user, const char *name)
{
    struct gpu_headless *headless = user;
    void *address;
    __eglMustCastToProperFunctionPointerType function = headless->GetProcAddress(name);
    memcpy(&address, &function, sizeof address);
    return address;
}

struct dpl_gl *dpl_gl_create_headless(bool es, const char *shader_folder, const struct dpl_log *log)
{
    struct gpu_headless *headless = base_allocate(log, 1, sizeof *headless, "EGL functions");
    if (!headless)
        return NULL;
    struct dpl_gl *gl = NULL;
    if (!load_egl(headless))
        base_fail(log, DPL_REASON_NO_GL, "no OpenGL: libEGL.so.1 cannot be opened (Debian: libegl1, libgl1-mesa-dri)");
    else if (!open_any(headless, es))
        base_fail(log, DPL_REASON_NO_GL,
                  "no OpenGL: EGL makes no context of %s without a window (Debian: libgl1-mesa-dri)",
                  es ? "OpenGL ES 3.0" : "OpenGL 3.3");
    else
        gl = dpl_gl_create(&(struct dpl_gl_options){.get_proc_address = get_function,
                                                    .user = headless,
                                                    .shader_folder = shader_folder},
                           log);
    if (gl)
        gl->headless = headless;
    else
        headless_destroy(headless);
    return gl;
}
