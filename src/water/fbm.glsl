/* The GPU's twin of fbm.c; constants[0] is its series. */
#include "water/evaluate.glsl"

#ifdef FRAGMENT
#include "water/fbm_series.glsl"

vec3 water(vec2 xz)
{
    return fbm(constants[0], xz);
}
#endif
