/* The passes that fill the surface's textures, a fragment a vertex: SHIFTS is the second, of choppy models alone. A
 * model's shader file includes this one and defines water() and, if it is choppy, water_shift() under SHIFTS. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
uniform vec4 constants[128]; /* the model's own */
uniform float size, spacing; /* m */
out vec4 texel;

/* Height, slope along x, slope along z at a point of the rest plane. */
vec3 water(vec2 xz);

/* How far that point moves along x and z. */
vec2 water_shift(vec2 xz);

void main()
{
    vec2 place = floor(gl_FragCoord.xy) * spacing - 0.5 * size;
#ifdef SHIFTS
    texel = vec4(water_shift(place), 0.0, 0.0);
#else
    texel = vec4(water(place), 0.0);
#endif
}
#endif
