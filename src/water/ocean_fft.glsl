/* One pass of an inverse Fourier transform along one axis, for grids one below the other, two complex numbers a texel:
 * Stockham's order, radix 2 (Govindaraju et al. 2008), each result gathered from its two inputs. The first pass reads
 * the spectrum, which has half as many entries a side: those beyond are 0. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
uniform sampler2D from;
uniform int side;  /* of a grid */
uniform int axis;  /* 0: rows, 1: columns */
uniform int span;  /* length of the transforms done so far */
uniform int modes; /* not 0: `from` is the spectrum */
out vec4 texel;

vec4 entry(int grid, ivec2 place)
{
    if (modes == 0)
        return texelFetch(from, ivec2(place.x, grid * side + place.y), 0);
    ivec2 cycles = place - side * ivec2(greaterThanEqual(place, ivec2(side / 2)));
    if (any(lessThan(cycles, ivec2(-side / 4))) || any(greaterThanEqual(cycles, ivec2(side / 4))))
        return vec4(0.0);
    ivec2 mode = cycles & (side / 2 - 1);
    return texelFetch(from, ivec2(mode.x, grid * (side / 2) + mode.y), 0);
}

void main()
{
    ivec2 place = ivec2(gl_FragCoord.xy);
    int grid = place.y / side;
    place.y -= grid * side;
    int index = axis == 0 ? place.x : place.y, inside = index & (2 * span - 1);
    int first = (index - inside) / 2 + (inside & (span - 1));
    ivec2 along = axis == 0 ? ivec2(1, 0) : ivec2(0, 1);
    place -= index * along;
    vec4 a = entry(grid, place + first * along);
    vec4 b = entry(grid, place + (first + side / 2) * along);
    float angle = 3.14159265358979 * float(inside) / float(span);
    float c = cos(angle), s = sin(angle);
    texel = a + c * b + s * vec4(-b.y, b.x, -b.w, b.z);
}
#endif
