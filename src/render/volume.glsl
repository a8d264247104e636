/* The light in the water, and what sight through it gains and loses.
 *
 * Sea water scatters so much forwards that what it scatters within a few degrees may count as not scattered at all: the
 * phase function is a peak, share g², and a smooth rest of asymmetry g / (1 + g) (Joseph, Wiscombe & Weinman 1976, eqs.
 * 2, 5). `extinction` is absorption and scattering without the peak. */
#include "optics/phase.glsl"

uniform vec3 extinction, scattering; /* 1/m, of the rest alone */
uniform vec3 diffuse_extinction;     /* 1/m of depth, of light from all around */
uniform float asymmetry;             /* of the rest */
uniform vec3 sun_way;                /* unit vector, of the sun's light under flat water */
uniform vec3 sun_below;              /* irradiance across sun_way just below flat water */
uniform vec3 diffuse_below;          /* irradiance of light from all around, on a horizontal surface there */

const float VOLUME_PI = 3.14159265;

/* The integral of exp(-rate s) for s from 0 to `way`. */
vec3 volume_integral(vec3 rate, float way)
{
    vec3 x = rate * way;
    vec3 small = step(abs(x), vec3(1e-3));
    return way * mix((1.0 - exp(-max(x, -20.0))) / mix(x, vec3(1.0), small), 1.0 - 0.5 * x, small);
}

/* What is left of the sun's light at a depth below the rest surface, in m. */
vec3 volume_sun(float depth)
{
    return exp(-extinction * depth / -sun_way.y);
}

/* What the water has scattered out of the sun's beam, most of it still on its way down, at a depth on a horizontal
 * surface; `straight` is what is left of the beam. */
vec3 volume_scattered(float depth, vec3 straight)
{
    vec3 taken = exp(-(extinction - scattering) * depth / -sun_way.y) - straight;
    return 0.8 * -sun_way.y * sun_below * max(taken, 0.0);
}

/* Light from all around at a depth, on a horizontal surface: the sky's, and what is scattered. */
vec3 volume_diffuse(float depth)
{
    return diffuse_below * exp(-diffuse_extinction * depth) + volume_scattered(depth, volume_sun(depth));
}

/* Light that is scattered into a sight of `way` metres along `ray`, where the sun's is that of flat water; from a place
 * where the sun's light across its way, and the diffuse light on a horizontal surface, are those. */
vec3 volume_glow_from(vec3 sun_there, vec3 diffuse_there, vec3 ray, float way)
{
    vec3 sun_rate = extinction * (1.0 - ray.y / -sun_way.y), diffuse_rate = extinction - diffuse_extinction * ray.y;
    /* light comes along sun_way and goes on along -ray */
    vec3 sun = sun_there * optics_phase(dot(sun_way, -ray), asymmetry);
    vec3 diffuse = diffuse_there / (2.0 * VOLUME_PI);
    return scattering * (sun * volume_integral(sun_rate, way) + diffuse * volume_integral(diffuse_rate, way));
}

vec3 volume_glow(vec3 start, vec3 ray, float way)
{
    float depth = max(-start.y, 0.0);
    return volume_glow_from(sun_below * volume_sun(depth), volume_diffuse(depth), ray, way);
}

/* The same from the rest surface. */
vec3 volume_glow_surface(vec3 ray, float way)
{
    return volume_glow_from(sun_below, diffuse_below, ray, way);
}
