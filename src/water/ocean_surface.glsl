/* The GPU's twin of ocean_surface.c: height and slopes, or under SHIFTS shifts, of the vertices. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
uniform sampler2D coefficients; /* height and shifts of a cascade a grid, or the heights of all in one */
uniform int side;               /* of a cascade's grid */
uniform int vertices, cascades, choppy;
uniform float size; /* m */
out vec4 texel;

const float FOLD = 0.1; /* as in ocean_surface.c */

/* Height, shift along x, shift along z; and their derivatives. */
struct Sum {
    vec3 value, along_x, along_z;
};

vec3 coefficient(int cascade, ivec2 place)
{
    place &= side - 1;
    if (choppy != 0)
        return texelFetch(coefficients, ivec2(place.x, cascade * side + place.y), 0).xyz;
    return vec3(texelFetch(coefficients, place, 0)[cascade], 0.0, 0.0);
}

/* Weights of the four coefficients around a point that lies u in its cell, and their derivatives a cell. */
vec4 spline(float u)
{
    float v = 1.0 - u;
    return vec4(v * v * v, 4.0 - 3.0 * u * u * (1.0 + v), 4.0 - 3.0 * v * v * (1.0 + u), u * u * u) / 6.0;
}

vec4 spline_slope(float u)
{
    float v = 1.0 - u;
    return vec4(-v * v, u * (3.0 * u - 4.0), v * (4.0 - 3.0 * v), u * u) / 2.0;
}

void add_cascade(int cascade, ivec2 vertex, inout Sum sum)
{
    int cells = side << (2 * cascade);
    ivec2 place = vertex * cells, cell = place / vertices;
    vec2 inside = vec2(place - cell * vertices) / float(vertices);
    float scale = float(cells) / size;
    vec4 weights_x = spline(inside.x), slopes_x = spline_slope(inside.x);
    vec4 weights_z = spline(inside.y), slopes_z = spline_slope(inside.y);
    for (int j = 0; j < 4; j++) {
        vec3 value = vec3(0.0), slope = vec3(0.0);
        for (int i = 0; i < 4; i++) {
            vec3 here = coefficient(cascade, cell + ivec2(i - 1, j - 1));
            value += weights_x[i] * here;
            slope += slopes_x[i] * here;
        }
        sum.value += weights_z[j] * value;
        sum.along_x += scale * weights_z[j] * slope;
        sum.along_z += scale * slopes_z[j] * value;
    }
}

void main()
{
    Sum sum = Sum(vec3(0.0), vec3(0.0), vec3(0.0));
    for (int cascade = 0; cascade < cascades; cascade++)
        add_cascade(cascade, ivec2(gl_FragCoord.xy), sum);
#ifdef SHIFTS
    texel = vec4(sum.value.yz, 0.0, 0.0);
#else
    float xx = 1.0 + sum.along_x.y, xz = sum.along_z.y, zx = sum.along_x.z, zz = 1.0 + sum.along_z.z;
    float held = max(xx * zz - xz * zx, FOLD);
    texel = vec4(sum.value.x, (zz * sum.along_x.x - zx * sum.along_z.x) / held,
                 (xx * sum.along_z.x - xz * sum.along_x.x) / held, 0.0);
#endif
}
#endif
