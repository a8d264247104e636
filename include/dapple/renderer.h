/* dapple/renderer.h: from a scene and a time to the water's surface, the caustic map and the picture.
 *
 *     scene ─→ surface ─→ light (caustic map) ─→ picture
 *
 * A renderer keeps GPU objects and buffers between calls: after the first frame of a scene, a frame allocates
 * nothing. Without OpenGL (gl = NULL) the surface and, for techniques with a CPU path, the map still work.
 *
 * Deterministic: the same scene, time and device give the same bytes.
 * Threads: one thread at a time, that of the struct dpl_gl where there is one. */
#ifndef DAPPLE_RENDERER_H
#define DAPPLE_RENDERER_H

#include "dapple/gl.h"
#include "dapple/image.h"
#include "dapple/measure.h"
#include "dapple/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Where the surface and the light are computed. */
enum dpl_device {
    DPL_DEVICE_AUTO, /* on the GPU; on the CPU where OpenGL itself runs there and that is faster */
    DPL_DEVICE_GL,   /* always through OpenGL */
    DPL_DEVICE_CPU,  /* always on the CPU */
};

struct dpl_renderer;

/* `gl` may be NULL; otherwise it must outlive the renderer. Returns NULL where memory is short. */
DPL_API struct dpl_renderer *dpl_renderer_create(struct dpl_gl *gl, enum dpl_device device, const struct dpl_log *log);
DPL_API void dpl_renderer_destroy(struct dpl_renderer *renderer);

/* The water at `time` seconds on its own grid: height in metres, slope along x, slope along z, as the three channels
 * of a new image. Returns NULL on failure; the caller destroys the image. */
DPL_API struct dpl_image *dpl_renderer_surface(struct dpl_renderer *renderer, const struct dpl_scene *scene,
                                               double time);

/* The caustic map of the floor at `time` seconds, red green blue: irradiance in units of what flat water would give,
 * where the technique is a physical one; `multi-sample` is tuned by eye and gives a brightness from 0 to 1.
 * Of `caustics.ceiling`, where that is set, in place of the floor's.
 * Returns NULL on failure; the caller destroys the image. */
DPL_API struct dpl_image *dpl_renderer_map(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time);

/* The same of one of the receivers that `caustics.slices` asks for: 0 is the floor, the next lie at even steps above
 * it. An error where there is no such slice. */
DPL_API struct dpl_image *dpl_renderer_slice(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time,
                                             int slice);

/* A technique that refines its map (struct dpl_entry), or a look that refines its picture (`path-traced`), calls `step`
 * after each step, with the share that is done, 0 to 1; where that returns false map or picture is taken as it is, and
 * a later call of the same scene and time goes on from there. NULL: all are finished. */
DPL_API void dpl_renderer_progress(struct dpl_renderer *renderer, bool (*step)(void *user, double done), void *user);

/* What chance adds to the last map, as a share of the map: RMS against RMS. 0: nothing, or not known. Where the last
 * picture compared two, that of the other technique. */
DPL_API double dpl_renderer_noise(const struct dpl_renderer *renderer);

/* Draws the scene into a framebuffer of the caller's context (0: the window), over its whole width × height.
 * DPL_NO_FRAMEBUFFER draws it into nothing that can be seen and waits until the device is done: for benchmarks. */
#define DPL_NO_FRAMEBUFFER (~0u)
DPL_API bool dpl_renderer_draw(struct dpl_renderer *renderer, const struct dpl_scene *scene, double time,
                               unsigned framebuffer, int width, int height);

/* The same into a new image: displayable values 0 to 1. Any size up to DPL_IMAGE_SIDE_MAX: what the device cannot draw
 * at once is drawn in tiles. Returns NULL on failure; the caller destroys the image. */
DPL_API struct dpl_image *dpl_renderer_picture(struct dpl_renderer *renderer, const struct dpl_scene *scene,
                                               double time, int width, int height);

/* The same before exposure and tone curve, of looks with linear light (`physical`, `path-traced`): radiance, in units
 * in which the sun's irradiance outside the atmosphere is 1. Of other looks it is the picture. */
