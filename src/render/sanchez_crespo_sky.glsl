/* The sky as a planar map: the texture's middle is the zenith, the circle that touches its edges the horizon. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "render/noise.glsl"
uniform vec3 zenith, horizon;
uniform float clouds; /* 0: none */
out vec4 color;

void main()
{
    vec2 place = 2.0 * target - 1.0;
    float from_zenith = min(length(place), 1.0), cover = 0.0, weight = 0.5;
    int period = 4;
    for (int layer = 0; layer < 6; layer++, period *= 2, weight *= 0.55)
        cover += weight * noise(target, period, layer);
    float cloud = clouds * smoothstep(-0.05, 0.55, cover) * (1.0 - 0.6 * from_zenith);
    vec3 clear = mix(zenith, horizon, from_zenith * from_zenith);
    color = vec4(mix(clear, vec3(1.0), cloud), 1.0);
}
#endif
