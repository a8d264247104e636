/* Blends a sample of the picture into the mean of those before it. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
uniform sampler2D radiance;
uniform float share; /* of the new sample */
out vec4 color;

void main()
{
    vec3 sampled = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0).rgb;
    color = vec4(min(sampled, vec3(60000.0)), share); /* a half float ends at 65504 */
}
#endif