DPL_API struct dpl_image *dpl_renderer_radiance(struct dpl_renderer *renderer, const struct dpl_scene *scene,
                                                double time, int width, int height);

/* Calls `drawn` after each tile of a picture that has several. It may use OpenGL, but not the renderer. NULL: none. */
DPL_API void dpl_renderer_tiles(struct dpl_renderer *renderer, void (*drawn)(void *user, int done, int tiles),
                                void *user);

/* Whether pictures follow the path of the scene's camera, where it has one (dpl_scene_view()), as they do at first; or
 * show what [camera] itself sees. */
DPL_API void dpl_renderer_path(struct dpl_renderer *renderer, bool follows);

/* Has a drop fall into the water of the next frame, where its model can be disturbed (`ripples`): the surface moves by
 * `height` metres (up, or down where it is negative) at (x, z), and less and less up to `radius` metres around. False
 * where a number is not finite or the radius not above 0, or where too many drops wait already (64). */
DPL_API bool dpl_renderer_drop(struct dpl_renderer *renderer, double x, double z, double radius, double height);

/* Where the middle of the scene's sphere (`[sphere]`) was in the last picture; false where it had none. */
DPL_API bool dpl_renderer_sphere(const struct dpl_renderer *renderer, double center[3]);

/* How the pictures of dpl_renderer_draw() and dpl_renderer_picture() compare the scene's technique with another one. */
enum dpl_comparison {
    DPL_COMPARE_NOTHING,    /* the picture by the scene's technique alone */
    DPL_COMPARE_SPLIT,      /* to the left that by the scene's technique, to the right that by the other */
    DPL_COMPARE_DIFFERENCE, /* the floor alone, in the colours of DPL_COLORS_DIFFERENCE */
};
struct dpl_compare {
    enum dpl_comparison mode;
    int technique;      /* the other: index of dpl_technique(); of one that there is not, nothing is compared */
    double place;       /* SPLIT: where the right part starts, 0 to 1 across the picture */
    double gain, range; /* DIFFERENCE: of the scene's map × gain less the other, and what has the strongest colour */
};
DPL_API void dpl_renderer_compare(struct dpl_renderer *renderer, const struct dpl_compare *compare);

/* The scene's map of the last picture against the other technique's, as dpl_measure_map(); fitted where one of the two
 * techniques has no physical scale. An error where the last picture compared nothing. */
DPL_API bool dpl_renderer_measure(struct dpl_renderer *renderer, struct dpl_measure *measure);

/* Has the shader files read anew when they are next needed, by every renderer of this OpenGL; where one is broken, the
 * reason is logged and what was built from it before stays in use. For shaders that are being edited. */
DPL_API void dpl_renderer_reload(struct dpl_renderer *renderer);

/* How passes are timed. */
enum dpl_timing {
    DPL_TIMING_OFF,
    DPL_TIMING_QUERIES, /* on the device, a few frames late, without waiting; needs timer_queries, else it is OFF */
    DPL_TIMING_WAIT,    /* by `now`, waiting for the device after each pass: exact, and slower as a whole */
};
/* `now` returns seconds of a steady clock; needed for DPL_TIMING_WAIT only. The library itself reads no clock. */
DPL_API void dpl_renderer_time_passes(struct dpl_renderer *renderer, enum dpl_timing timing, double (*now)(void));

/* The passes of the last frame that was timed, in order; name is NULL past the last. */
struct dpl_pass_time {
    const char *name;
    double milliseconds;
};
DPL_API struct dpl_pass_time dpl_renderer_pass_time(const struct dpl_renderer *renderer, int index);

/* Textures of the last frame, for thumbnails; name is NULL past the last. Values 0 to 1 in red, green and blue. */
struct dpl_thumbnail {
    const char *name;
    unsigned texture; /* of the renderer's context, GL_TEXTURE_2D; stays the renderer's */
    int width, height;
};
DPL_API struct dpl_thumbnail dpl_renderer_thumbnail(struct dpl_renderer *renderer, int index);

#ifdef __cplusplus
}
#endif

#endif
