/* The GPU's twin of sines.c: height and slopes of a sum of waves. constants[0] is (number of waves, 1 where they are
 * choppy); each wave is (wave number x, wave number z, amplitude, phase); then s / k² of all. */
#include "water/evaluate.glsl"

#ifdef FRAGMENT
#define WAVES_MAX 64
#define AREA_MIN 1e-4

float wave_curl(int wave)
{
    return constants[1 + WAVES_MAX + wave / 4][wave % 4];
}

/* Slopes over the points at rest become those of the surface where the points are now. */
vec2 moved_slopes(vec2 xz, vec2 slopes)
{
    float xx = 0.0, both = 0.0, zz = 0.0;
    int count = int(constants[0].x);
    for (int w = 0; w < count; w++) {
        vec4 wave = constants[w + 1];
        float stretch = wave_curl(w) * cos(dot(wave.xy, xz) + wave.w);
        xx += stretch * wave.x * wave.x;
        both += stretch * wave.x * wave.y;
        zz += stretch * wave.y * wave.y;
    }
    float area = (1.0 - xx) * (1.0 - zz) - both * both;
    return (vec2(1.0 - zz, 1.0 - xx) * slopes + both * slopes.yx) / max(area, AREA_MIN);
}

vec3 water(vec2 xz)
{
    vec3 sum = vec3(0.0);
    int count = int(constants[0].x);
    for (int w = 1; w <= count; w++) {
        vec4 wave = constants[w];
        float angle = dot(wave.xy, xz) + wave.w;
        float sine = sin(angle);
        sum += wave.z * vec3(cos(angle), -wave.x * sine, -wave.y * sine);
    }
    if (constants[0].y > 0.0)
        sum.yz = moved_slopes(xz, sum.yz);
    return sum;
}

vec2 water_shift(vec2 xz)
{
    vec2 shift = vec2(0.0);
    int count = int(constants[0].x);
    for (int w = 0; w < count; w++) {
        vec4 wave = constants[w + 1];
        shift -= wave_curl(w) * wave.xy * sin(dot(wave.xy, xz) + wave.w);
    }
    return shift;
}
#endif
