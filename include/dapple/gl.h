/* dapple/gl.h: dapple inside an OpenGL context, the caller's own or one without a window.
 *
 * Needed: OpenGL 3.3 core or OpenGL ES 3.0; compute shaders of OpenGL 4.3 and OpenGL ES 3.1 are used where they are.
 * dapple links no OpenGL library: it asks for every function by name.
 *
 * The state of the caller's context. Every call that takes a struct dpl_gl, or an object made with one, expects the
 * state in which OpenGL starts, and leaves it so, with these exceptions:
 *   - the viewport may be anything before and is the one drawn to last after;
 *   - bindings of the framebuffer (draw and read), the vertex array, the array buffer, the program, the active
 *     texture unit, textures of units 0 to 15, the renderbuffer and shader storage buffer 0 may be anything
 *     before and are 0 (unit 0) after, except the framebuffer handed to dpl_renderer_draw(), which stays bound for
 *     drawing and reading;
 *   - the clear colour, the blend function and the scissor box may be anything before and after;
 *   - pixel store parameters are the defaults before and after;
 *   - errors that OpenGL still holds from before are dropped, and there are none after.
 * tests/gpu_state.c holds this contract against a context.
 *
 * Threads: use a struct dpl_gl, and what was made with it, only on the thread where its context is current. */
#ifndef DAPPLE_GL_H
#define DAPPLE_GL_H

#include "dapple/log.h"

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

struct dpl_gl;

struct dpl_gl_options {
    /* Returns the address of an OpenGL function, NULL where there is none. */
    void *(*get_proc_address)(void *user, const char *name);
    void *user;
    /* A folder to read shaders from in place of those built in (the repository's src/); NULL: those built in. */
    const char *shader_folder;
    bool plain; /* use only what OpenGL 3.3 or OpenGL ES 3.0 has, even where the device has more */
};

/* Uses the context that is current on this thread. Returns NULL, with the reason logged, where it is too old. */
DPL_API struct dpl_gl *dpl_gl_create(const struct dpl_gl_options *options, const struct dpl_log *log);

/* Makes a context of its own through EGL, without a display or window, and makes it current on this thread.
 * `es` asks for OpenGL ES 3.0 in place of OpenGL 3.3. Returns NULL where EGL or a driver is missing. */
DPL_API struct dpl_gl *dpl_gl_create_headless(bool es, const char *shader_folder, const struct dpl_log *log);

/* After everything that was made with it; the context must be current. NULL is allowed. A context of its own ends with
 * its EGL display, which EGL shares within a process: one headless struct dpl_gl at a time. */
DPL_API void dpl_gl_destroy(struct dpl_gl *gl);

/* What the device is and can do. Text belongs to the struct dpl_gl. */
struct dpl_gl_info {
    const char *vendor, *renderer, *version;
    bool es;            /* OpenGL ES */
    bool software;      /* runs on the CPU: Mesa's llvmpipe or softpipe, SwiftShader */
    bool float_render;  /* can draw to 16- and 32-bit float textures */
    bool timer_queries; /* can time passes on the device */
    bool polygon_mode;  /* can draw wireframe */
    bool compute;       /* has compute shaders, and storage buffers that fragment shaders can read */
    bool geometry;      /* has geometry shaders */
    bool float_blend;   /* can add up 32-bit floats by blending */
    bool float_linear;  /* can filter 32-bit floats */
    int texture_max;    /* largest side of a texture, texels */
    int samples_max;    /* most samples a pixel */
    int point_max;      /* widest point, pixels */
    int storage_max;    /* largest storage buffer, bytes */
};
DPL_API const struct dpl_gl_info *dpl_gl_describe(const struct dpl_gl *gl);

/* What the device lacks, and what is done in its place: one line each; NULL past the last. */
DPL_API const char *dpl_gl_fallback(const struct dpl_gl *gl, int index);

#ifdef __cplusplus
}
#endif

#endif
