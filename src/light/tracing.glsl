/* What the techniques that follow single rays share: the GPU's twin of light/tracing.c and reference/ray.c. */
#include "optics/refraction.glsl"
#include "water/surface.glsl"
uniform vec3 sun;            /* unit vector towards its middle */
uniform float ior, receiver; /* its height, m */
uniform float texels_a_meter;
uniform vec4 flat_water;     /* under flat water: how far light moves along x and z for each metre of height, its way to
                                the receiver, and what makes flux through a patch 1 */
uniform vec4 flat_offset;    /* texels: where flat water's middle is seen, as x, y */
uniform vec3 absorption;     /* 1/m; 0 above the surface */
uniform vec3 channels;       /* 1 where light is to be added */

/* A point of the surface at rest, and what water/surface.h tells of it. */
struct water_point {
    vec2 place, shift; /* m, place from the tile's middle */
    vec3 water;        /* height, slopes */
    float area;        /* seen from above, to that at rest */
};

struct ray_end {
    vec2 moved;   /* m, from where flat water sends the ray to */
    float flux;   /* in units of flat water's, before absorption; 0: no light */
    float longer; /* m, than the way under flat water */
};

ray_end trace_ray(vec3 water, vec3 to_light)
{
    vec3 slanted = vec3(-water.y, 1.0, -water.z), normal = normalize(slanted);
    float facing = dot(to_light, slanted), cosine = clamp(dot(to_light, normal), 1e-6, 1.0);
    bool up = receiver > 0.0;
    vec3 direction = up ? optics_reflect(to_light, normal) : optics_refract(to_light, normal, ior);
    float reflectance = optics_fresnel_reflectance(cosine, ior), rise = up ? direction.y : -direction.y;
    if (facing <= 0.0 || to_light.y <= 0.0 || rise <= 1e-6)
        return ray_end(vec2(0.0), 0.0, 0.0);
    float height = up ? min(water.x, receiver) : max(water.x, receiver); /* water beyond the receiver lies on it */
    vec2 moved = (direction.xz / direction.y - flat_water.xy) * (receiver - height) - flat_water.xy * height;
    float share = up ? reflectance : 1.0 - reflectance;
    return ray_end(moved, facing * share * flat_water.w, abs(receiver - height) / rise - flat_water.z);
}

/* The surface by straight lines between its vertices. `place`: 0 to 1 along the tile's sides. */
water_point find_water(vec2 place)
{
    ivec2 count = textureSize(surface_texels, 0), cells = surface_periodic != 0 ? count : count - 1;
    vec2 at = place * vec2(cells), inside;
    ivec2 cell = min(ivec2(at), cells - 1);
    inside = at - vec2(cell);
    vec3 upper = mix(surface_vertex(cell), surface_vertex(cell + ivec2(1, 0)), inside.x);
    vec3 lower = mix(surface_vertex(cell + ivec2(0, 1)), surface_vertex(cell + ivec2(1, 1)), inside.x);
    water_point point = water_point((place - 0.5) * surface_size, vec2(0.0), mix(upper, lower, inside.y), 1.0);
    if (surface_choppy == 0)
        return point;
    vec2 a = surface_shift(cell), b = surface_shift(cell + ivec2(1, 0));
    vec2 c = surface_shift(cell + ivec2(0, 1)), d = surface_shift(cell + ivec2(1, 1));
    vec2 along_x = mix(b - a, d - c, inside.y) / surface_spacing();
    vec2 along_z = mix(c - a, d - b, inside.x) / surface_spacing();
    point.shift = mix(mix(a, b, inside.x), mix(c, d, inside.x), inside.y);
    point.area = (1.0 + along_x.x) * (1.0 + along_z.y) - along_x.y * along_z.x;
    return point;
}

/* pcg4d of Jarzynski & Olano 2020. */
uvec4 mix_bits(uvec4 v)
{
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> 16u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

/* 0 to 1 without 1, of as many bits as a float holds. */
vec4 unit(uvec4 bits)
{
    return vec4(bits >> 8u) * (1.0 / 16777216.0);
}
