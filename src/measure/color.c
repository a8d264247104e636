#include "dapple/measure.h"

#include "measure/pair.h"
#include "measure/space.h"

#include <math.h>

/* Places in Oklab, where equal distances look alike. The maps go straight from one to the next, within sRGB. */
static const double white[3] = {1, 0, 0};
static const double blue[3] = {0.45, -0.03, -0.19}, red[3] = {0.48, 0.17, 0.09};
static const double magnitudes[][3] = {{0, 0, 0}, {0.25, 0.06, -0.11}, {0.5, 0.16, 0}, {0.75, 0.08, 0.12}, {1, 0, 0}};

static void mix(const double from[3], const double to[3], double share, float color[3])
{
    double oklab[3], linear[3];
    for (int c = 0; c < 3; c++)
        oklab[c] = from[c] + (to[c] - from[c]) * share;
    space_oklab_to_linear(oklab, linear);
    for (int c = 0; c < 3; c++)
        color[c] = (float)space_srgb_encode(linear[c]);
}

void dpl_false_color(enum dpl_color_map map, double number, float color[3])
{
    const int steps = sizeof magnitudes / sizeof *magnitudes - 1;
    if (map == DPL_COLORS_DIFFERENCE) {
        mix(white, number < 0 ? blue : red, fmin(fabs(number), 1), color);
        return;
    }
    double place = fmin(fmax(number, 0), 1) * steps;
    int step = place < steps ? (int)place : steps - 1;
    mix(magnitudes[step], magnitudes[step + 1], place - step, color);
}

struct dpl_image *dpl_measure_colors(const struct dpl_image *image, const struct dpl_image *reference, double gain,
                                     double range, enum dpl_color_map map, const struct dpl_log *log)
{
    struct dpl_image *colors =
        pair_check(image, reference, log) ? dpl_image_create(image->width, image->height, log) : NULL;
    for (size_t i = 0; colors && i < pair_count(image); i += 3) {
        double difference = 0;
        for (size_t c = i; c < i + 3; c++)
            difference += (image->pixels[c] * gain - reference->pixels[c]) / (3 * range);
        dpl_false_color(map, map == DPL_COLORS_DIFFERENCE ? difference : fabs(difference), colors->pixels + i);
    }
    return colors;
}
