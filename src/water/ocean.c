/* An ocean of waves with measured spectra, summed by Fourier transforms (Tessendorf 2001; over a floor with caustics:
 * Jensen & Golias 2001).
 *
 * 1. When a number changes: each wave number k = 2π (m, n) / period gets a random complex amplitude with the variance
 *    that a spectrum has there (ocean_spectrum.c), and the frequency of the dispersion relation ω² = g k tanh(k depth).
 * 2. At a time: amplitudes turn by ω t; heights are their inverse Fourier transform, and, where the sea is choppy, so
 * are horizontal shifts that sharpen crests. Two real fields go into one complex transform (ocean_waves.c).
 * 3. What is transformed are not heights but the coefficients of a cubic spline through them, so that the surface is
 *    smooth between them, and known, with its slopes, at any point (ocean_surface.c, ocean_gpu.c).
 *
 * Cascades do this several times: the c-th has the tile repeat 4^c times and holds waves that the ones before are too
 * coarse for, so that small transforms reach from long waves to short ones. Waves have four vertices at least, and
 * no two cascades the same wave lengths. */
#include "water/ocean.h"

#include "base/log.h"

#define MESH_MAX 4096 /* vertices a side where nobody asks for a number */

static const char *spectrum_name(int i)
{
    static const char *const names[] = {"phillips", "jonswap", "tma"};
    return i >= 0 && i <= OCEAN_TMA ? names[i] : NULL;
}

static const char *resolution_name(int i)
{
    static const char *const names[] = {"32", "64", "128", "256", "512", "1024"};
    return i >= 0 && i < 6 ? names[i] : NULL;
}

static const struct dpl_param params[] = {
    PARAM_CHOICE(
        struct ocean, spectrum, OCEAN_TMA, spectrum_name,
        "energy of the waves: phillips = full-grown (Phillips 1958, Tessendorf 2001), jonswap = young, of deep "
        "water (Hasselmann et al. 1973), tma = jonswap in water of the scene's depth (Bouws et al. 1985)"),
    PARAM_FLOAT(struct ocean, wind_speed, 5, 0, 60, "m/s", "at 10 m above the water"),
    PARAM_FLOAT(struct ocean, wind_direction, 0, -360, 360, "degrees",
                "where the wind and the waves go to, from +x towards +z"),
    PARAM_FLOAT(struct ocean, fetch, 200, 1, 1e7, "m", "way of the wind over water so far (jonswap, tma)"),
    PARAM_FLOAT(struct ocean, peak_enhancement, 3.3, 1, 20, "", "γ, the height of the spectrum's peak (jonswap, tma)"),
    PARAM_FLOAT(struct ocean, spreading, 1, 0.05, 20, "",
                "width of the waves' directions to what was measured (Donelan et al. 1985); small = long crests "
                "(jonswap, tma)"),
    PARAM_FLOAT(struct ocean, smoothing, 0.05, 0, 100, "m",
                "takes away short waves: their energy falls by exp(-(k smoothing)²); 0 = leaves them"),
    PARAM_FLOAT(struct ocean, amplitude, 1, 0, 10, "", "heights to those of the spectrum"),
    PARAM_FLOAT(struct ocean, choppiness, 0, 0, 1, "",
                "how far points move horizontally, which sharpens crests; 0 = not at all, 1 = as far as up and down"),
    PARAM_CHOICE(struct ocean, resolution, 2, resolution_name,
                 "vertices a side of a cascade; the shortest wave has four of the last cascade's"),
    PARAM_INT(struct ocean, cascades, 2, 1, OCEAN_CASCADES_MAX, "",
              "scales of waves, each four times as fine as the one before"),
    PARAM_END,
};

/* As many vertices as the last cascade has along the tile, so that none of its own is left out. */
static struct water_shape shape(const struct water_setup *setup)
{
    const struct ocean *ocean = setup->params;
    int cells = 32 << (ocean->resolution + 2 * (ocean->cascades - 1)), side = cells < MESH_MAX ? cells : MESH_MAX;
    return (struct water_shape){
        .side = setup->mesh > 0 ? setup->mesh : side,
        .periodic = true,
        .choppy = ocean->choppiness > 0,
    };
}

static bool prepare(void *state, const struct water_setup *setup, double time, const struct dpl_log *log)
{
    return ocean_waves_prepare(state, setup, time, log) && ocean_surface_prepare(state, shape(setup).side, log);
}

static void evaluate(void *state, const struct water_setup *setup, double time, struct surface *surface)
{
    (void)setup, (void)time; /* those of prepare() */
    ocean_surface_evaluate(state, surface);
}

static void sample(const void *state, const struct water_setup *setup, double time, struct water_points *points)
{
    (void)setup, (void)time;
    ocean_surface_sample(state, points);
}

static bool draw(void *state, struct dpl_gl *gl, const struct water_setup *setup, double time,
                 struct gpu_texture *texels, struct gpu_texture *shifts)
{
    (void)time;
    return ocean_gpu_draw(state, gl, shape(setup).side, texels, shifts);
}

static void finish(void *state_, struct dpl_gl *gl)
{
    struct ocean_state *state = state_;
    ocean_waves_finish(state);
    ocean_surface_finish(state);
    if (gl)
        ocean_gpu_finish(state, gl);
    *state = (struct ocean_state){0};
}

const struct water_model water_ocean = {
    .name = "ocean",
    .summary = "an FFT ocean: waves of a measured spectrum from wind, fetch and depth; cascades, choppy or not",
    .source = "Tessendorf 2001; Jensen & Golias 2001",
    .params = params,
    .params_size = sizeof(struct ocean),
    .state_size = sizeof(struct ocean_state),
    .shape = shape,
    .prepare = prepare,
    .evaluate = evaluate,
    .sample = sample,
    .draw = draw,
    .finish = finish,
};
