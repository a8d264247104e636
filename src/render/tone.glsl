/* From radiance to a picture for the screen. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
uniform sampler2D radiance;
uniform vec3 exposure; /* what radiance is multiplied by */
uniform int filmic;
uniform vec2 corner; /* pixels, of what is drawn in the whole picture */
out vec4 color;

/* The contrast of the Academy's reference rendering and output transforms (ACES 1.0), channel by channel: the fit of
 * Narkowicz 2015. The transforms' own mixing of channels is left out: it makes blue skies violet. */
vec3 film(vec3 scene)
{
    return scene * (2.51 * scene + 0.03) / (scene * (2.43 * scene + 0.59) + 0.14);
}

/* The transfer function of sRGB (IEC 61966-2-1). */
vec3 encode(vec3 linear)
{
    return mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
}

/* Half a step of 8 bits up or down, so that smooth water shows no bands (interleaved gradient noise, Jimenez 2014). */
float dither()
{
    return (fract(52.9829189 * fract(dot(gl_FragCoord.xy + corner, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}

void main()
{
    vec3 scene = exposure * texelFetch(radiance, ivec2(gl_FragCoord.xy), 0).rgb;
    vec3 shown = clamp(filmic != 0 ? film(scene) : scene, 0.0, 1.0);
    color = vec4(encode(shown) + dither(), 1.0);
}
#endif
