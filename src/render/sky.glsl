/* The sky: its upper half as a disc (render/sky_texture.c), and the sun's. */
uniform sampler2D sky_texels;  /* the zenith in the middle, the horizon on a circle that leaves a margin */
uniform vec3 ground_radiance;  /* of what lies below the horizon */
uniform vec3 to_sun, sun_irradiance;
uniform float sun_spread;      /* radians: a normal distribution as wide as the disc */

const float SKY_PI = 3.14159265;
const float SKY_MOST = 60000.0; /* radiance that a picture of half floats, which end at 65504, has room for */
const float SKY_HORIZON = 0.45; /* radius of its circle, in sides of the texture */

/* Mean radiance around a direction, of a normal distribution of directions `spread` radians wide. */
vec3 sky_radiance(vec3 direction, float spread)
{
    vec2 place = 0.5 + SKY_HORIZON * direction.xz / (1.0 + max(direction.y, 0.0));
    float level = log2(max(spread * SKY_HORIZON * float(textureSize(sky_texels, 0).x), 1.0));
    vec3 sky = textureLod(sky_texels, place, level).rgb;
    return mix(ground_radiance, sky, smoothstep(-0.002 - spread, 0.0, direction.y));
}

/* Radiance of the sun's disc, blurred by `spread` radians. */
vec3 sky_sun(vec3 direction, float spread)
{
    float variance = sun_spread * sun_spread + spread * spread;
    float square = 2.0 * max(1.0 - dot(direction, to_sun), 0.0);
    return sun_irradiance * exp(-0.5 * square / variance) / (2.0 * SKY_PI * variance);
}
