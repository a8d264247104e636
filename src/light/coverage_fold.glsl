/* A pass of coverage_gpu.c: from the blended light with its margin to the map, which a periodic surface repeats. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
uniform sampler2D blended;
uniform int side, margin;
uniform int repeats; /* maps beside the first that the margin may hold */
out vec4 color;

void main()
{
    ivec2 count = textureSize(blended, 0), texel = ivec2(gl_FragCoord.xy) + margin;
    vec4 sum = vec4(0.0);
    for (int z = -repeats; z <= repeats; z++) {
        for (int x = -repeats; x <= repeats; x++) {
            ivec2 place = texel + ivec2(x, z) * side;
            if (min(place.x, place.y) >= 0 && place.x < count.x && place.y < count.y)
                sum += texelFetch(blended, place, 0);
        }
    }
    color = sum;
}
#endif
