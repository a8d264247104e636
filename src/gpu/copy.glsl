/* Copies a picture texel by texel. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
uniform sampler2D picture;
out vec4 color;

void main()
{
    color = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
}
#endif
