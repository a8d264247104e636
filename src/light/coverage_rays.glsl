/* The first pass of coverage_gpu.c: every vertex of the surface bends the light from the middle of the sun, whatever
 * the number of receivers. What leaves height h meets the receiver at height y after moving (u, v) (y - h). */
#include "gpu/screen.glsl"

#ifdef FRAGMENT
#include "optics/refraction.glsl"
#include "water/surface.glsl"
uniform vec3 sun;            /* unit vector towards its middle */
uniform float ior;
uniform int upwards;         /* light that is thrown back, not let in */
uniform vec4 flat_water;     /* u, v; what follows is 1 / (sun.y × share of the light that goes on) */
out vec4 ray;                /* u and v less those of flat water, height, flux in units of flat water's */

void main()
{
    vec3 vertex = surface_vertex(ivec2(gl_FragCoord.xy));
    vec3 slanted = vec3(-vertex.y, 1.0, -vertex.z);
    float facing = dot(sun, slanted);
    vec3 normal = normalize(slanted);
    float cosine = max(dot(sun, normal), 1e-6); /* not 0 / 0 where the index is 1 */
    vec3 direction = upwards != 0 ? optics_reflect(sun, normal) : optics_refract(sun, normal, ior);
    float reflectance = optics_fresnel_reflectance(cosine, ior);
    bool arrives = facing > 0.0 && (upwards != 0 ? direction.y > 1e-3 : direction.y < -1e-3);
    float share = upwards != 0 ? reflectance : 1.0 - reflectance;
    ray = vec4(0.0, 0.0, vertex.x, 0.0);
    if (arrives)
        ray = vec4(direction.xz / direction.y - flat_water.xy, vertex.x, facing * share * flat_water.z);
}
#endif
