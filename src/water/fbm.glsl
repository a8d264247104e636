/* The GPU's twin of fbm.c: height and slopes of the Fourier series; constants[0] is (A in turns, S in turns/m², F,
 * N). */
#include "water/evaluate.glsl"

#ifdef FRAGMENT
#define TURN 6.28318530718

vec3 water(vec2 xz)
{
    float phase = constants[0].x, scale = constants[0].y, amplitude = constants[0].z;
    int terms = int(constants[0].w);
    float sines = 0.0, cosines = 0.0, power = 1.0;
    for (int j = 1; j <= terms; j++) {
        power *= 2.0;
        float angle = TURN * fract(phase + power * scale * xz.x * xz.y);
        sines += sin(angle);
        cosines += cos(angle) / power;
    }
    float r = length(xz);
    float along = amplitude * TURN * scale * r * sines;
    float outwards = r > 0.0 ? amplitude * cosines / r : 0.0;
    return vec3(-amplitude * r * cosines, along * xz.yx - outwards * xz);
}
#endif
