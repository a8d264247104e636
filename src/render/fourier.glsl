/* Everything in one fragment: the ray of sight meets the floor, from there a ray goes straight up, leaves the water
 * at the surface above, and samples the light. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "optics/refraction.glsl"
#ifdef SERIES
#include "water/fbm_series.glsl"
uniform vec4 series;
#else
#include "water/surface.glsl"
#endif
uniform vec3 eye, ahead, right, up;
uniform float size, depth, ior;
uniform float lamp_inner, lamp_outer; /* radians from the zenith: all of the lamp's light, and none */
uniform float ambient, lamp_brightness;
uniform vec3 background;
uniform sampler2D sand;
out vec4 color;

vec3 normal_above(vec2 xz)
{
#ifdef SERIES
    vec2 slopes = fbm(series, xz).yz;
    return normalize(vec3(-slopes.x, 1.0, -slopes.y));
#else
    return surface_normal(xz);
#endif
}

/* What the ray straight up sees. */
float light_above(vec2 xz)
{
    vec3 leaving;
    if (!optics_refract_out(vec3(0.0, 1.0, 0.0), normal_above(xz), ior, leaving))
        return 0.0;
    return lamp_brightness * (1.0 - smoothstep(lamp_inner, lamp_outer, acos(min(leaving.y, 1.0))));
}

void main()
{
    vec3 ray = ahead + (2.0 * target.x - 1.0) * right + (2.0 * target.y - 1.0) * up;
    float way = (-depth - eye.y) / ray.y;
    vec2 xz = eye.xz + way * ray.xz;
    vec3 base = texture(sand, xz / size + 0.5).rgb;
    bool hit = way > 0.0 && max(abs(xz.x), abs(xz.y)) <= 0.5 * size;
    color = vec4(hit ? min(base * (ambient + light_above(xz)), vec3(1.0)) : background, 1.0);
}
#endif
