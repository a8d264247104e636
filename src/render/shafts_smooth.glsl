/* Takes the noise out of the light shafts: the mean of the texels around whose sight ends about as far off. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
uniform sampler2D shafts_texels;
out vec4 color;

void main()
{
    ivec2 middle = ivec2(gl_FragCoord.xy), last = textureSize(shafts_texels, 0) - 1;
    vec4 here = texelFetch(shafts_texels, middle, 0), sum = vec4(0.0);
    for (int j = -2; j <= 2; j++) {
        for (int i = -2; i <= 2; i++) {
            vec4 found = texelFetch(shafts_texels, clamp(middle + ivec2(i, j), ivec2(0), last), 0);
            float weight = exp(-0.25 * float(i * i + j * j)) / (1e-4 + 0.05 * here.a + abs(found.a - here.a));
            sum += weight * vec4(found.rgb, 1.0);
        }
    }
    color = vec4(sum.rgb / sum.a, here.a);
}
#endif
