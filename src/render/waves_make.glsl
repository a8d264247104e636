/* The surface as sight wants it: height, slopes and the square of the slopes, a texel a vertex. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "water/surface.glsl"
out vec4 color;

void main()
{
    vec3 vertex = surface_vertex(ivec2(gl_FragCoord.xy));
    color = vec4(vertex, dot(vertex.yz, vertex.yz));
}
#endif
