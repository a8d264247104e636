/* The sky: a picture of all of it (optics/sky.h), and the sun's disc. */
uniform sampler2D sky_texels;
uniform vec3 to_sun, sun_irradiance;
uniform float sun_spread; /* radians: a normal distribution as wide as the disc */

const float SKY_PI = 3.14159265;

/* Mean radiance around a direction, of a normal distribution of directions `spread` radians wide. */
vec3 sky_radiance(vec3 direction, float spread)
{
    float rows = float(textureSize(sky_texels, 0).y), level = max(log2(spread * 2.0 * rows / SKY_PI), 0.0);
    float row = acos(clamp(direction.y, -1.0, 1.0)) / SKY_PI, margin = 0.5 * exp2(level) / rows;
    float column = atan(direction.z, direction.x) / (2.0 * SKY_PI);
    return textureLod(sky_texels, vec2(column, clamp(row, margin, 1.0 - margin)), level).rgb;
}

/* Radiance of the sun's disc, blurred by `spread` radians. */
vec3 sky_sun(vec3 direction, float spread)
{
    float variance = sun_spread * sun_spread + spread * spread;
    float square = 2.0 * max(1.0 - dot(direction, to_sun), 0.0);
    return sun_irradiance * exp(-0.5 * square / variance) / (2.0 * SKY_PI * variance);
}
