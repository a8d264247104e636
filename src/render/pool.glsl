/* What rays meet in the pool of Wallace's "WebGL Water" (2011), and how it is lit. Lengths are in half sides of the
 * pool, as in his: x and z from -1 to 1, the rest surface at y = 0. The numbers without a name are his. */
#include "light/map.glsl"
#include "water/surface.glsl"
#include "optics/refraction.glsl"

uniform float half_side;  /* m */
uniform float depth, rim; /* of the floor below the rest surface, of the walls above it */
uniform vec3 sphere;
uniform float sphere_radius; /* 0: none */
uniform vec3 to_sun;
uniform vec3 light_way; /* of the sun's light under flat water */
uniform float ambient, caustic;
uniform vec3 sphere_color, sun_color, sky_zenith, sky_horizon, ground;
uniform float sun_exponent;
uniform sampler2D tiles; /* red, green and blue cover the floor once; alpha: clouds */

const float NOWHERE = 1e6;     /* distance of what a ray does not meet */
const float BOX_TOP = 2.0;     /* above it there is only sky */
const float TILES_CLEAR = 0.5; /* levels that tiles are kept clearer than their size asks for, for walls seen aslant */

struct hit {
    vec3 point, normal;
    float way; /* to the point */
    bool on_sphere;
};

vec3 box_low()
{
    return vec3(-1.0, -depth, -1.0);
}

vec3 box_high()
{
    return vec3(1.0, BOX_TOP, 1.0);
}

/* Where a ray is in the slabs between the box's walls: the distances to enter and to leave the last and the first. */
vec2 meet_box(vec3 origin, vec3 ray, out vec3 normal)
{
    ray = mix(ray, vec3(1e-6), lessThan(abs(ray), vec3(1e-6)));
    vec3 low = (box_low() - origin) / ray, high = (box_high() - origin) / ray;
    vec3 near = min(low, high), far = max(low, high);
    float leave = min(min(far.x, far.y), far.z);
    vec3 axis = leave == far.x ? vec3(1, 0, 0) : leave == far.y ? vec3(0, 1, 0) : vec3(0, 0, 1);
    normal = -axis * sign(ray);
    return vec2(max(max(near.x, near.y), near.z), leave);
}

float meet_sphere(vec3 origin, vec3 ray)
{
    vec3 from = origin - sphere;
    float along = dot(from, ray), square = along * along - dot(from, from) + sphere_radius * sphere_radius;
    float way = -along - sqrt(max(square, 0.0));
    return sphere_radius > 0.0 && square > 0.0 && way > 0.0 ? way : NOWHERE;
}

hit meet(vec3 origin, vec3 ray)
{
    hit found;
    origin = clamp(origin, box_low() + 1e-4, box_high() - 1e-4);
    float box = meet_box(origin, ray, found.normal).y, ball = meet_sphere(origin, ray);
    found.on_sphere = ball < NOWHERE;
    found.way = found.on_sphere ? ball : box;
    found.point = origin + ray * found.way;
    if (found.on_sphere)
        found.normal = (found.point - sphere) / sphere_radius;
    return found;
}

float logistic(float x)
{
    return 1.0 / (1.0 + exp(-x));
}

bool under_water(vec3 point)
{
    return point.y * half_side < surface_between(point.xz * half_side).x;
}

/* The caustic map along the light's way through the point to the floor. */
vec3 light_through(vec3 point)
{
    vec2 slant = 0.5 * depth * light_way.xz / -light_way.y;
    return light_at_height(0.5 * point.xz + 0.5, point.y / depth + 1.0, slant);
}

/* The share of light that the walls above the water let pass, softer where they are far. */
float past_rim(vec3 point)
{
    vec3 unused;
    vec2 way = meet_box(point, -light_way, unused);
    float leaves_at = point.y - light_way.y * way.y;
    return logistic(200.0 / (1.0 + 10.0 * (way.y - way.x)) * (leaves_at - rim));
}

