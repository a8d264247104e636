/* Sand: smooth patches, finer and finer, and single grains, some dark, some bright. Repeats without a seam. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
uniform vec3 mean_color;
uniform float contrast;
uniform float spots; /* smallest spots across the texture */
uniform int seed;
out vec4 color;

/* A number from 0 to 1 for each cell of a grid that repeats after `period` cells (integer hash by multiplication and
 * shift, PCG: O'Neill 2014; Jarzynski & Olano 2020). */
float random(ivec2 cell, int period, int layer)
{
    ivec2 place = (cell % period + period) % period;
    uint state = uint(place.x) * 1664525u + uint(place.y) * 22695477u + uint(layer * 7919 + seed) * 747796405u;
    state = state * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return float((word >> 22u) ^ word) / 4294967295.0;
}

/* Smooth noise of `period` cells across the texture, -1 to 1. */
float noise(vec2 place, int period, int layer)
{
    vec2 scaled = place * float(period), cell = floor(scaled), inside = scaled - cell;
    ivec2 corner = ivec2(cell);
    vec2 blend = inside * inside * (3.0 - 2.0 * inside);
    float near = mix(random(corner, period, layer), random(corner + ivec2(1, 0), period, layer), blend.x);
    float far = mix(random(corner + ivec2(0, 1), period, layer), random(corner + ivec2(1, 1), period, layer), blend.x);
    return 2.0 * mix(near, far, blend.y) - 1.0;
}

void main()
{
    int finest = max(int(spots), 2);
    float patches = 0.0, weight = 0.018;
    int period = max(finest / 64, 2);
    for (int layer = 0; layer < 5; layer++) {
        patches += weight * noise(target, period, layer);
        period *= 2;
        weight *= 1.1;
    }
    float grain = noise(target, finest * 2, 6);
    float speck = random(ivec2(target * float(finest)), finest, 7);
    float dark = smoothstep(0.965, 1.0, speck), bright = smoothstep(0.035, 0.0, speck);
    float brightness = 1.0 + contrast * (patches + 0.06 * grain - 0.10 * dark + 0.08 * bright);
    vec3 warmth = vec3(1.0, 1.0 - 0.02 * patches, 1.0 - 0.06 * patches);
    color = vec4(clamp(mean_color * brightness * warmth, 0.0, 1.0), 1.0);
}
#endif
