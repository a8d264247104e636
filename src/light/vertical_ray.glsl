/* The GPU's half of vertical_ray.c; the steps are numbered in vertical_ray.h. */
#include "water/surface.glsl"
#include "optics/refraction.glsl"
uniform sampler2D sun_picture;
uniform float sun_reach;     /* sine of the angle from the zenith to the middle of the picture's edge */
uniform float ior;
uniform float apart;         /* m, from a point to where heights are taken for differences */
uniform int by_differences;  /* 1: of heights; 0: from the surface's slopes */
uniform vec3 square;         /* m: x and z where the target starts, and its side */

/* A point moved into bounded water, past whose edge there is none. */
vec2 in_water(vec2 xz)
{
    return surface_periodic != 0 ? xz : clamp(xz, -0.5 * surface_size, 0.5 * surface_size);
}

vec2 find_slopes(vec2 xz)
{
    vec2 at = in_water(xz);
    if (by_differences == 0)
        return surface_between(at).yz;
    vec2 before = in_water(at - apart), after = in_water(at + apart);
    float along = surface_between(vec2(after.x, at.y)).x - surface_between(vec2(before.x, at.y)).x;
    float across = surface_between(vec2(at.x, after.y)).x - surface_between(vec2(at.x, before.y)).x;
    return vec2(along, across) / (after - before);
}

/* What is seen straight up from a point. */
float brightness_at(vec2 xz)
{
    vec2 slopes = find_slopes(xz);
    vec3 ray;
    bool leaves = optics_refract_out(vec3(0.0, 1.0, 0.0), normalize(vec3(-slopes.x, 1.0, -slopes.y)), ior, ray);
    float seen = texture(sun_picture, 0.5 + 0.5 * ray.xz / sun_reach).x;
    return leaves ? seen : 0.0;
}
