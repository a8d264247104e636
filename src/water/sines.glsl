/* The GPU's twin of sines.c: height and slopes of a sum of sine waves. constants[0].x waves follow, each
 * (wave number x, wave number z, amplitude, phase). */
#include "water/evaluate.glsl"

#ifdef FRAGMENT
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
    return sum;
}
#endif
