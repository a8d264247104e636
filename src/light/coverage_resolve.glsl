/* A pass of coverage_gpu.c: from whole numbers to light, leaving them zero for the next receiver. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
layout(std430, binding = 0) buffer Light { int light[]; };
uniform int side;
uniform float unit;
out vec4 color;

void main()
{
    int at = (int(gl_FragCoord.y) * side + int(gl_FragCoord.x)) * 3;
    color = vec4(vec3(light[at], light[at + 1], light[at + 2]) / unit, 1.0);
    light[at] = light[at + 1] = light[at + 2] = 0;
}
#endif
