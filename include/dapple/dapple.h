/* dapple/dapple.h: all of dapple.
 *
 *     struct dpl_scene *scene = dpl_scene_create(&log);
 *     dpl_scene_load(scene, "collard-1");
 *     struct dpl_renderer *renderer = dpl_renderer_create(gl, DPL_DEVICE_AUTO, &log);
 *     dpl_renderer_draw(renderer, scene, time, framebuffer, width, height);
 */
#ifndef DAPPLE_DAPPLE_H
#define DAPPLE_DAPPLE_H

#include "dapple/gl.h"
#include "dapple/image.h"
#include "dapple/log.h"
#include "dapple/measure.h"
#include "dapple/param.h"
#include "dapple/renderer.h"
#include "dapple/scene.h"

#endif
