/* A pass of wavefront_gpu.c: ratios of areas by derivatives in the fragment stage. */
#include "light/wavefront_strip.glsl"

#ifdef FRAGMENT
#include "light/wavefront_area.glsl"
in vec2 before, after;
in vec3 weight;
out vec4 color;

void main()
{
    color = vec4(weight * texel_ratio(dFdx(before), dFdy(before), dFdx(after), dFdy(after)), 1.0);
}
#endif
