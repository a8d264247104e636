#include "scene/sway.h"

#include "scene/world.h"

#include <math.h>

#define LAG 0.12 /* waves a metre upwards: tips follow their stalks */

/* The waves: period and length in those of the current; degrees off its direction. No two periods have a short common
 * multiple, so that what is seen does not repeat soon. */
static const struct {
    double period, length, off;
} waves[SWAY_WAVES] = {{1, 1, 0}, {0.618, 0.55, 40}, {1.47, 1.3, -60}};

void sway_now(const struct dpl_scene *scene, double time, struct sway *sway)
{
    const struct scene_current *current = &scene->current;
    double loop = scene->settings.loop, azimuth = current->azimuth * M_PI / 180;
    for (int w = 0; w < SWAY_WAVES; w++) {
        double towards = azimuth + waves[w].off * M_PI / 180, length = current->length * waves[w].length;
        double period = current->period * waves[w].period;
        if (loop > 0)
            period = loop / fmax(1, round(loop / period));
        double phase = -time / period;
        sway->waves[w][0] = (float)(cos(towards) / length);
        sway->waves[w][1] = (float)LAG;
        sway->waves[w][2] = (float)(sin(towards) / length);
        sway->waves[w][3] = (float)(phase - floor(phase));
    }
    sway->current[0] = (float)(current->strength * cos(azimuth));
    sway->current[1] = (float)(current->strength * sin(azimuth));
    sway->current[2] = sway->current[3] = 0;
}

void sway_move(const struct sway *sway, const float position[3], float reach, float moved[3])
{
    float heights[SWAY_WAVES];
    for (int w = 0; w < SWAY_WAVES; w++) {
        const float *wave = sway->waves[w];
        float turns = wave[0] * position[0] + wave[1] * position[1] + wave[2] * position[2] + wave[3];
        heights[w] = sinf(6.28318531f * (turns - floorf(turns)));
    }
    float along = 0.55f * heights[0] + 0.25f * heights[1], across = 0.3f * heights[2];
    moved[0] = reach * (along * sway->current[0] - across * sway->current[1]);
    moved[1] = 0;
    moved[2] = reach * (along * sway->current[1] + across * sway->current[0]);
}
