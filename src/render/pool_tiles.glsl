/* Glazed tiles, each a little lighter or darker than the next, clouded like marble, with pale joints between them; and,
 * in alpha, thin clouds of the sky. Repeats without a seam. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "render/noise.glsl"
uniform vec3 tile_color;
uniform float contrast;
uniform int tile_count;
out vec4 color;

/* The sum of four noises, each half as wide and as strong as the one before; about -1 to 1. */
float cloudiness(int period, int layer)
{
    float sum = 0.0, weight = 0.6;
    for (int octave = 0; octave < 4; octave++) {
        sum += weight * noise(target, period << octave, layer + octave);
        weight *= 0.6;
    }
    return sum;
}

void main()
{
    vec2 place = target * float(tile_count), inside = abs(fract(place) - 0.5);
    float joint = smoothstep(0.44, 0.48, max(inside.x, inside.y)); /* 0 on the tile, 1 between tiles */
    float shade = random(ivec2(place), tile_count, 0) - 0.5;
    float brightness = 1.0 + contrast * (0.1 * shade + 0.12 * cloudiness(4, 1));
    vec3 glaze = tile_color * brightness, mortar = mix(tile_color, vec3(1.0), 0.75);
    color = vec4(clamp(mix(glaze, mortar, joint), 0.0, 1.0), smoothstep(0.0, 0.9, cloudiness(3, 8)) * 0.8);
}
#endif
