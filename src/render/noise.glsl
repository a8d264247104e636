/* Numbers that look random and repeat without a seam. */
uniform int seed;

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
