/* A pass of coverage_gpu.c: adds the light of every cell to the texels that its image covers, as whole numbers, so that
 * the order does not matter. */
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) buffer Light { int light[]; };
#include "light/coverage_cell.glsl"
uniform int side;     /* of the map */
uniform int cells;    /* a side of the surface */
uniform int periodic;
uniform float unit;   /* whole numbers in 1 */

/* What a cell adds to a texel, at most: sums of a few such do not turn negative. */
const float MOST = 67108864.0;

void add(image i, ivec2 texel, vec2 place)
{
    vec3 sum = light_on(i.upper, place) + light_on(i.lower, place);
    ivec3 whole = ivec3(round(min(sum * unit, MOST)));
    int at = (texel.y * side + texel.x) * 3;
    if (whole.x != 0)
        atomicAdd(light[at], whole.x);
    if (whole.y != 0)
        atomicAdd(light[at + 1], whole.y);
    if (whole.z != 0)
        atomicAdd(light[at + 2], whole.z);
}

void main()
{
    ivec2 index = ivec2(gl_GlobalInvocationID.xy);
    if (index.x >= cells || index.y >= cells)
        return;
    image i = make_image(index);
    ivec2 first = i.first, texel;
    if (periodic != 0)
        first -= side * ivec2(floor(vec2(first) / float(side)));
    texel.y = first.y;
    for (int z = 0; z < i.count.y; z++, texel.y++) {
        texel.y = periodic != 0 && texel.y == side ? 0 : texel.y;
        texel.x = first.x;
        for (int x = 0; x < i.count.x; x++, texel.x++) {
            texel.x = periodic != 0 && texel.x == side ? 0 : texel.x;
            if (min(texel.x, texel.y) >= 0 && max(texel.x, texel.y) < side)
                add(i, texel, vec2(float(x), float(z)));
        }
    }
}
