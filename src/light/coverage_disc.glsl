/* The last pass of coverage_gpu.c: smears the light of a point sun over the footprint of the sun's disc. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
uniform sampler2D sharp;
uniform vec4 taps[192]; /* x, z from the middle in texels of `sharp`, weight */
uniform int tap_count;
uniform int periodic;
out vec4 color;

void main()
{
    vec2 texel = 1.0 / vec2(textureSize(sharp, 0));
    vec3 sum = vec3(0.0);
    for (int i = 0; i < tap_count; i++) {
        vec2 place = target + taps[i].xy * texel;
        vec3 light = textureLod(sharp, place, 0.0).rgb;
        bool outside = periodic == 0 && any(greaterThan(abs(place - 0.5), vec2(0.5)));
        sum += outside ? vec3(0.0) : taps[i].z * light;
    }
    color = vec4(sum, 1.0);
}
#endif
