/* Sand: smooth patches, finer and finer, and single grains, some dark, some bright. Repeats without a seam. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "render/noise.glsl"
uniform vec3 mean_color;
uniform float contrast;
uniform float spots; /* smallest spots across the texture */
out vec4 color;

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
