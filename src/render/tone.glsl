/* From radiance to a picture for the screen. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
uniform sampler2D radiance;
uniform vec3 exposure; /* what radiance is multiplied by */
uniform int filmic;
out vec4 color;

/* The film that the Academy's reference rendering transform stands for, on sRGB's primaries: a fit by Hill 2017 of the
 * transforms RRT and ODT of ACES 1.0. */
vec3 film(vec3 scene)
{
    const mat3 enter = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
    const mat3 leave = mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);
    vec3 v = enter * scene / 0.6; /* so that grey stays about as bright as it is */
    return leave * ((v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081));
}

/* The transfer function of sRGB (IEC 61966-2-1). */
vec3 encode(vec3 linear)
{
    return mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
}

/* Half a step of 8 bits up or down, so that smooth water shows no bands (interleaved gradient noise, Jimenez 2014). */
float dither()
{
    return (fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}

void main()
{
    vec3 scene = exposure * texelFetch(radiance, ivec2(gl_FragCoord.xy), 0).rgb;
    vec3 shown = clamp(filmic != 0 ? film(scene) : scene, 0.0, 1.0);
    color = vec4(encode(shown) + dither(), 1.0);
}
#endif
