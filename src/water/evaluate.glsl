/* The pass that fills the surface's texture, a fragment a vertex. A model's shader file includes this one and defines
 * water(). */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
uniform vec4 constants[128]; /* the model's own */
uniform float size, spacing; /* m */
out vec4 texel;

/* Height, slope along x, slope along z at a point of the rest plane. */
vec3 water(vec2 xz);

void main()
{
    vec2 vertex = floor(gl_FragCoord.xy);
    texel = vec4(water(vertex * spacing - 0.5 * size), 0.0);
}
#endif
