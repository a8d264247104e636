/* The GPU's half of hemisphere.c; the steps are numbered as there. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "light/tracing.glsl"
uniform vec3 corner;              /* m, the map's, as x, z */
uniform vec3 axis, across, along; /* of the cone */
uniform float cap;                /* 1 less the cosine of its half angle */
uniform float lamp_square;        /* of the distance of unit vectors to the middle and the edge of the lamp */
uniform float near_square;        /* m² */
uniform int candidates, seed;
uniform vec3 scale;               /* from the sum to units of flat water */
out vec4 color;

const int MEETINGS = 4;
const float LEVELEST = 1e-3, FACING_LEAST = 0.25;

/* Step 1. */
vec3 choose_direction(vec2 numbers)
{
    float turn = 6.28318530718 * numbers.y, wide = sqrt(cap * (2.0 - numbers.x * cap) * numbers.x);
    return (1.0 - numbers.x * cap) * axis + wide * (cos(turn) * across + sin(turn) * along);
}

/* Step 2. */
bool meet(vec2 from, vec3 direction, out vec3 water)
{
    vec2 run = direction.xz / direction.y, place = from - run * receiver;
    float facing = 1.0;
    for (int look = 0; look < MEETINGS; look++) {
        vec2 inside = place / surface_size + 0.5;
        if (surface_periodic != 0)
            inside -= floor(inside);
        else if (any(greaterThan(abs(inside - 0.5), vec2(0.5))))
            return false;
        water_point point = find_water(inside);
        water = point.water;
        vec2 off = from + run * (water.x - receiver) - place - point.shift;
        facing = 1.0 - dot(run, water.yz);
        if (dot(off, off) < near_square)
            break;
        place += off + run * (dot(off, water.yz) / max(facing, FACING_LEAST));
    }
    return facing > 0.0;
}

/* Steps 3 and 4. */
vec3 find_light(vec3 water, vec3 direction)
{
    vec3 normal = normalize(vec3(-water.y, 1.0, -water.z));
    bool up = receiver > 0.0;
    float cosine = dot(direction, normal);
    if (!up && 1.0 / (ior * ior) - 1.0 + cosine * cosine <= 0.0)
        return vec3(0.0);
    vec3 air = up ? optics_reflect(-direction, normal) : optics_refract(-direction, -normal, 1.0 / ior);
    vec3 apart = air - sun;
    if (dot(apart, apart) > lamp_square || air.y <= 0.0)
        return vec3(0.0);
    float reflectance = optics_fresnel_reflectance(min(dot(air, normal), 1.0), ior);
    float share = up ? reflectance : (1.0 - reflectance) * ior * ior;
    float longer = abs(water.x - receiver) / abs(direction.y) - flat_water.z;
    return abs(direction.y) * share * dot(air, sun) * optics_transmittance(absorption, longer);
}

void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec2 from = corner.xy + gl_FragCoord.xy / texels_a_meter;
    uvec2 bits = mix_bits(uvec4(uvec2(texel), uint(seed), 1u)).xy & 0xffffff00u;
    vec3 sum = vec3(0.0), water;
    for (int k = 0; k < candidates; k++) {
        vec3 direction = choose_direction(unit(uvec4(bits, 0u, 0u)).xy);
        float towards_water = receiver > 0.0 ? -direction.y : direction.y;
        if (towards_water > LEVELEST && meet(from, direction, water))
            sum += find_light(water, direction);
        bits += uvec2(3242174889u, 2447445414u);
    }
    color = vec4(sum * scale * channels, 0.0);
}
#endif
