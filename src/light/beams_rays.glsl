/* The first pass of beams_gpu.c: where each vertex' ray meets the receiver. */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "light/tracing.glsl"
out vec4 end; /* as struct ray_end, moved from where the vertex rests */

void main()
{
    ivec2 vertex = ivec2(gl_FragCoord.xy);
    ray_end ray = trace_ray(surface_vertex(vertex), sun);
    end = vec4(ray.moved + surface_shift(vertex), ray.flux, ray.longer);
}
#endif
