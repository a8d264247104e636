/* reference/camera.h: the ground truth of a picture: a path tracer (Kajiya 1986) with photons for the sunlight that has
 * met water (Jensen 1996). Passes add up to a picture with less and less noise.
 *
 * Exact but for what photons smear, see reference/camera_photons.h, and for what would come after CAMERA_MEETINGS
 * scatterings of one of them. The picture is the same for any number of threads.
 */
#ifndef REFERENCE_CAMERA_H
#define REFERENCE_CAMERA_H

#include "reference/camera_path.h"

struct camera_settings {
    int bounces;                       /* most reflections by solids and scatterings in water of one path */
    double photons;                    /* of a pass, for each pixel */
    double solid_radius, water_radius; /* m: light of photons is gathered over no less, on solids and in the water */
};

/* A picture that goes on from pass to pass. All zero: none. */
struct camera {
    struct camera_scene scene;
    struct camera_photons photons;
    struct camera_sight sight;
    struct camera_settings settings;
    int passes;   /* done */
    double *sums; /* height × width × 3 */
};

/* Starts anew. What `world` points to outlives the picture. */
bool camera_begin(struct camera *camera, const struct camera_world *world, const struct camera_sight *sight,
                  const struct camera_settings *settings, const struct dpl_log *log);
/* Leaves it zeroed. */
void camera_finish(struct camera *camera);

/* One more path for each pixel. */
void camera_pass(struct camera *camera);

/* Radiance of a part of the picture after at least one pass: rows × columns × 4, the last 1; the first row is the
 * lowest. What lies beyond the picture is its edge's. */
void camera_read(const struct camera *camera, int left, int bottom, int columns, int rows, float *radiance);

#endif
