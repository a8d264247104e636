/* The waves: the sky in a planar environment map, by as much as Fresnel's equations throw back. Seen from below, the
 * sky through the surface, or the water's own colour where that throws all light back. */
#include "render/water_mesh.glsl"

#ifdef FRAGMENT
#include "optics/refraction.glsl"
#include "render/sanchez_crespo_water.glsl"
uniform sampler2D sky;
uniform float ior;
out vec4 color;

vec3 sky_at(vec3 direction)
{
    return texture(sky, 0.5 + 0.5 * direction.xz / (1.0 + max(direction.y, 0.0))).rgb;
}

void main()
{
    vec3 up = normalize(normal), to_eye = normalize(eye - position);
    if (eye.y > position.y) {
        float cosine = max(dot(to_eye, up), 0.0);
        color = vec4(sky_at(optics_reflect(to_eye, up)), optics_fresnel_reflectance(cosine, ior));
        return;
    }
    vec3 out_of_water;
    float reflectance = 1.0;
    if (optics_refract_out(-to_eye, up, ior, out_of_water))
        reflectance = optics_fresnel_reflectance(dot(out_of_water, up), ior);
    else
        out_of_water = up;
    vec3 seen = mix(sky_at(out_of_water), water_color, reflectance);
    color = vec4(mix(water_color, seen, pow(transmittance, length_in_water(position))), 1.0);
}
#endif
