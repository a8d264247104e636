/* The GPU's half of blur.c. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
uniform sampler2DArray map;
uniform int slice, width;
out vec4 blurred;

void main()
{
    ivec2 count = textureSize(map, 0).xy, texel = ivec2(gl_FragCoord.xy);
    vec4 sum = vec4(0.0);
    for (int z = -width; z < width; z++)
        for (int x = -width; x < width; x++)
            sum += texelFetch(map, ivec3((texel + ivec2(x, z) + count * width) % count, slice), 0);
    blurred = sum / float(4 * width * width);
}
#endif
