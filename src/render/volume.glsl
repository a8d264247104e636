/* The light in the water, and what sight through it gains and loses.
 *
 * Sea water scatters so much forwards that what it scatters within a few degrees may count as not scattered at all: the
 * phase function is a peak, share g², and a smooth rest of asymmetry g / (1 + g) (Joseph, Wiscombe & Weinman 1976, eqs.
 * 2, 5). `extinction` is absorption and scattering without the peak: what is seen through water, and the caustics, lose
 * that. The glow of the water has the peak too, and light that is scattered many times (volume_source). */
#include "optics/phase.glsl"

uniform vec3 absorption, scattering, extinction; /* 1/m */
uniform float anisotropy;            /* mean cosine of the angle of scattering */
uniform float diffuse_slant;         /* m of its way for each m of depth */
uniform vec3 sun_way;                /* unit vector, of the sun's light under flat water */
uniform vec3 sun_below;              /* irradiance across sun_way just below flat water */
uniform vec3 diffuse_below;          /* irradiance of light from all around, on a horizontal surface there */

/* What is left of the sun's light at a depth below the rest surface, in m. */
vec3 volume_sun(float depth)
{
    return exp(-extinction * depth / -sun_way.y);
}

/* Radiance that a metre of sight gains for each unit of irradiance from one direction, where light has gone `way`
 * metres in the water when it arrives; `cosine`: between the light's way and the way to the eye; `narrow`: 1, or the
 * mean cosine of light that comes from around the direction.
 *
 * On its way light is scattered n times, with Poisson's probability for a mean x = scattering way; each of the n may be
 * the one here, and after n times the phase function is again Henyey & Greenstein's, of anisotropy to the power n. The
 * sum over all n >= 1 is (1 - exp(-x)) / x times the phase function of about the mean n. */
vec3 volume_source(float cosine, float narrow, float way)
{
    vec3 x = max(scattering * way, 1e-3), share = (1.0 - exp(-x)) / x;
    float g = sign(anisotropy) * pow(abs(anisotropy) * narrow, 1.0 / share.g);
    return scattering * share * optics_phase(cosine, g) * exp(-absorption * way);
}

/* What light from one direction adds to a sight of `way` metres along `ray` from a depth; `light`: its irradiance
 * across its way just below the surface, `slant`: metres of that for each of depth. By Gauss's two points, at
 * (1 ± 1/√3) / 2 of what fades; how fast that is green says, with a little of the scattering, which keeps most of the
 * light. */
vec3 volume_glow_of(vec3 light, vec3 light_way, float slant, float narrow, float depth, vec3 ray, float way)
{
    float growth = 1.0 - ray.y * slant, sight = max(way, 1e-4), cosine = -dot(light_way, ray);
    float x = max((absorption.g + 0.05 * scattering.g) * growth * sight, -60.0);
    x = abs(x) < 1e-3 ? 1e-3 : x;
    vec2 left = 1.0 - vec2(0.21132487, 0.78867513) * (1.0 - exp(-x));
    vec2 passed = max(depth * slant + growth * sight / x * -log(left), 0.0);
    vec2 weight = 0.5 * sight / x * (1.0 - exp(-x)) / left;
    return light * (weight.x * volume_source(cosine, narrow, passed.x) +
                    weight.y * volume_source(cosine, narrow, passed.y));
}

/* What flat water's light adds to a sight of `way` metres along `ray` that starts at a depth. */
vec3 volume_glow(float depth, vec3 ray, float way)
{
    if (ray.y > 0.0)
        way = min(way, depth / ray.y);
    return volume_glow_of(sun_below, sun_way, 1.0 / -sun_way.y, 1.0, depth, ray, way) +
           volume_glow_of(diffuse_below * diffuse_slant, vec3(0.0, -1.0, 0.0), diffuse_slant, 1.0 / diffuse_slant,
                          depth, ray, way);
}
