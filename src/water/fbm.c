/* The Fourier series that a blog post on the caustics of GPU Gems refracts its light at: waves along the hyperbolas
 * x z = constant, higher the farther out they are.
 *
 *     h = -Σ r F cos(A + 2^j S x z) / 2^j,   r = √(x² + z²), j = 1 … N
 *
 * Slopes are exact, by the chain rule:
 *
 *     ∂h/∂x = Σ r F sin(A + 2^j S x z) S z - F cos(A + 2^j S x z) x / (2^j r)
 *
 * and the same with x and z exchanged. (The post prints the negative of these.) At the middle of the tile h has the tip
 * of a cone; its slopes are 0 there by definition. */
#include "base/sine.h"
#include "base/vector.h"
#include "water/water.h"

#include <math.h>

struct fbm {
    double amplitude, scale;
    int terms;
    double rate;
};

static const struct dpl_param params[] = {
    PARAM_FLOAT(struct fbm, amplitude, 0.015, 0, 10, "",
                "F: height of the first term over twice the distance from the middle"),
    PARAM_FLOAT(struct fbm, scale, 1, 0, 1000, "radians/m²", "S: how fast the waves get denser outwards"),
    PARAM_INT(struct fbm, terms, 4, 1, 16, "", "N: terms of the series, each half as high and twice as dense"),
    PARAM_FLOAT(struct fbm, rate, 1.5, 0, 100, "radians/s", "how fast A grows; whole turns where the scene loops"),
    PARAM_END,
};

/* The series at one time. */
struct series {
    double phase; /* A, in turns */
    double scale; /* turns/m² */
    double amplitude;
    int terms;
};

static struct series series_at(const struct water_setup *setup, double time)
{
    const struct fbm *fbm = setup->params;
    double turns = fbm->rate / (2 * M_PI); /* a second */
    if (setup->loop > 0 && turns > 0)
        turns = fmax(1, round(turns * setup->loop)) / setup->loop;
    return (struct series){turns * time - floor(turns * time), fbm->scale / (2 * M_PI), fbm->amplitude, fbm->terms};
}

static struct water_shape shape(const struct water_setup *setup)
{
    return (struct water_shape){.side = setup->mesh};
}

VECTOR_CLONES static void fill(const struct series *series, int count, const double *restrict x,
                               const double *restrict z, double *restrict height, double *restrict slope_x,
                               double *restrict slope_z)
{
    double *restrict cosines = height, *restrict sines = slope_x; /* Σ cos / 2^j, Σ sin, until the last loop */
    for (int i = 0; i < count; i++)
        cosines[i] = sines[i] = 0;
    for (int j = 1; j <= series->terms; j++) {
        double power = 1 << j, scale = series->scale * power;
        for (int i = 0; i < count; i++) {
            double sine, cosine;
            sine_cosine(series->phase + scale * x[i] * z[i], &sine, &cosine);
            cosines[i] += cosine / power;
            sines[i] += sine;
        }
    }
    for (int i = 0; i < count; i++) {
        double r = sqrt(x[i] * x[i] + z[i] * z[i]);
        double along = series->amplitude * 2 * M_PI * series->scale * r * sines[i];
        double outwards = r > 0 ? series->amplitude * cosines[i] / r : 0;
        height[i] = -series->amplitude * r * cosines[i];
        slope_x[i] = along * z[i] - outwards * x[i];
        slope_z[i] = along * x[i] - outwards * z[i];
    }
}

static void sample(const void *state, const struct water_setup *setup, double time, struct water_points *points)
{
    (void)state;
    struct series series = series_at(setup, time);
    fill(&series, points->count, points->x, points->z, points->height, points->slope_x, points->slope_z);
}

/* (A in turns, S in turns/m², F, N). */
static int constants(const struct water_setup *setup, double time, float constants[WATER_CONSTANTS_MAX][4])
{
    struct series series = series_at(setup, time);
    constants[0][0] = (float)series.phase;
    constants[0][1] = (float)series.scale;
    constants[0][2] = (float)series.amplitude;
    constants[0][3] = (float)series.terms;
    return 1;
}

const struct water_model water_fbm = {
    .name = "fbm",
    .summary = "a Fourier series of waves along hyperbolas, after a blog on GPU Gems; exact slopes, bounded, loops",
    .source = "blog on GPU Gems, ch. 2",
    .params = params,
    .params_size = sizeof(struct fbm),
    .shape = shape,
    .sample = sample,
    .shader = "water/fbm.glsl",
    .constants = constants,
};