/* The share that the sphere lets pass. His program keeps it in the caustic map, as it is on the floor; here it is that
 * of the point itself, and what stands between the sphere and the sun has none of its shadow. */
float past_sphere(vec3 point)
{
    if (sphere_radius == 0.0)
        return 1.0;
    vec3 to_sphere = (sphere - point) / sphere_radius, across = cross(to_sphere, light_way);
    float along = max(-dot(to_sphere, light_way), 0.0);
    float share = logistic(1.0 + (dot(across, across) - 1.0) / (0.05 + 0.025 * along));
    return mix(1.0, share, min(2.0 * along, 1.0));
}

/* What is left of the light from all around next to something that is `distance` of its sizes away; they touch at 1. */
float nook(float distance, float power)
{
    return 1.0 - 0.9 / pow(max(distance, 1.0), power);
}

/* `spread`: how wide a pixel has become there. */
vec3 tile_color(vec3 point, vec3 normal, float spread)
{
    vec2 place = abs(normal.x) > 0.5 ? point.zy : abs(normal.z) > 0.5 ? point.xy : point.xz;
    float texels = 0.5 * float(textureSize(tiles, 0).x) * spread;
    return textureLod(tiles, 0.5 * place + 0.5, max(log2(texels) - TILES_CLEAR, 0.0)).rgb;
}

/* Light of the sun on what stands across its way, in units of what tiles are lit by. */
vec3 sun_at(vec3 point)
{
    /* Looked up outside of all conditions: it takes differences between neighbouring pixels. */
    vec3 light = light_through(point);
    return past_rim(point) * (under_water(point) ? 2.0 * caustic * light : vec3(0.5));
}

vec3 wall_color(vec3 point, vec3 normal, float spread, vec3 sun)
{
    float around = ambient / length(vec3(point.x, point.y / depth, point.z));
    if (sphere_radius > 0.0)
        around *= nook(distance(point, sphere) / sphere_radius, 4.0);
    float facing = max(-dot(light_way, normal), 0.0) * past_sphere(point);
    return tile_color(point, normal, spread) * (around + facing * sun);
}

vec3 ball_color(vec3 point, vec3 normal, vec3 sun)
{
    float around = nook((1.0 + sphere_radius - abs(point.x)) / sphere_radius, 3.0) *
                   nook((1.0 + sphere_radius - abs(point.z)) / sphere_radius, 3.0) *
                   nook((point.y + depth + sphere_radius) / sphere_radius, 3.0);
    return sphere_color * (around + 2.0 * max(-dot(light_way, normal), 0.0) * sun);
}

/* A sky of two colours with thin clouds; below the horizon plain ground. */
vec3 sky_color(vec3 ray)
{
    float up = max(ray.y, 0.0);
    float cover = textureLod(tiles, 0.12 * ray.xz / (up + 0.25), 0.0).a * smoothstep(0.0, 0.2, ray.y);
    vec3 sky = mix(mix(sky_horizon, sky_zenith, sqrt(up)), vec3(1.0), cover);
    return mix(ground, sky, smoothstep(-0.01, 0.01, ray.y));
}

/* The colour of what a ray from the water meets; where the ray goes down, `tint` of it. `spread`: of the pixel when it
 * starts, and for each unit of its way. */
vec3 traced_color(vec3 origin, vec3 ray, vec3 tint, vec2 spread)
{
    hit found = meet(origin, ray);
    vec3 sun = sun_at(found.point), color;
    if (found.on_sphere)
        color = ball_color(found.point, found.normal, sun);
    else if (ray.y < 0.0 || found.point.y < rim)
        color = wall_color(found.point, found.normal, spread.x + spread.y * found.way, sun);
    else
        color = sky_color(ray) + sun_color * pow(max(dot(to_sun, ray), 0.0), sun_exponent);
    return ray.y < 0.0 ? color * tint : color;
}
