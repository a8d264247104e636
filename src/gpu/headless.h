/* gpu/headless.h: an OpenGL context through EGL, without a display. libEGL is opened at run time. */
#ifndef GPU_HEADLESS_H
#define GPU_HEADLESS_H

struct gpu_headless;

/* Ends the context. NULL is allowed. */
void headless_destroy(struct gpu_headless *headless);

#endif
